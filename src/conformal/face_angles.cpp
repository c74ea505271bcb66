#include "conformal/face_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "space/lane_moments.h"
#include "space/moments.h"

// Lanes are returned by functions that are always inlined: no call depends on how.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace ucvt {
namespace {

/// Half chords with products of four and of six that stay in the range of doubles.
constexpr double least_chord = 1e-60, most_chord = 1e50;

/// Terms of the series of the arc tangent, that end at rounding up to tan(pi/8).
constexpr int arctan_terms = 21;

constexpr double pi = std::numbers::pi;

[[gnu::always_inline]] inline Lanes max(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline Lanes min(const Lanes& a, const Lanes& b) {
  return a > b ? b : a;
}

/// The angle of (x, y), y > 0: between 0 and pi.
[[gnu::always_inline]] inline Lanes angle_of(const Lanes& x, const Lanes& y) {
  const Lanes zero{}, one = zero + 1, far = max(x, -x);
  const Lanes t = min(far, y) / max(far, y);
  // Past tan(pi/8) counted from pi/4.
  const Lanes beyond = t > std::numbers::sqrt2 - 1 ? one : zero;
  const Lanes s = (t - beyond) / (one + beyond * t);
  const Lanes s2 = s * s;
  Lanes sum = zero + 1.0 / (2 * arctan_terms - 1);
  for (int k = arctan_terms - 1; k-- > 0;) {
    sum = 1.0 / (2 * k + 1) - s2 * sum;
  }
  const Lanes small = beyond * (pi / 4) + s * sum;
  const Lanes acute = far > y ? small : pi / 2 - small;
  return x < zero ? pi - acute : acute;
}

/// `face_angles` of faces whose chords are neither tiny nor huge, x by side and face.
UCVT_WIDE bool measure(double kappa, const std::array<Lanes, 3>& x, std::array<Lanes, 3>& angle,
                       std::array<Lanes, 3>& cot) {
  // 16 Area^2 of the triangle of half chords, longest first; the order of the operations matters (Kahan 2014).
  const Lanes longest = max(max(x[0], x[1]), x[2]), shortest = min(min(x[0], x[1]), x[2]);
  const Lanes middle = max(min(x[0], x[1]), min(max(x[0], x[1]), x[2]));
  const Lanes heron = (longest + (middle + shortest)) * (shortest - (longest - middle)) *
                      (shortest + (longest - middle)) * (longest + (middle - shortest));
  const Lanes product = longest * middle * shortest;
  const Lanes s2 = heron - 4 * kappa * product * product;
  Lanes s{};
  bool valid = true;
  for (std::size_t k = 0; k < 4; ++k) {
    valid = valid && s2[k] > 0;
    s[k] = std::sqrt(s2[k]);
  }
  std::array<Lanes, 3> beta;
  for (std::size_t i = 0; i < 3; ++i) {
    const Lanes &a = x[(i + 1) % 3], &b = x[(i + 2) % 3], &c = x[i];
    const Lanes cosine = a * a + (b - c) * (b + c);
    beta[i] = angle_of(cosine, s);
    cot[i] = cosine / s;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    angle[i] = pi - beta[(i + 1) % 3] - beta[(i + 2) % 3];
  }
  return valid;
}

/// The same of one face of any size, from its first number on.
bool measure_one(Space space, const double* x, double* angle, double* cot) {
  // S^2 = 16 Area^2 - 4 kappa a^2 b^2 c^2 of half chords is a quarter of the chords' determinant squared.
  const double s = triangle_determinant(space, {2 * x[0], 2 * x[1], 2 * x[2]}) / 2;
  std::array<double, 3> beta{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = x[(i + 1) % 3], b = x[(i + 2) % 3], c = x[i];
    const double cosine = a * a + (b - c) * (b + c);
    beta[i] = std::atan2(s, cosine);
    cot[i] = cosine / s;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    angle[i] = pi - beta[(i + 1) % 3] - beta[(i + 2) % 3];
  }
  return s > 0;
}

}  // namespace

bool face_angles(Space space, const FourFaces& half, FourFaces& angle, FourFaces& cot) {
  bool valid = true;
  if (!std::ranges::all_of(half, [](double x) { return least_chord < x && x < most_chord; })) {
    for (std::size_t k = 0; k < half.size(); k += 3) {
      valid = measure_one(space, &half[k], &angle[k], &cot[k]) && valid;
    }
    return valid;
  }
  std::array<Lanes, 3> x, a, c;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      x[i][k] = half[3 * k + i];
    }
  }
  valid = measure(space.kappa, x, a, c);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      angle[3 * k + i] = a[i][k], cot[3 * k + i] = c[i][k];
    }
  }
  return valid;
}

}  // namespace ucvt
