#include "space/polygon_moments.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "oracle/generators.h"
#include "space/polygon_test_support.h"

namespace ucvt {
namespace {

using oracle::number;
using oracle::point;
using oracle::scale;
using oracle::space;
using std::numbers::pi;

TEST(PolygonMoments, AgreeWithReferenceValues) {
  // mpmath, 60 digits.
  const std::vector<Central> corner{
      {1, 0}, {0.5, 0.75}, {-0.5, 0.5}, {-0.75, -0.25}, {0.25, -0.75}};
  struct Case {
    double kappa, size;
    Moments exact;
  };
  for (const auto& [kappa, size, exact] : {
           Case{1,
                9.5367431640625e-07,
                {1.47792889038043889e-12, 1.6263032587265002e-19, 4.0657581468163635e-20,
                 1.89831488232224767e-25}},
           {1,
            0.0078125,
            {0.0000991795642115382211, 8.94004873829238143e-8, 2.23501635269709949e-8,
             8.54876811987241123e-10}},
           {1,
            0.25,
            {0.0989563920701365119, 0.00272429420723657752, 0.000682347349667943592,
             0.000847168745206166387}},
           {1,
            0.875,
            {0.951287290063587515, 0.0602090915647845475, 0.015353614095158705,
             0.0758460207436677244}},
           {0,
            9.5367431640625e-07,
            {1.47792889038100839e-12, 1.62630325872825665e-19, 4.06575814682064163e-20,
             1.89831488232384281e-25}},
           {0,
            0.0078125,
            {0.00009918212890625, 8.94069671630859375e-8, 2.23517417907714844e-8,
             8.54925019666552544e-10}},
           {0, 0.25, {0.1015625, 0.0029296875, 0.000732421875, 0.000896453857421875}},
           {0, 0.875, {1.244140625, 0.1256103515625, 0.031402587890625, 0.134524106979370117}},
           {-1,
            9.5367431640625e-07,
            {1.47792889038157788e-12, 1.6263032587300131e-19, 4.06575814682491976e-20,
             1.89831488232543795e-25}},
           {-1,
            0.0078125,
            {0.000099184693761661936, 8.94134476824632994e-8, 2.23533202315075735e-8,
             8.54973232081602684e-10}},
           {-1,
            0.25,
            {0.104341410356912993, 0.00316055355196371986, 0.000788592425707649518,
             0.000950959153922025077}},
           {-1,
            0.875,
            {1.95594971427084008, 0.480392442190266174, 0.111802271368627324,
             0.388765053407856785}},
       }) {
    const Space s{kappa};
    const Polygon c = from_central(s, corner, size);
    const Moments got = uniform_moments(s, c);
    EXPECT_LT(difference(got, exact, reach_of(c)), 2e-15) << kappa << " " << size;
    EXPECT_NEAR(got.h / exact.h, 1, 4e-15) << kappa << " " << size;
  }
}

RC_GTEST_PROP(PolygonMoments, ClosedFormIsCubatureToThirteenDigits, ()) {
  const Space s = space();
  const Polygon c = convex(s, scale());
  const Cubature cubature = density_moments(s, c, one, {.relative_tolerance = 1e-13});
  RC_ASSERT(cubature.converged);
  RC_ASSERT(difference(uniform_moments(s, c), cubature.moments, reach_of(c)) < 1e-13);
}

RC_GTEST_PROP(PolygonMoments, ClosedFormIsBruteForceToThirteenDigits, ()) {
  const Space s = space();
  const Polygon c = convex(s, scale());
  RC_ASSERT(difference(uniform_moments(s, c), brute_force(s, c, one, 2), reach_of(c)) < 1e-13);
}

RC_GTEST_PROP(PolygonMoments, AddUpWhenThePolygonIsCut, ()) {
  const Space s = space();
  const Polygon c = convex(s, scale());
  const std::size_t cut = 2 + static_cast<std::size_t>(number(0, 1) * double(c.size() - 2));
  RC_PRE(cut < c.size() - 1);
  const auto middle = c.begin() + static_cast<std::ptrdiff_t>(cut);
  Polygon first(c.begin(), middle + 1), second(middle, c.end());
  second.push_back(c.front());
  Moments sum = uniform_moments(s, first);
  sum += uniform_moments(s, second);
  RC_ASSERT(difference(sum, uniform_moments(s, c), reach_of(c)) < 1e-14);
}

RC_GTEST_PROP(PolygonMoments, AreTheSameFromEveryFrame, ()) {
  const Space s = space();
  const double size = scale();
  const Polygon c = convex(s, size);
  const Offset a = point(s, 3 * size > 0.9 ? size : 3 * size);
  const Moments here = uniform_moments(s, c);
  const double ax = -a.x, ay = -a.y, dot = ax * here.x + ay * here.y;
  const double f = here.m - s.kappa * (here.h + dot / (2 - s.kappa * a.h));
  const Moments there{here.m, here.x + ax * f, here.y + ay * f,
                      a.h * here.m + here.h - s.kappa * a.h * here.h + dot};
  const Polygon seen = moved(s, a, c);
  RC_ASSERT(difference(uniform_moments(s, seen), there, reach_of(seen)) < 4e-14);
}

TEST(PolygonMoments, HaveThePlaneAsTheirLimit) {
  const std::vector<Central> corner{{1, 0}, {0.3, 0.9}, {-0.8, 0.1}, {0, -0.7}};
  for (double size = 0.1; size > 1e-9; size /= 10) {
    const Polygon flat = from_central({0}, corner, size);
    const Moments limit = uniform_moments({0}, flat);
    for (const double kappa : {1.0, -1.0}) {
      const Moments m = uniform_moments({kappa}, from_central({kappa}, corner, size));
      // The first term of the difference has the sign of the curvature.
      EXPECT_LT(difference(m, limit, size), 1.5 * size * size + 1e-15) << kappa << " " << size;
      if (size > 1e-6) {
        EXPECT_GT(kappa * (limit.m - m.m), 0.1 * size * size * limit.m);
      }
    }
  }
}

/// Sum of the interior angles less that of a plane polygon.
double gauss_bonnet(Space s, const Polygon& c) {
  double sum = -pi * (static_cast<double>(c.size()) - 2);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Offset next = transvect_back(s, c[i], c[(i + 1) % c.size()]);
    const Offset last = transvect_back(s, c[i], c[(i + c.size() - 1) % c.size()]);
    sum += std::atan2(cross(next, last), next.x * last.x + next.y * last.y);
  }
  return s.kappa * sum;
}

RC_GTEST_PROP(PolygonMoments, HaveTheAreaOfGaussBonnet, ()) {
  const Space s{*rc::gen::element(1.0, -1.0)};
  const Polygon c = convex(s, 1);
  RC_ASSERT(std::abs(uniform_moments(s, c).m - gauss_bonnet(s, c)) < 2e-14);
}

TEST(PolygonMoments, OctantAndHemisphereAreKnown) {
  const Space s{1};
  const Polygon octant{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}};
  const Moments m = uniform_moments(s, octant);
  EXPECT_LT(difference(m, {pi / 2, pi / 4, pi / 4, pi / 4}, 1), 1e-15);
  for (const double tilt : {0.0, 0.3, 1.0, 1.57, pi / 2, 1.6, 2.5, 3.1, pi}) {
    // The hemisphere about a point at this distance: int P is pi times that point.
    const Offset pole{std::sin(tilt), 0, 2 * std::pow(std::sin(tilt / 2), 2)};
    Polygon hemisphere;
    for (int i = 0; i < 5; ++i) {
      const double t = 2 * pi * i / 5;
      hemisphere.push_back(
          {std::cos(tilt) * std::cos(t), std::sin(t), 1 + std::sin(tilt) * std::cos(t)});
    }
    const Moments exact{2 * pi, pi * pole.x, 0, 2 * pi - pi * (1 - pole.h)};
    EXPECT_LT(difference(uniform_moments(s, hemisphere), exact, 1), 3e-15) << tilt;
    const Cubature c = density_moments(s, hemisphere, one, {.relative_tolerance = 1e-12});
    EXPECT_LT(difference(c.moments, exact, 1), 1e-12) << tilt;
    EXPECT_TRUE(c.converged);
  }
}

TEST(PolygonMoments, EdgesOfNearlyHalfACircleLoseNoMoreThanTheirCorners) {
  for (const double t : {1.6, 3.0, 3.14, 3.1415, 3.14159}) {
    // Between two meridians, from the origin to its equator.
    const Polygon c{{0, 0, 0}, {1, 0, 1}, {std::cos(t), std::sin(t), 1}};
    const Moments exact{t, pi / 4 * std::sin(t), pi / 4 * (1 - std::cos(t)), t / 2};
    // The corners' rounding turns the edge by so much.
    EXPECT_LT(difference(uniform_moments({1}, c), exact, 1), 1e-15 + 1e-16 / std::sin(t)) << t;
  }
}

RC_GTEST_PROP(PolygonMoments, AreRightOnTheFarSideOfTheSphere, ()) {
  const Space s{1};
  const Polygon c = convex(s, scale());
  Polygon turned;  // by a half-turn about the x axis
  for (const Offset& p : c) {
    turned.push_back({p.x, -p.y, 2 - p.h});
  }
  const Moments m = uniform_moments(s, c);
  RC_ASSERT(difference(uniform_moments(s, turned), {m.m, m.x, -m.y, 2 * m.m - m.h}, 1) < 1e-14);
}

TEST(PolygonMoments, NearlyIdealTriangleHasNearlyTheAreaPi) {
  const Space s{-1};
  for (const double gap : {1e-2, 1e-4, 1e-6}) {
    Polygon c;
    for (int i = 0; i < 3; ++i) {
      const double t = 2 * pi * i / 3;
      c.push_back(ucvt::from_central(s, (1 - gap) * std::cos(t), (1 - gap) * std::sin(t)));
    }
    // Twice the side's distance from the centre, in a triangle with one corner there.
    const double k = 1 - gap, z2 = 1 / (1 - k * k), cosh_side = z2 * (1 + k * k / 2);
    const double angle = std::acos(cosh_side / (1 + cosh_side));
    EXPECT_NEAR(uniform_moments(s, c).m, pi - 3 * angle, 1e-12) << gap;
    const Cubature cubature = density_moments(s, c, one, {.relative_tolerance = 1e-10});
    EXPECT_NEAR(cubature.moments.m, pi - 3 * angle, 1e-9) << gap;
    EXPECT_TRUE(cubature.converged);
  }
}

TEST(PolygonMoments, AreNotLambertsSumWhichLosesSmallCells) {
  for (const double kappa : {1.0, -1.0}) {
    const Space s{kappa};
    const std::vector<Central> k{{1, 0}, {0.3, 0.9}, {-0.8, 0.1}, {0, -0.7}};
    const double size = 1e-5;
    const Polygon c = from_central(s, k, size);
    double naive = 0;  // int x as the sum of 1/2 d/s kappa (P_a x P_b)_x
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Offset &a = c[i], &b = c[(i + 1) % c.size()];
      const double chord = std::sqrt(chord2(s, a, b)), d = length_of_chord(s, chord);
      const double sine = kappa > 0 ? std::sin(d) : std::sinh(d);
      naive += kappa * d / sine / 2 * (a.y * model_z(s, b) - model_z(s, a) * b.y);
    }
    const Moments exact = brute_force(s, c, one, 1), got = uniform_moments(s, c);
    EXPECT_GT(std::abs(naive - exact.x) / (exact.m * size), 1e-8);
    EXPECT_LT(difference(got, exact, size), 2e-15);
  }
}

TEST(PolygonMoments, OfNothingAreZero) {
  const Polygon line{{0, 0, 0}, ucvt::from_central({1}, 0.1, 0)};
  for (const Polygon& c : {Polygon{}, line}) {
    EXPECT_EQ(uniform_moments({1}, c).m, 0);
    EXPECT_EQ(density_moments({1}, c, one).moments.m, 0);
  }
  const Polygon point(4, ucvt::from_central({-1}, 0.1, 0.2));
  EXPECT_EQ(uniform_moments({-1}, point).m, 0);
  // A corner given twice changes nothing.
  const std::vector<Central> k{{1, 0}, {0.3, 0.9}, {0.3, 0.9}, {-0.8, 0.1}, {0, -0.7}};
  const Polygon twice = from_central({-1}, k, 0.5);
  Polygon once = twice;
  once.erase(once.begin() + 1);
  EXPECT_LT(difference(uniform_moments({-1}, twice), uniform_moments({-1}, once), 0.5), 1e-16);
  EXPECT_LT(difference(density_moments({-1}, twice, one).moments,
                       density_moments({-1}, once, one).moments, 0.5),
            1e-12);
}

}  // namespace
}  // namespace ucvt
