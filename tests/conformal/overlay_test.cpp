#include "conformal/overlay.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "conformal/uniformize.h"
#include "oracle/meshes.h"

namespace ucvt {
namespace {

/// The dual of T: a node in every face, a curve over every edge; it separates the edge's two ends.
CurveNetwork dual_network(const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  CurveNetwork out;
  out.ends.resize(c.face_count());
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    out.nodes.push_back({{static_cast<std::int32_t>(f)}, {0.5, 0.3, 0.2}});
  }
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)}, twin = c.twin(h);
    if (c.is_canonical(h)) {
      const auto n = static_cast<std::int32_t>(out.curves.size());
      out.ends[h.face().index()][i % 3] = 2 * n;
      out.ends[twin.face().index()][static_cast<std::size_t>(twin.id % 3)] = 2 * n + 1;
      out.curves.push_back({c.head(h).id, c.origin(h).id, {{h, 0.4, 0.6}}});
    }
  }
  return out;
}

struct Case {
  const char* name;
  TriangleMesh mesh;
  double longest_edge;
};

class OverlayTest : public testing::TestWithParam<Case> {};

std::size_t euclidean_changes(const Uniformized& t) {
  return static_cast<std::size_t>(t.intrinsic.euclidean_flips + t.intrinsic.splits);
}

TEST_P(OverlayTest, RegionsFillEveryFaceOfTheInput) {
  const Uniformized t =
      uniformize_surface(oracle::closed(GetParam().mesh), {GetParam().longest_edge, {}});
  Overlay overlay(t.surface.connectivity(), dual_network(t));
  ASSERT_TRUE(overlay.is_embedded(t.surface.connectivity().euler_number()));
  overlay.undo(t.intrinsic.log, euclidean_changes(t));
  EXPECT_TRUE(overlay.is_embedded(t.surface.connectivity().euler_number()));
  std::vector<Overlay::Region> regions;
  for (std::size_t f = 0; f < t.input.faces.size(); ++f) {
    overlay.regions_of({static_cast<std::int32_t>(f)}, regions);
    double total = 0;
    for (const auto& region : regions) {
      EXPECT_GE(region.label, 0) << "every cell of the dual is small";
      double area = 0;
      for (std::size_t n = 0; n < region.corners.size(); ++n) {
        const auto &a = region.corners[n].bary,
                   &b = region.corners[(n + 1) % region.corners.size()].bary;
        area += a[1] * b[2] - a[2] * b[1];
        EXPECT_GE(*std::min_element(a.begin(), a.end()), 0);
        EXPECT_NEAR(a[0] + a[1] + a[2], 1, 1e-14);
      }
      EXPECT_GT(area, -1e-12) << "regions run counterclockwise";
      total += area;
    }
    EXPECT_NEAR(total, 1, 1e-12);
  }
}

TEST_P(OverlayTest, NodesLieWhereTheLogPutsPoints) {
  const Uniformized t =
      uniformize_surface(oracle::closed(GetParam().mesh), {GetParam().longest_edge, {}});
  const CurveNetwork network = dual_network(t);
  std::vector<HomogeneousPoint> wanted = network.nodes;
  t.intrinsic.log.undo(wanted);
  Overlay overlay(t.surface.connectivity(), network);
  overlay.undo(t.intrinsic.log, euclidean_changes(t));
  const auto first = static_cast<std::int32_t>(t.surface.connectivity().vertex_count());
  std::vector<Overlay::Region> regions;
  std::size_t met = 0;
  for (std::size_t f = 0; f < t.input.faces.size(); ++f) {
    overlay.regions_of({static_cast<std::int32_t>(f)}, regions);
    for (const auto& region : regions) {
      for (const auto& corner : region.corners) {
        const std::int32_t n = corner.node.id - first;
        if (n < 0 || n >= static_cast<std::int32_t>(wanted.size())) {
          continue;
        }
        const HomogeneousPoint& p = wanted[static_cast<std::size_t>(n)];
        ++met;
        ASSERT_EQ(p.face.index(), f);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(corner.bary[k], p.weight[k], 1e-11);
        }
      }
    }
  }
  EXPECT_EQ(met, 3 * wanted.size()) << "three regions round each";
}

/// Distance of a point of a face from the nearest side of the face's regions, in barycentric terms.
double distance_to_sides(const std::vector<Overlay::Region>& regions,
                         const std::array<double, 3>& p) {
  double least = HUGE_VAL;
  for (const auto& region : regions) {
    for (std::size_t n = 0; n < region.corners.size(); ++n) {
      const auto &a = region.corners[n].bary,
                 &b = region.corners[(n + 1) % region.corners.size()].bary;
      double along = 0, length2 = 0, distance2 = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        along += (p[k] - a[k]) * (b[k] - a[k]), length2 += (b[k] - a[k]) * (b[k] - a[k]);
      }
      const double s = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = a[k] + s * (b[k] - a[k]) - p[k];
        distance2 += d * d;
      }
      least = std::min(least, std::sqrt(distance2));
    }
  }
  return least;
}

TEST_P(OverlayTest, CurvesPassWhereTheLogPutsTheirPoints) {
  const Uniformized t =
      uniformize_surface(oracle::closed(GetParam().mesh), {GetParam().longest_edge, {}});
  const CurveNetwork network = dual_network(t);
  std::vector<HomogeneousPoint> on_curves;
  for (const Curve& curve : network.curves) {
    const Halfedge h = curve.crossings[0].side;
    for (const double s : {0.3, 0.6, 1.0}) {
      HomogeneousPoint p = network.nodes[h.face().index()];
      for (double& w : p.weight) {
        w *= 1 - s;
      }
      p.weight[static_cast<std::size_t>(h.id % 3)] += s * curve.crossings[0].at_origin;
      p.weight[static_cast<std::size_t>(h.next().id % 3)] += s * curve.crossings[0].at_head;
      on_curves.push_back(p);
    }
  }
  t.intrinsic.log.undo(on_curves);
  Overlay overlay(t.surface.connectivity(), network);
  overlay.undo(t.intrinsic.log, euclidean_changes(t));
  std::vector<std::vector<Overlay::Region>> regions(t.input.faces.size());
  for (std::size_t f = 0; f < regions.size(); ++f) {
    overlay.regions_of({static_cast<std::int32_t>(f)}, regions[f]);
  }
  for (const HomogeneousPoint& p : on_curves) {
    EXPECT_LT(distance_to_sides(regions[p.face.index()], p.weight), 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, OverlayTest,
    testing::Values(Case{"sphere", oracle::icosphere(2), 0}, Case{"cube", oracle::cube(), 0.2},
                    Case{"torus", oracle::grid_torus(16, 10), 0},
                    Case{"bumpy_torus", oracle::bumpy(oracle::grid_torus(16, 10), 0.1, 1), 0.2},
                    Case{"seven_vertex_torus", oracle::seven_vertex_torus(), 0.3},
                    Case{"double_torus", oracle::voxel_frame(2), 0.4}),
    [](const auto& name) { return std::string(name.param.name); });

TEST(Overlay, SaysWhenCurvesCross) {
  const Uniformized t = uniformize_surface(oracle::closed(oracle::icosphere(1)), {});
  CurveNetwork network = dual_network(t);
  std::swap(network.ends[0][0], network.ends[0][1]);
  const Overlay turned(t.surface.connectivity(), network);
  EXPECT_FALSE(turned.is_embedded(2)) << "a node's curves in the wrong order";
}

}  // namespace
}  // namespace ucvt
