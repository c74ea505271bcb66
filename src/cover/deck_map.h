// Isometries that preserve orientation, as Moebius maps with numbers of 32 digits.
//
// Notation: w = (x + i y)/(1 + z) is the stereographic coordinate of a model point (the Poincare
// disk; half the plane's own coordinate when kappa = 0). An isometry is
//     w -> (a w + b)/(-kappa conj(b) w + conj(a)),   |a|^2 + kappa |b|^2 = 1,
// up to the sign of (a, b); products of such pairs are products of maps, for the three spaces at
// once. Its entries grow like exp(r/2) with the distance r it moves the origin by, the square root of
// a 3 x 3 matrix' entries. docs/group.md.
#pragma once

#include <array>

#include "cover/double_double.h"
#include "space/offset.h"
#include "ucvt/spaces.h"

namespace ucvt {

struct PreciseComplex {
  DoubleDouble re, im;
};

inline PreciseComplex conj(const PreciseComplex& p) {
  return {p.re, -p.im};
}
inline PreciseComplex operator+(const PreciseComplex& p, const PreciseComplex& q) {
  return {p.re + q.re, p.im + q.im};
}
inline PreciseComplex operator*(const PreciseComplex& p, const PreciseComplex& q) {
  return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
}
inline PreciseComplex operator*(const DoubleDouble& s, const PreciseComplex& p) {
  return {s * p.re, s * p.im};
}
inline DoubleDouble norm2(const PreciseComplex& p) {
  return p.re * p.re + p.im * p.im;
}

/// An isometry of the model; as it stands, the identity.
struct DeckMap {
  PreciseComplex a{1, 0}, b{0, 0};
};

/// The map that does `second` first: frames are carried along a path by factors from the right.
DeckMap product(double kappa, const DeckMap& first, const DeckMap& second);

inline DeckMap inverse(const DeckMap& m) {
  return {conj(m.a), {-m.b.re, -m.b.im}};
}

/// The same map with |a|^2 + kappa |b|^2 = 1 again, and Re a >= 0.
DeckMap normalized(double kappa, const DeckMap& m);

/// Both numbers rounded to doubles.
DeckMap rounded(const DeckMap& m);

/// Distance that the model's origin moves by.
double displacement(double kappa, const DeckMap& m);

/// Distance between two maps, the signs of which may differ: the largest of the differences of
/// numbers.
double difference(const DeckMap& m, const DeckMap& n);

/// How far the map is from the identity: the same.
double off_identity(const DeckMap& m);

/// The linear map of the model, row-major.
using PreciseMatrix = std::array<std::array<DoubleDouble, 3>, 3>;
PreciseMatrix precise_matrix(double kappa, const DeckMap& m);
ModelMatrix model_matrix(double kappa, const DeckMap& m);

/// The image of the origin, as an offset from it.
Offset image_of_origin(const DeckMap& m);

}  // namespace ucvt
