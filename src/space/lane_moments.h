// Nodes of a quadrature four at a time: of one triangle, or one node of four triangles.
#pragma once

#include <array>

namespace ucvt {

/// Four numbers that are worked on at once, in one or two registers.
using Lanes [[gnu::vector_size(32)]] = double;

/// A function compiled for wide registers too, where the compiler can choose at run time; no
/// operation is fused, so that the bits are the same. Not for ThreadSanitizer, which is not there yet
/// when the choice is made, before the program starts.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define UCVT_WIDE [[gnu::target_clones("avx2", "default")]]
#else
#define UCVT_WIDE
#endif

/// Terms of the power series that end at rounding for triangles whose squared sides are all below the
/// bounds (f <= side^2/3).
constexpr int short_series = 4, long_series = 8;
constexpr double short_series_side2 = 6e-4, long_series_side2 = 2e-2;

/// The first coefficients of the power series in f of w^4 and w^4 / (1 + 1/w) (of the excess),
/// w = (1 - f)^(-1/2).
struct SeriesTerm {
  double w4, excess;
};
constexpr std::array<SeriesTerm, long_series> moment_series{{{1, 1.0 / 2},
                                                             {2, 9.0 / 8},
                                                             {3, 29.0 / 16},
                                                             {4, 325.0 / 128},
                                                             {5, 843.0 / 256},
                                                             {6, 4165.0 / 1024},
                                                             {7, 9949.0 / 2048},
                                                             {8, 185517.0 / 32768}}};

/// `Weights` by lanes.
struct LaneWeights {
  Lanes mu0{}, mu1{}, mu2{}, excess{};
};

/// Adds nodes at barycentric coordinates l of triangles with squared chords c and corner densities
/// rho, `area` being the node's part of the triangle's determinant. No root, no division.
template <int terms>
[[gnu::always_inline]] inline void add_nodes(double kappa, const std::array<Lanes, 3>& c,
                                             const std::array<Lanes, 3>& rho,
                                             const std::array<Lanes, 3>& l, const Lanes& area,
                                             LaneWeights& out) {
  const Lanes form = l[0] * l[1] * c[0] + l[1] * l[2] * c[1] + l[2] * l[0] * c[2];
  const Lanes f = kappa * form;
  const Lanes dm = area * (l[0] * rho[0] + l[1] * rho[1] + l[2] * rho[2]);
  Lanes w4 = moment_series[terms - 1].w4 + Lanes{};
  Lanes e = moment_series[terms - 1].excess + Lanes{};
  for (std::size_t k = terms - 1; k-- > 0;) {
    w4 = moment_series[k].w4 + f * w4;
    e = moment_series[k].excess + f * e;
  }
  const Lanes mu = dm * w4;
  out.mu0 += mu * l[0];
  out.mu1 += mu * l[1];
  out.mu2 += mu * l[2];
  out.excess -= dm * e * form;
}

}  // namespace ucvt
