#include "space/offset.h"

#include <cmath>
#include <numbers>

#include "oracle/generators.h"
#include "space/moments.h"

namespace ucvt {
namespace {

using oracle::norm;
using oracle::number;
using oracle::off_quadric;
using oracle::point;
using oracle::scale;
using oracle::space;

/// Squared size of what chords are made of; rounding is relative to it.
double size2(Space s, std::initializer_list<Offset> points) {
  double sum = 0;
  for (const Offset& p : points) {
    const double z = std::abs(model_z(s, p));
    sum += (p.x * p.x + p.y * p.y + p.h * p.h) * z * z;
  }
  return sum;
}

RC_GTEST_PROP(Offset, TransvectKeepsChords, ()) {
  const Space s = space();
  const double size = scale();
  const Offset a = point(s, size), p = point(s, size), q = point(s, size);
  const double before = chord2(s, p, q);
  const double after = chord2(s, transvect(s, a, p), transvect(s, a, q));
  RC_ASSERT(std::abs(after - before) <= 1e-13 * size2(s, {a, p, q}));
}

RC_GTEST_PROP(Offset, TransvectCarriesTheOriginAndStaysOnTheQuadric, ()) {
  const Space s = space();
  const double size = scale();
  const Offset a = point(s, size), p = point(s, size);
  const Offset o = transvect(s, a, {});
  RC_ASSERT(o.x == a.x && o.y == a.y && o.h == a.h);
  const Offset moved = transvect(s, a, p);
  const double error =
      moved.x * moved.x + moved.y * moved.y + s.kappa * moved.h * moved.h - 2 * moved.h;
  RC_ASSERT(std::abs(error) <= 1e-13 * size2(s, {a, p}));
}

RC_GTEST_PROP(Offset, TransvectBackIsTheInverse, ()) {
  const Space s = space();
  const double size = scale();
  const Offset a = point(s, size), p = point(s, size);
  const Offset back = transvect_back(s, a, transvect(s, a, p));
  const double tolerance = 1e-13 * std::sqrt(size2(s, {a, p}));
  RC_ASSERT(std::abs(back.x - p.x) <= tolerance);
  RC_ASSERT(std::abs(back.y - p.y) <= tolerance);
  RC_ASSERT(std::abs(back.h - p.h) <= tolerance * (norm(a) + norm(p)));
}

RC_GTEST_PROP(Offset, LengthsAddAlongALine, ()) {
  const Space s = space();
  const double size = scale();
  const double angle = number(-3, 3), c = std::cos(angle), d = std::sin(angle);
  const double u = size * number(0.1, 1.4), v = size * number(0.1, 1.4);
  const Offset a = from_chord(s, chord_of_length(s, u), c, d);
  const Offset b = from_chord(s, chord_of_length(s, v), c, d);
  const Offset both = transvect(s, a, b);
  RC_ASSERT(std::abs(length_of_chord(s, std::sqrt(2 * both.h)) - (u + v)) <= 1e-13 * (u + v));
  const double across = both.x * d - both.y * c;
  RC_ASSERT(std::abs(across) <= 1e-14 * norm(both) + 1e-15 * (u + v));
}

TEST(Offset, ParallelTransportRoundAnOctantTurnsByItsArea) {
  const Space s{1};
  const Offset east = from_chord(s, std::numbers::sqrt2, 1, 0);
  const Offset north = from_chord(s, std::numbers::sqrt2, 0, 1);
  const Offset west = from_chord(s, std::numbers::sqrt2, -1, 0);
  const auto round = [&](const Offset& p) {
    return transvect(s, east, transvect(s, north, transvect(s, west, p)));
  };
  EXPECT_LT(norm(round({})), 1e-15);
  const Offset p = from_chord(s, 0.3, 1, 0), turned = round(p);
  EXPECT_NEAR(turned.x, 0, 1e-15);
  EXPECT_NEAR(turned.y, p.x, 1e-15);
  EXPECT_NEAR(turned.h, p.h, 1e-15);
}

RC_GTEST_PROP(Offset, CentralCoordinatesAndQuadric, ()) {
  const Space s = space();
  const double size = scale();
  const double kx = size * number(-0.69, 0.69), ky = size * number(-0.69, 0.69);
  RC_PRE(std::hypot(kx, ky) > 1e-6 * size);
  const Offset p = from_central(s, kx, ky);
  RC_ASSERT(std::abs(p.x / model_z(s, p) - kx) <= 1e-14 * size);
  RC_ASSERT(std::abs(p.y / model_z(s, p) - ky) <= 1e-14 * size);
  RC_ASSERT(off_quadric(s, p) <= 1e-14);
  const Offset spoiled{p.x, p.y, p.h * 1.001};
  const Offset again = on_quadric(s, spoiled);
  RC_ASSERT(again.x == p.x && again.y == p.y);
  RC_ASSERT(std::abs(again.h - p.h) <= 1e-14 * p.h * (1 + 2 * std::abs(p.h)));
}

RC_GTEST_PROP(Offset, ChordsAndLengths, ()) {
  const Space s = space();
  const double chord = scale() * number(0.01, 1.99), angle = number(-3, 3);
  const Offset p = from_chord(s, chord, std::cos(angle), std::sin(angle));
  RC_ASSERT(std::abs(2 * p.h - chord * chord) <= 1e-15 * chord * chord);
  RC_ASSERT(off_quadric(s, p) <= 1e-14);
  const double length = length_of_chord(s, chord);
  // Next to the antipode the chord hardly changes with the length.
  const double slope = s.kappa > 0 ? std::sqrt(1 - chord * chord / 4) : 1;
  RC_ASSERT(std::abs(chord_of_length(s, length) - chord) <= 1e-15 * chord * (2 + 1 / slope));
  RC_ASSERT((length - chord) * s.kappa >= 0);
}

TEST(Offset, PastTheHorizonOfTheSphereHeightIsKept) {
  const Offset p = from_chord({1}, 1.9, 0.6, 0.8);
  ASSERT_GT(p.h, 1);
  const Offset q = on_quadric({1}, p);
  EXPECT_EQ(q.h, p.h);
  EXPECT_LT(off_quadric({1}, q), 1e-15);
}

RC_GTEST_PROP(Offset, BisectorIsEquidistant, ()) {
  const Space s = space();
  const double size = scale();
  const Offset a = point(s, size);
  RC_PRE(norm(a) > 0.01 * size);
  // A point of the line a.k = h in central coordinates.
  const double along = size * number(-0.3, 0.3), n2 = a.x * a.x + a.y * a.y;
  const double kx = (a.h * a.x - along * norm(a) * a.y) / n2;
  const double ky = (a.h * a.y + along * norm(a) * a.x) / n2;
  RC_PRE(1 + s.kappa * (kx * kx + ky * ky) > 0.01);
  const Offset p = from_central(s, kx, ky);
  RC_ASSERT(std::abs(chord2(s, a, p) - 2 * p.h) <= 1e-13 * size2(s, {a, p}));
}

/// Two points counterclockwise about the origin, clear of degeneracy, and their circumcentre.
struct Triangle {
  Offset a, b, centre;
};
Triangle triangle(Space s, double size) {
  const Offset a = point(s, size), b = point(s, size);
  RC_PRE(cross(a, b) > 0.05 * size * size);
  const Central k = circumcentre(a, b);
  RC_PRE(1 + s.kappa * (k.x * k.x + k.y * k.y) > 0.01 && std::hypot(k.x, k.y) < 5);
  return {a, b, from_central(s, k.x, k.y)};
}

RC_GTEST_PROP(Offset, CircumcentreIsEquidistant, ()) {
  const Space s = space();
  const double size = scale();
  const auto [a, b, c] = triangle(s, size);
  const double tolerance = 1e-12 * size2(s, {a, b, c});
  RC_ASSERT(std::abs(chord2(s, a, c) - 2 * c.h) <= tolerance);
  RC_ASSERT(std::abs(chord2(s, b, c) - 2 * c.h) <= tolerance);
}

RC_GTEST_PROP(Offset, InCircleAgreesWithTheDistanceFromTheCircumcentre, ()) {
  const Space s = space();
  const double size = scale();
  const auto [a, b, c] = triangle(s, size);
  const Offset d = point(s, size);
  const double beyond = chord2(s, d, c) - 2 * c.h;
  RC_PRE(std::abs(beyond) > 1e-11 * size2(s, {a, b, c, d}));
  RC_ASSERT((in_circle(a, b, d) < 0) == (beyond < 0));
}

RC_GTEST_PROP(Offset, OrientationIsTheDeterminantOfModelPoints, ()) {
  const Space s = space();
  const double size = scale();
  // Central coordinates k: det[P, Q, R] = z z z det(k - k_p), free of cancellation.
  const auto k = [&](const Offset& p) {
    const long double z = 1 - static_cast<long double>(s.kappa) * p.h;
    return std::array<long double, 3>{p.x / z, p.y / z, z};
  };
  const Offset p = point(s, size), q = point(s, size), r = point(s, size);
  const auto kp = k(p), kq = k(q), kr = k(r);
  const long double det = kp[2] * kq[2] * kr[2] *
                          ((kq[0] - kp[0]) * (kr[1] - kp[1]) - (kr[0] - kp[0]) * (kq[1] - kp[1]));
  RC_ASSERT(std::abs(orientation(s, p, q, r) - static_cast<double>(det)) <=
            1e-13 * size2(s, {p, q, r}));
}

RC_GTEST_PROP(Offset, IsometriesPlaceFrames, ()) {
  const Space s = space();
  const double size = scale();
  const Offset tail = point(s, size), local = point(s, size), p = point(s, size);
  RC_PRE(norm(local) > 0.01 * size);
  const double turn = number(-3, 3);
  const Isometry outer{tail, {std::cos(turn), std::sin(turn)}};
  const Offset head = outer.apply(s, local);
  const Isometry placed = placing(s, local, tail, head);
  const double tolerance = 1e-11 * std::sqrt(size2(s, {tail, local, p}));
  RC_ASSERT(norm({placed.apply(s, p).x - outer.apply(s, p).x,
                  placed.apply(s, p).y - outer.apply(s, p).y, 0}) <= tolerance);
  const Offset back = placed.apply_inverse(s, placed.apply(s, p));
  RC_ASSERT(norm({back.x - p.x, back.y - p.y, 0}) <= tolerance);
}

RC_GTEST_PROP(Offset, FramesOfTwoEndsSeeEachOther, ()) {
  const Space s = space();
  const double size = scale();
  const Offset ij = point(s, size);
  RC_PRE(norm(ij) > 0.01 * size);
  const double turn = number(-3, 3);
  const Offset ji = Rotation{std::cos(turn), std::sin(turn)}(ij);
  const Isometry f = between_frames(ij, ji);
  const double tolerance = 1e-13 * std::sqrt(size2(s, {ij}));
  const Offset home = f.apply(s, ji), there = f.apply(s, {});
  RC_ASSERT(norm(home) <= tolerance);
  RC_ASSERT(norm({there.x - ij.x, there.y - ij.y, 0}) <= tolerance);
}

/// Angle at p of the triangle p, q, r.
double angle_at(Space s, const Offset& p, const Offset& q, const Offset& r) {
  const Offset u = transvect_back(s, p, q), v = transvect_back(s, p, r);
  return std::atan2(cross(u, v), u.x * v.x + u.y * v.y);
}

RC_GTEST_PROP(Offset, TriangleAreaIsTheAngleExcess, ()) {
  const Space s = space();
  const double size = std::max(scale(), 1e-3);
  const Offset a = point(s, size), b = point(s, size);
  RC_PRE(std::abs(cross(a, b)) > 1e-3 * size * size);
  const double area = central_triangle_area(s, a, b);
  if (s.kappa == 0) {
    RC_ASSERT(std::abs(area - cross(a, b) / 2) <= 1e-15 * size * size);
    return;
  }
  const double sum = angle_at(s, {}, a, b) + angle_at(s, a, b, {}) + angle_at(s, b, {}, a);
  const double excess = s.kappa * (sum - std::copysign(std::numbers::pi, sum));
  RC_ASSERT(std::abs(area - excess) <= 1e-11);
}

TEST(Offset, AreasThatAreKnown) {
  // An octant of the sphere, a hemisphere's half by two wide triangles, an ideal-ish triangle.
  const Offset east = from_chord({1}, std::numbers::sqrt2, 1, 0);
  const Offset north = from_chord({1}, std::numbers::sqrt2, 0, 1);
  EXPECT_NEAR(central_triangle_area({1}, east, north), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(central_triangle_area({1}, north, east), -std::numbers::pi / 2, 1e-15);
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double t0 = 2 * std::numbers::pi * i / 3, t1 = 2 * std::numbers::pi * (i + 1) / 3;
    sum += central_triangle_area(
        {-1}, from_central({-1}, (1 - 1e-12) * std::cos(t0), (1 - 1e-12) * std::sin(t0)),
        from_central({-1}, (1 - 1e-12) * std::cos(t1), (1 - 1e-12) * std::sin(t1)));
  }
  EXPECT_NEAR(sum, std::numbers::pi, 1e-5);
}

RC_GTEST_PROP(Offset, ThePlaneIsTheLimitOfSmallCurvature, ()) {
  // Everything that is analytic in kappa; lengths and areas take only its sign.
  const Space flat{0};
  const Offset a = point(flat, 1), p = point(flat, 1), q = point(flat, 1);
  for (const Space s : {Space{1e-9}, Space{-1e-9}}) {
    const auto near = [](const Offset& x, const Offset& y) {
      return std::abs(x.x - y.x) + std::abs(x.y - y.y) + std::abs(x.h - y.h) < 1e-7;
    };
    RC_ASSERT(near(transvect(s, a, p), transvect(flat, a, p)));
    RC_ASSERT(near(on_quadric(s, p), p));
    RC_ASSERT(near(from_central(s, p.x, p.y), p));
    RC_ASSERT(near(from_chord(s, 1.3, 0.6, 0.8), from_chord(flat, 1.3, 0.6, 0.8)));
    RC_ASSERT(std::abs(chord2(s, p, q) - chord2(flat, p, q)) < 1e-7);
    RC_ASSERT(std::abs(orientation(s, a, p, q) - orientation(flat, a, p, q)) < 1e-7);
    const std::array<double, 3> c{1, 1.1, 1.2};
    RC_ASSERT(std::abs(triangle_determinant(s, c) - triangle_determinant(flat, c)) < 1e-7);
  }
}

TEST(Offset, RotationsOfOffsetsThatHaveNoFourthPower) {
  for (const double scale : {1.0, 1e-60, 1e-83, 1e-140}) {
    const Offset from{3 * scale, 4 * scale, 0}, to{-4 * scale, 3 * scale, 0};
    const Rotation r = rotation_between(from, to);
    EXPECT_NEAR(r.cosine, 0, 1e-15) << scale;
    EXPECT_NEAR(r.sine, 1, 1e-15) << scale;
  }
}

}  // namespace
}  // namespace ucvt
