// Drift: how far D's offsets and the sites' places come apart over many moves without a restart point,
// and with one every 100. Arguments: MESH SITES ITERATIONS; prints a table.
#include <cstdlib>
#include <memory>

#include <fmt/core.h>

#include "conformal/uniformize.h"
#include "cvt/consistency.h"
#include "cvt/initial_sites.h"
#include "cvt/tessellation.h"
#include "result/cell_complex.h"
#include "result/density.h"

namespace {

using namespace ucvt;

/// Every site goes to a fifth of its spacing off its centroid, in a direction that turns.
void wander(Tessellation& sites, std::vector<CellState>& cells, int iteration) {
  sites.measure(cells);
  std::vector<Offset> target;
  for (const CellState& cell : cells) {
    const Offset c = centroid(sites.space(), cell.moments);
    const double turn = 0.7 * iteration;
    target.push_back(from_central(sites.space(), c.x + 0.2 * cell.spacing * std::cos(turn),
                                  c.y + 0.2 * cell.spacing * std::sin(turn)));
  }
  sites.move(target);
}

void tell(int iteration, const UniformSurface& t, const Tessellation& sites) {
  const auto complex = cell_complex(sites);
  const Consistency c = measure_consistency(t, complex->delaunay, complex->places);
  fmt::print("{:>9}  {:.2e}  {:.2e}  {:.2e}\n", iteration, c.angle_sum_rad, c.circle, c.place);
}

void run(const Uniformized& t, std::size_t n, int iterations, int leg) {
  fmt::print("restart points every {} iterations\niteration  angles    circle    place\n", leg);
  const SurfaceMass mass(t.surface, conformal_factor(t));
  auto sites =
      std::make_unique<Tessellation>(mass, random_sites(t.surface, t.vertex_area_3d, n, 1));
  std::vector<CellState> cells;
  for (int i = 1; i <= iterations; ++i) {
    wander(*sites, cells, i);
    if (i % (iterations / 10) == 0) {
      tell(i, t.surface, *sites);
    }
    if (i % leg == 0) {
      sites = std::make_unique<Tessellation>(mass, sites->sites());
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: ucvt_bench_drift MESH SITES ITERATIONS\n");
    return 2;
  }
  const ClosedSurface surface = closed_surface(read_mesh(argv[1]));
  const Uniformized t = uniformize_surface(surface, {});
  const auto n = static_cast<std::size_t>(std::atoi(argv[2]));
  const int iterations = std::atoi(argv[3]);
  run(t, n, iterations, iterations + 1);
  run(t, n, iterations, 100);
  return 0;
}
