// rapidcheck generators for numbers and points of the three spaces.
#pragma once

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "space/offset.h"

namespace ucvt::oracle {

/// Uniform on a fine grid in [low, high]; shrinks towards the middle.
inline double number(double low, double high) {
  const auto n = *rc::gen::inRange<std::int64_t>(-1000000, 1000001);
  return (low + high) / 2 + (high - low) / 2 * static_cast<double>(n) * 1e-6;
}

inline Space space() {
  return {static_cast<double>(*rc::gen::inRange(-1, 2))};
}

/// A power of ten from 1e-12 to 1.
inline double scale() {
  return std::pow(10.0, -*rc::gen::inRange(0, 13));
}

/// A point with central coordinates up to `size` 0.7 in each direction.
inline Offset point(Space s, double size) {
  return from_central(s, size * number(-0.69, 0.69), size * number(-0.69, 0.69));
}

inline double norm(const Offset& p) {
  return std::hypot(p.x, p.y);
}

/// How far a point is off the quadric, relative to its h.
inline double off_quadric(Space s, const Offset& p) {
  return std::abs(p.x * p.x + p.y * p.y + s.kappa * p.h * p.h - 2 * p.h) / (2 * p.h);
}

}  // namespace ucvt::oracle
