// Where the sites of a surface start: at random, or level by level from a CVT of few sites.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cvt/tessellation.h"
#include "cvt/thinned_surface.h"
#include "ucvt/remesh.h"

namespace ucvt {

/// How thin T is made for the levels of a start with so many sites; for `thin_out`.
std::vector<std::size_t> thinned_counts(const UniformSurface& t, int sites);

/// True unless some face of D would have to be more than a hemisphere.
bool covers_surface(const Tessellation& sites);

/// Random sites by weight of T's vertices, from the first of some seeds for which they do not lie in one
/// hemisphere. Throws NumericalError when there is none.
std::unique_ptr<Tessellation> random_tessellation(const SurfaceMass& mass,
                                                  const std::vector<double>& weight, int n,
                                                  std::uint64_t seed,
                                                  const ThinnedSurface* base = nullptr);

/// What a multilevel start needs to know of T.
struct StartSurface {
  const SurfaceMass& mass;
  const std::vector<double>& weight;           ///< of T's vertices, for random sites
  const std::vector<ThinnedSurface>& thinned;  ///< by `thinned_counts`
};

/// A small CVT from random sites, then from level to level sites at the middles of all edges of D, as
/// many as lead to the number asked for: its few defects are all there are in the end. Returns the sites
/// of the last level, not optimised. Throws Cancelled when the monitor said so.
std::vector<SurfacePoint> multilevel_start(const StartSurface& surface, int sites,
                                           std::uint64_t seed, Method method,
                                           const Monitor& monitor);

}  // namespace ucvt
