#include "triangulation/uniform_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "oracle/surfaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

double distance(const Offset& p, const Offset& q) {
  return std::hypot(p.x - q.x, p.y - q.y, p.h - q.h);
}

class UniformSurfaceTest : public testing::TestWithParam<double> {
 protected:
  const UniformSurface& t = oracle::surface_of(GetParam());
  const Connectivity& c = t.connectivity();
  const Space s = t.space();

  /// The corners of a face in the frame of its corner 0.
  std::array<Offset, 3> lay(Face f) const {
    const auto side = halfedges(f);
    const double turn = t.angle(side[0]);
    return {Offset{}, from_chord(s, t.chord(side[0]), 1, 0),
            from_chord(s, t.chord(side[2]), std::cos(turn), std::sin(turn))};
  }
};

TEST_P(UniformSurfaceTest, HasAngleSumsOfTwoPiAndTheAreaOfGaussAndBonnet) {
  for (const UniformSurface& u : {t, oracle::fewest_vertices(t)}) {
    EXPECT_LT(oracle::worst_angle_error(u), 1e-10);
    double area = 0;
    for (std::size_t f = 0; f < u.connectivity().face_count(); ++f) {
      area += u.area({static_cast<std::int32_t>(f)});
    }
    EXPECT_NEAR(area, oracle::gauss_bonnet_area(u), 1e-9);
  }
}

TEST_P(UniformSurfaceTest, AnglesAndAreasAreThoseOfTheLaidOutFace) {
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    const auto x = lay(face);
    EXPECT_NEAR(chord2(s, x[1], x[2]), std::pow(t.chord(halfedges(face)[1]), 2), 1e-13);
    EXPECT_NEAR(orientation(s, x[0], x[1], x[2]), t.det(face), 1e-13);
    EXPECT_NEAR(central_triangle_area(s, x[1], x[2]), t.area(face), 1e-12);
    const Offset p = transvect_back(s, x[1], x[2]), q = transvect_back(s, x[1], x[0]);
    EXPECT_NEAR(std::atan2(cross(p, q), p.x * q.x + p.y * q.y), t.angle(halfedges(face)[1]), 1e-12);
  }
}

TEST_P(UniformSurfaceTest, DevelopingRoundAVertexComesBack) {
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const Halfedge first = c.outgoing({static_cast<std::int32_t>(v)});
    const auto x = lay(first.face());
    std::array<Offset, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = x[(static_cast<std::size_t>(first.id % 3) + i) % 3];
    }
    const Offset centre = at[0], start = at[1];
    // Across the side that ends at the centre into the next face, counterclockwise.
    Offset rim = at[2];
    Halfedge h = first;
    double turn = 0;
    do {
      const Offset w = t.develop(h.prev(), rim, centre);
      h = c.rotate(h);
      EXPECT_NEAR(chord2(s, w, rim), std::pow(t.chord(h.next()), 2), 1e-10);
      EXPECT_NEAR(chord2(s, w, centre), std::pow(t.chord(h.prev()), 2), 1e-10);
      EXPECT_GT(orientation(s, centre, rim, w), 0);
      turn += t.angle(h);
      rim = w;
    } while (h != first);
    EXPECT_LT(distance(rim, at[2]), 1e-9);
    EXPECT_LT(distance(start, at[1]), 1e-9);
    EXPECT_NEAR(turn, 2 * std::numbers::pi, 1e-9);
  }
}

TEST_P(UniformSurfaceTest, DevelopingAcrossAnEdgeAndBackIsTheIdentity) {
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const auto x = lay(h.face());
    const auto j = static_cast<std::size_t>(h.id % 3);
    const Offset u = x[j], v = x[(j + 1) % 3], apex = x[(j + 2) % 3];
    const Offset across = t.develop(h, u, v);
    EXPECT_LT(orientation(s, u, v, across), 0);
    EXPECT_LT(distance(t.develop(c.twin(h), v, u), apex), 1e-12);
  }
}

TEST_P(UniformSurfaceTest, VertexFramesSeeTheirNeighbours) {
  const auto frame = t.vertex_frames();
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const Vertex vertex{static_cast<std::int32_t>(v)};
    EXPECT_EQ(frame[c.outgoing(vertex).index()].y, 0);
    EXPECT_GT(frame[c.outgoing(vertex).index()].x, 0);
    c.for_outgoing(vertex, [&](Halfedge h) {
      const Offset &p = frame[h.index()], &q = frame[c.rotate(h).index()];
      EXPECT_NEAR(std::sqrt(2 * p.h), t.chord(h), 1e-13);
      EXPECT_NEAR(std::sqrt(chord2(s, p, q)), t.chord(h.next()), 1e-10);
      EXPECT_GT(cross(p, q), 0);
    });
  }
}

TEST_P(UniformSurfaceTest, PlacesAndPointsAreInverse) {
  for (const SurfacePoint& p : oracle::random_points(t, 200, 7)) {
    const Place place = place_of(t, p);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(chord2(s, place.corner[i], place.corner[(i + 1) % 3]),
                  std::pow(t.chord(halfedges(p.face)[i]), 2), 1e-12);
    }
    EXPECT_LT(distance(point_in_frame(t, p, place.corner), {}), 1e-13);
    const SurfacePoint back = point_of(place);
    EXPECT_EQ(back.face, p.face);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(back.bary[i], p.bary[i], 1e-13);
    }
  }
}

TEST_P(UniformSurfaceTest, MovingThereAndBackComesBack) {
  std::mt19937_64 random(3);
  for (const SurfacePoint& p : oracle::random_points(t, 100, 8)) {
    Place place = place_of(t, p);
    const auto before = place.corner;
    const double angle = 2 * std::numbers::pi * oracle::uniform(random);
    const Offset to =
        from_chord(s, 1.5 * oracle::uniform(random), std::cos(angle), std::sin(angle));
    move_place(t, place, to);
    // The origin lies in the face it is said to be in.
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GT(cross(place.corner[i], place.corner[(i + 1) % 3]), -1e-13);
      EXPECT_NEAR(chord2(s, place.corner[i], place.corner[(i + 1) % 3]),
                  std::pow(t.chord(halfedges(place.face)[i]), 2), 1e-8);
    }
    move_place(t, place, {-to.x, -to.y, to.h});
    ASSERT_EQ(place.face, p.face);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(distance(place.corner[i], before[i]), 1e-8);
    }
  }
}

TEST_P(UniformSurfaceTest, AStraightWalkInStepsIsTheWalkAtOnce) {
  for (const SurfacePoint& p : oracle::random_points(t, 30, 9)) {
    Place once = place_of(t, p), steps = once;
    const double length = 1.2;
    move_place(t, once, from_chord(s, chord_of_length(s, length), 0.6, 0.8));
    for (int i = 0; i < 10; ++i) {
      move_place(t, steps, from_chord(s, chord_of_length(s, length / 10), 0.6, 0.8));
    }
    if (once.face == steps.face) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT(distance(once.corner[i], steps.corner[i]), 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Curvatures, UniformSurfaceTest, testing::Values(1.0, 0.0, -1.0));

TEST(UniformSurface, WalkingALatticeVectorOfTheFlatTorusIsTheIdentity) {
  const UniformSurface t = oracle::flat_torus(6, 5, 0.3, 1.2);
  const double s = std::sqrt(1.2);
  // Faces 0 and 1 have their side along (1, 0): both frames see the lattice as it was written.
  const Place start = place_of(t, {{0}, {0.2, 0.3, 0.5}});
  for (const auto& [x, y] : {std::pair{1 / s, 0.0}, {0.3 / s, 1.2 / s}, {-1.7 / s, 1.2 / s}}) {
    Place place = start;
    move_place(t, place, {x, y, (x * x + y * y) / 2});
    EXPECT_EQ(place.face, start.face);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(distance(place.corner[i], start.corner[i]), 1e-13);
    }
  }
}

TEST(UniformSurface, WalksOutOfFacesThatRoundingCannotTellFromAPoint) {
  const UniformSurface t =
      uniformize_surface(oracle::closed(oracle::finger(4, 0.1, 10)), {}).surface;
  const auto longest = [&](Face f) {
    const auto side = halfedges(f);
    return std::max({t.chord(side[0]), t.chord(side[1]), t.chord(side[2])});
  };
  Face smallest{0};
  for (std::size_t f = 0; f < t.connectivity().face_count(); ++f) {
    const Face face{static_cast<std::int32_t>(f)};
    smallest = longest(face) < longest(smallest) ? face : smallest;
  }
  ASSERT_LT(longest(smallest), 1e-16);
  const Space s = t.space();
  for (const double angle : {0.3, 1.7, 4.0}) {
    Place once = place_of(t, {smallest, {0.3, 0.3, 0.4}}), steps = once;
    const auto away = [&](double length) {
      return from_chord(s, chord_of_length(s, length), std::cos(angle), std::sin(angle));
    };
    move_place(t, once, away(0.8));
    double moved = 0;
    for (double step = 1e-20; moved < 0.8; step *= 2) {
      const double part = std::min(step, 0.8 - moved);
      move_place(t, steps, away(part));
      moved += part;
    }
    ASSERT_EQ(once.face, steps.face);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT(distance(once.corner[i], steps.corner[i]), 1e-8);
      EXPECT_GT(cross(once.corner[i], once.corner[(i + 1) % 3]), 0);
    }
  }
}

TEST(UniformSurface, RefusesAFaceThatIsNoTriangle) {
  const TriangleMesh mesh = oracle::tetrahedron();
  const Connectivity c(mesh.positions.size(), mesh.faces);
  EXPECT_NO_THROW(UniformSurface({0}, c, std::vector<double>(12, 1.0)));
  std::vector<double> chord(12, 1.0);
  chord[0] = chord[c.twin({0}).index()] = 2.1;
  EXPECT_THROW(UniformSurface({0}, c, chord), NumericalError);
  EXPECT_THROW(UniformSurface({1}, c, std::vector<double>(12, 1.9)), NumericalError);
}

}  // namespace
}  // namespace ucvt
