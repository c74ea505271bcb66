// Uniformization: T, the discretely conformal surface of constant curvature.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "ucvt/mesh.h"

namespace ucvt {

/// Where a computation stands, as told to a Monitor.
struct Progress {
  const char* stage = "";  ///< "uniformize" or "optimize"
  int iteration = 0;
  double residual = 0;  ///< largest angle error in radians, or largest relative move
};

/// Called after every iteration; returning false asks the computation to stop at the next safe
/// point, which is then reported by the exception Cancelled.
using Monitor = std::function<bool(const Progress&)>;

/// What uniformization found; angles in radians, area in the uniform metric.
struct UniformizationReport {
  std::string geometry;                  ///< "spherical", "euclidean" or "hyperbolic"
  std::int64_t vertices = 0, faces = 0;  ///< of T
  int genus = 0;
  int newton_iterations = 0;
  std::int64_t euclidean_flips = 0;
  std::int64_t ptolemy_flips = 0;
  std::int64_t refined_vertices = 0;  ///< added to the input's
  double max_angle_error = 0;
  double area = 0;
  double log_scale_min = 0;
  double log_scale_max = 0;
  double seconds = 0;
};

struct Uniformized;

/// A uniformized surface; a cheap handle on an immutable value.
class UniformizedSurface {
 public:
  explicit UniformizedSurface(std::shared_ptr<const Uniformized> value);

  [[nodiscard]] const UniformizationReport& report() const;

  /// Writes T as PLY (docs/formats.md): positions and log scales, corners, chords, gluing, layout.
  /// "-" is standard output. Throws IoError; the file appears whole or not at all.
  void write(const std::string& path) const;

  /// For the library's own use.
  [[nodiscard]] const Uniformized& value() const { return *value_; }

 private:
  std::shared_ptr<const Uniformized> value_;
};

struct UniformizeOptions {
  double longest_edge = 0;  ///< input units; > 0: refine the surface until no edge is longer
  Monitor monitor;
};

/// Uniformizes a closed surface: geometry by its genus, every angle sum 2 pi to 1e-10, certified.
///
/// Never fails for the surface's shape by design; throws NumericalError when doubles do not suffice,
/// InvalidInput when all vertices coincide, Cancelled when the monitor said so. Source: the
/// references in docs/uniformization.md.
UniformizedSurface uniformize(const ClosedSurface& surface, const UniformizeOptions& options = {});

/// Uniformizes the double of a surface with boundary: itself and its mirror image, glued along the boundary,
/// of genus 2 g + b - 1 for b loops. The boundary becomes geodesics, the lines of T's mirror symmetry.
///
/// The surface's vertices come first and in their order, then middles of edges inside it that join two
/// boundary vertices (of all edges that are too long, when it is refined), then mirror images. Throws as
/// for closed surfaces. Source: docs/boundaries.md.
UniformizedSurface uniformize(const OpenSurface& surface, const UniformizeOptions& options = {});

}  // namespace ucvt
