// Moments of a density over one triangle, in each of the three spaces and at several sizes.
#include "space/moments.h"

#include <array>
#include <cmath>

#include <benchmark/benchmark.h>

namespace ucvt {
namespace {

/// A triangle of the given size about the origin.
std::array<Offset, 3> corners(Space s, double size) {
  return {from_central(s, size, 0), from_central(s, -0.4 * size, 0.8 * size),
          from_central(s, -0.6 * size, -0.7 * size)};
}

/// Arguments: kappa, and minus the decimal logarithm of the triangle's size.
void triangle_moments(benchmark::State& state) {
  const Space s{static_cast<double>(state.range(0))};
  const auto p = corners(s, 0.5 * std::pow(10.0, -static_cast<double>(state.range(1))));
  ChordTriangle t;
  for (std::size_t i = 0; i < 3; ++i) {
    t.chord2[i] = chord2(s, p[i], p[(i + 1) % 3]);
  }
  t.det = orientation(s, p[0], p[1], p[2]);
  for (auto _ : state) {
    benchmark::DoNotOptimize(integrate(s, t, {1.0, 2.0, 3.0}));
  }
}
BENCHMARK(triangle_moments)->ArgsProduct({{1, 0, -1}, {0, 1, 2}})->ArgNames({"kappa", "digits"});

}  // namespace
}  // namespace ucvt
