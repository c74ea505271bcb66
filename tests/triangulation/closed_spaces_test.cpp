#include "triangulation/closed_spaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "cvt/domain.h"
#include "oracle/generators.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

double gap(const Offset& a) {
  return std::sqrt(2 * a.h);
}

/// The worst distance, in the model, from where offsets put the heads of halfedges to their frames'
/// places up to a deck transformation.
double worst_misplacement(const SpaceTriangulation& s, const Domain& domain) {
  const Connectivity& c = s.triangulation.connectivity();
  double worst = 0;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const Frame& head = s.frame[c.head(h).index()];
    const ModelPoint seen = model_point(s.frame[c.origin(h).index()], s.triangulation.offset(h));
    const ModelPoint p = into_polygon(domain, seen);
    // The corners of the fundamental polygon are one point.
    double least = gap(offset_in(head, p));
    for (const ModelPoint& corner : model_corners(domain)) {
      if (domain.genus > 1 && c.head(h).id == 1) {
        least = std::min(least, gap(offset_in(frame_at(domain.kappa, corner), p)));
      }
    }
    worst = std::max(worst, least);
  }
  return worst;
}

/// Area, Euler number, Delaunay, ends that agree, frames that fit.
void expect_sound(const Domain& domain, std::size_t vertices, double tolerance) {
  SpaceTriangulation s = triangulate_closed(domain);
  DelaunayTriangulation& d = s.triangulation;
  const Connectivity& c = d.connectivity();
  EXPECT_EQ(d.vertex_count(), vertices);
  ASSERT_EQ(s.frame.size(), vertices);
  EXPECT_EQ(c.euler_number(), 2 - 2 * domain.genus);
  EXPECT_NEAR(d.area(), domain.area, tolerance * domain.area);
  EXPECT_EQ(d.make_delaunay(), 0);
  // The model resolves places this well at the greatest distance between two corners.
  double far = 1;
  for (const ModelPoint& p : model_corners(domain)) {
    far = std::max(far, 2 * p[2] * p[2] - 1);
  }
  EXPECT_LT(worst_misplacement(s, domain),
            std::sqrt(domain.area) * std::max(tolerance, 1e-13 * far * far));
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const Offset apex = d.offset(c.rotate(h));
    const Offset through = d.frame_change(h).apply(d.space(), d.offset(h.next()));
    EXPECT_LT(std::hypot(apex.x - through.x, apex.y - through.y),
              tolerance * (gap(apex) + gap(d.offset(h))) * (1 + std::abs(apex.h)));
  }
}

TEST(ClosedSpaces, Sphere) {
  expect_sound(sphere_domain(), 6, 1e-14);
}

TEST(ClosedSpaces, Torus) {
  for (const auto& [a, b] :
       std::vector<std::pair<CentralPoint, CentralPoint>>{{{1, 0}, {0, 1}},
                                                          {{1, 0}, {0.5, std::sqrt(0.75)}},
                                                          {{1, 0}, {-0.5, std::sqrt(0.75)}},
                                                          {{3e-6, 1e-6}, {1e-6, -2e-6}},
                                                          {{1, 0}, {1000.3, 0.7}},
                                                          {{1, 0}, {0, 50}}}) {
    expect_sound(torus_domain(a, b), 1, 1e-13);
  }
}

RC_GTEST_PROP(ClosedSpacesTest, TorusOfAnyLattice, ()) {
  const CentralPoint a{oracle::number(-3, 3), oracle::number(-3, 3)};
  const CentralPoint b{oracle::number(-3, 3), oracle::number(-3, 3)};
  RC_PRE(std::abs(a[0] * b[1] - a[1] * b[0]) > 1e-3);
  // The area of a thin parallelogram has the digits that its longer diagonal leaves it.
  const Domain domain = torus_domain(a, b);
  const double size = a[0] * a[0] + a[1] * a[1] + b[0] * b[0] + b[1] * b[1];
  expect_sound(domain, 1, 1e-14 * std::max(100.0, size / domain.area));
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(ClosedSpaces, Surfaces) {
  for (const SidePairing pairing : {SidePairing::Opposite, SidePairing::Canonical}) {
    for (int genus = 2; genus <= 8; ++genus) {
      expect_sound(surface_domain(genus, pairing), 2, 1e-11);
    }
  }
}

TEST(ClosedSpaces, TakeSitesAndLoseTheirOwnVertices) {
  for (const Domain& domain :
       {sphere_domain(), torus_domain({1, 0.2}, {0.3, 1}),
        surface_domain(2, SidePairing::Canonical), surface_domain(5, SidePairing::Opposite)}) {
    SpaceTriangulation s = triangulate_closed(domain);
    DelaunayTriangulation& d = s.triangulation;
    const std::size_t own = s.frame.size();
    for (const ModelPoint& p : random_points(domain, 200, 4)) {
      d.insert({0}, {offset_in(s.frame[0], p), {}});
    }
    for (std::size_t v = 0; v < own; ++v) {
      d.remove({static_cast<std::int32_t>(v)});
    }
    d.compact();
    EXPECT_EQ(d.vertex_count(), 200);
    EXPECT_EQ(d.connectivity().euler_number(), 2 - 2 * domain.genus);
    EXPECT_NEAR(d.area(), domain.area, 1e-9 * domain.area);
  }
}

TEST(ClosedSpaces, PolygonsAreRefused) {
  EXPECT_THROW(triangulate_closed(polygon_domain(0, {{0, 0}, {1, 0}, {0, 1}})), InvalidInput);
}

TEST(GluedSide, IsAnInvolution) {
  for (const Domain& domain :
       {torus_domain({1, 0}, {5, 1}), surface_domain(2, SidePairing::Opposite),
        surface_domain(6, SidePairing::Canonical)}) {
    for (std::size_t i = 0; i < domain.polygon.size(); ++i) {
      EXPECT_NE(glued_side(domain, i), i);
      EXPECT_EQ(glued_side(domain, glued_side(domain, i)), i);
    }
  }
}

}  // namespace
}  // namespace ucvt
