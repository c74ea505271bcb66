// The steps of a tessellation on a uniformized torus: developing, cells, changes of
// the Delaunay triangulation, and a whole iteration of Lloyd's method.
#include "cvt/tessellation.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "conformal/uniformize.h"
#include "cvt/initial_sites.h"
#include "cvt/surface_mass.h"

namespace ucvt {
namespace {

/// A torus with waves, so that no vertices are cocircular or collinear by symmetry.
TriangleMesh torus(int n, int m) {
  TriangleMesh out;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      const double tube = 0.4 + 0.05 * std::sin(3 * a + b), r = 1 + tube * std::cos(b);
      out.positions.push_back({r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
      const int i1 = (i + 1) % n, j1 = (j + 1) % m;
      out.faces.push_back({i * m + j, i1 * m + j, i1 * m + j1});
      out.faces.push_back({i * m + j, i1 * m + j1, i * m + j1});
    }
  }
  return out;
}

/// 9000 vertices; made once.
const Uniformized& surface() {
  static const Uniformized t = uniformize_surface(closed_surface(torus(150, 60)), {});
  return t;
}

const SurfaceMass& mass() {
  static const SurfaceMass out(
      surface().surface, std::vector<double>(surface().surface.connectivity().vertex_count(), 1.0));
  return out;
}

Tessellation tessellation(std::int64_t sites) {
  return {mass(), random_sites(surface().surface, surface().vertex_area_3d,
                               static_cast<std::size_t>(sites), 1)};
}

Vertex vertex(std::size_t i) {
  return {static_cast<std::int32_t>(i)};
}

/// Develops the same face across its sides in turn.
void develop(benchmark::State& state) {
  const UniformSurface& t = surface().surface;
  const Place place = place_of(t, {Face{0}});
  std::size_t side = 0;
  for (auto _ : state) {
    const std::size_t next = (side + 1) % 3;
    benchmark::DoNotOptimize(
        t.develop(halfedges(place.face)[side], place.corner[side], place.corner[next]));
    side = next;
  }
}
BENCHMARK(develop);

/// Moments of all cells, on one thread; one item is one cell.
void cells(benchmark::State& state) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const Tessellation sites = tessellation(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(sites.cell_moments());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(cells)->Arg(100)->Arg(1000)->ArgName("sites");

/// A third of the way from v to the two next corners of one of its faces.
Offset inside_a_face(const DelaunayTriangulation& d, Vertex v) {
  const Halfedge h = d.connectivity().outgoing(v);
  const Offset &a = d.offset(h), &b = d.offset(d.connectivity().rotate(h));
  return from_central(d.space(), (a.x + b.x) / 3, (a.y + b.y) / 3);
}

void insert_and_remove(benchmark::State& state) {
  DelaunayTriangulation d = tessellation(1000).delaunay();
  Vertex last;
  std::size_t i = 0;
  for (auto _ : state) {
    const Vertex v = vertex(i);
    last = d.insert(v, {inside_a_face(d, v), {}}, last);
    d.remove(last);
    i = (i + 1) % 1000;
  }
}
BENCHMARK(insert_and_remove);

/// Moves every site by up to a tenth of an edge, then flips back to Delaunay.
void move_and_flip(benchmark::State& state) {
  DelaunayTriangulation d = tessellation(1000).delaunay();
  std::mt19937_64 random(1);
  std::int64_t flips = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < d.vertex_count(); ++i) {
      const Offset& to = d.offset(d.connectivity().outgoing(vertex(i)));
      const double part = 0.1 * static_cast<double>(random() % 1024) / 1024;
      d.move_in_star(vertex(i), from_central(d.space(), part * to.x, part * to.y));
    }
    flips += d.make_delaunay();
  }
  state.SetItemsProcessed(state.iterations() * 1000);
  state.counters["flips"] =
      benchmark::Counter(static_cast<double>(flips), benchmark::Counter::kAvgIterations);
}
BENCHMARK(move_and_flip)->Unit(benchmark::kMicrosecond);

/// On all cores.
void lloyd_iteration(benchmark::State& state) {
  Tessellation sites = tessellation(state.range(0));
  for (auto _ : state) {
    optimize(sites, {Method::Lloyd, 1, 0}, {});
  }
}
BENCHMARK(lloyd_iteration)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(5000)
    ->ArgName("sites")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace ucvt
