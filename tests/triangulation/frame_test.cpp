#include "triangulation/frame.h"

#include <numbers>
#include <random>

#include "oracle/generators.h"
#include "oracle/surfaces.h"

namespace ucvt {
namespace {

double inner(double kappa, const ModelPoint& a, const ModelPoint& b) {
  return a[2] * b[2] + kappa * (a[0] * b[0] + a[1] * b[1]);
}

double metric(double kappa, const ModelPoint& a, const ModelPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + kappa * a[2] * b[2];
}

double gap(const ModelPoint& a, const ModelPoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double gap(const Offset& a, const Offset& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.h - b.h);
}

/// How far a frame is from orthonormal.
double skew(const Frame& f) {
  const ModelPoint e2 = f.E2();
  // A sum, since max would pass over what is not a number.
  return std::abs(inner(f.kappa, f.P, f.P) - 1) + std::abs(inner(f.kappa, f.P, f.E1)) +
         std::abs(inner(f.kappa, f.P, e2)) + std::abs(metric(f.kappa, f.E1, f.E1) - 1) +
         std::abs(metric(f.kappa, e2, e2) - 1) + std::abs(metric(f.kappa, f.E1, e2));
}

Rotation rotation() {
  const double angle = oracle::number(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

/// A frame anywhere on the sphere, and where cosh is below 3 on the hyperboloid.
Frame frame(Space s) {
  const double chord = oracle::number(0, s.kappa > 0 ? 1.999 : 2);
  const Rotation r = rotation();
  const ModelPoint p = model_point(Frame{s.kappa}, from_chord(s, chord, r.cosine, r.sine));
  return turned(frame_at(s.kappa, p), rotation());
}

RC_GTEST_PROP(FrameTest, IsOrthonormal, ()) {
  const Space s = oracle::space();
  const Frame f = frame(s), g = carried(f, oracle::point(s, 1));
  RC_ASSERT(skew(f) < 1e-13);
  RC_ASSERT(skew(g) < 1e-12);
}

RC_GTEST_PROP(FrameTest, OffsetsComeBack, ()) {
  const Space s = oracle::space();
  const Frame f = frame(s);
  const Offset x = oracle::point(s, 1);
  RC_ASSERT(gap(offset_in(f, model_point(f, x)), x) < 1e-13);
  RC_ASSERT(std::abs(inner(s.kappa, model_point(f, x), model_point(f, x)) - 1) < 1e-12);
}

RC_GTEST_PROP(FrameTest, CarriedIsTransvect, ()) {
  const Space s = oracle::space();
  const Frame f = frame(s);
  const Offset a = oracle::point(s, 1), x = oracle::point(s, 1);
  RC_ASSERT(gap(model_point(carried(f, a), x), model_point(f, transvect(s, a, x))) < 1e-12);
}

RC_GTEST_PROP(FrameTest, TakingTakesTheFrameAlong, ()) {
  const Space s = oracle::space();
  const Frame f = frame(s), g = frame(s);
  const ModelMatrix m = taking(f, g);
  const Offset x = oracle::point(s, 1);
  const ModelPoint p = model_point(f, x);
  RC_ASSERT(gap(transformed(m, p), model_point(g, x)) < 1e-11);
  RC_ASSERT(gap(transformed(inverse_isometry(s.kappa, m), transformed(m, p)), p) < 1e-10);
}

RC_GTEST_PROP(FrameTest, NearPointsKeepTheirDigits, ()) {
  const Space s = oracle::space();
  const Frame f = frame_at(s.kappa, model_point(Frame{s.kappa}, oracle::point(s, 1)));
  const Offset step = oracle::point(s, oracle::scale() * 1e-3);
  RC_PRE(step.h > 0);
  const ModelPoint p = model_point(f, step);
  // From the same x and y in long double, z being what they make it.
  using Real = long double;
  const auto z = [&](const ModelPoint& q) {
    return std::sqrt(1 - static_cast<Real>(s.kappa) *
                             (static_cast<Real>(q[0]) * q[0] + static_cast<Real>(q[1]) * q[1]));
  };
  const Real dx = static_cast<Real>(p[0]) - f.P[0], dy = static_cast<Real>(p[1]) - f.P[1];
  const Real dz =
      -static_cast<Real>(s.kappa) *
      (dx * (static_cast<Real>(p[0]) + f.P[0]) + dy * (static_cast<Real>(p[1]) + f.P[1])) /
      (z(p) + z(f.P));
  const Real half_chord2 = (dx * dx + dy * dy + static_cast<Real>(s.kappa) * dz * dz) / 2;
  RC_PRE(half_chord2 > 0);
  RC_ASSERT(std::abs(static_cast<double>(offset_in(f, p).h / half_chord2 - 1)) < 1e-13);
}

TEST(FrameAt, CoversTheSphere) {
  for (const ModelPoint& p : {ModelPoint{0, 0, 1},
                              {0, 0, -1},
                              {1, 0, 0},
                              {0, -1, 0},
                              {0.6, 0, -0.8},
                              {0, 1e-12, -1},
                              {1e-9, 0, 1}}) {
    const Frame f = frame_at(1, p);
    EXPECT_LT(gap(f.P, p), 1e-15);
    EXPECT_LT(skew(f), 1e-15);
  }
}

TEST(Frame, StaysOrthonormalOverManySteps) {
  for (const double kappa : {-1.0, 0.0, 1.0}) {
    std::mt19937_64 random(3);
    Frame f{kappa};
    for (int i = 0; i < 10000; ++i) {
      const double a = 2 * std::numbers::pi * oracle::uniform(random);
      const Frame next = carried(f, from_chord({kappa}, 0.1, std::cos(a), std::sin(a)));
      f = next.P[2] < 5 ? next : f;
    }
    EXPECT_LT(skew(f), 1e-13) << kappa;
  }
}

TEST(Frame, OrthonormalMendsRounding) {
  for (const double kappa : {-1.0, 0.0, 1.0}) {
    const Frame f = carried(Frame{kappa}, from_chord({kappa}, 0.7, 0.6, 0.8));
    Frame g = f;
    g.P[2] += 1e-7, g.E1[0] += 1e-7, g.E1[2] -= 2e-7;
    EXPECT_LT(skew(orthonormal(g)), 1e-15);
    EXPECT_LT(gap(orthonormal(g).P, f.P) + gap(orthonormal(g).E1, f.E1), 1e-6);
  }
}

}  // namespace
}  // namespace ucvt
