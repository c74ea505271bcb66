// The universal cover of a uniformized surface: its deck group, a fundamental polygon, layouts.
//
// The group is given by canonical generators a1 b1 ... ag bg, geodesic loops through one vertex of T
// that cut the surface into a 4g-gon with the sides a1 b1 a1^-1 b1^-1 .... Everything is relative to
// that vertex' frame: the model's origin is a lift of the vertex. docs/group.md.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ucvt/spaces.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// How points of the cover are given as two numbers. Torus: all but Klein and Plane refuse; both are
/// the plane's own coordinates.
enum class CoverCoordinates : char { Klein, Poincare, HalfPlane, Plane };

/// Throws InvalidInput unless surfaces of this genus have a deck group, and a layout in these
/// coordinates.
void require_coordinates(int genus, CoverCoordinates coordinates);

struct DeckGenerator {
  std::string name;                ///< "a1", "b1", "a2", ...
  std::vector<std::int32_t> word;  ///< in the greedy loops, letters +-(i + 1)
  ModelMatrix matrix{};            ///< of the linear model
  std::array<double, 2> a{}, b{};  ///< w -> (a w + b)/(conj(b) w + conj(a)) on the Poincare disk
  double length = 0;               ///< of the geodesic loop
};

/// What was checked. Residuals are the largest number by which the product of commutators differs
/// from the identity, multiplied with 32 digits.
struct GroupCertificate {
  double residual_before = 0;   ///< of the greedy loops' relation, developed from T's chords
  double largest_change = 0;    ///< of a greedy loop, relative, to make that relation hold
  double residual = 0;          ///< of a, b with 32 digits (as the JSON file has them)
  double residual_moebius = 0;  ///< of a, b rounded to doubles
  double residual_matrix = 0;   ///< of the matrices rounded to doubles
  double angle_sum = 0;         ///< of the geodesic 4g-gon: 2 pi
};

struct DeckGroup {
  double kappa = 0;
  int genus = 0;
  std::int32_t base = 0;                  ///< vertex of T
  std::vector<DeckGenerator> generators;  ///< a1, b1, a2, b2, ...
  std::vector<std::int32_t> relator;      ///< the 4g sides in order, letters +-(i + 1)
  std::vector<ModelPoint> polygon;        ///< corners, counterclockwise; side i from i to i + 1
  std::vector<std::int32_t> paired_side;  ///< by side: the one it is glued to, backwards
  GroupCertificate certificate;
};

/// An image of the fundamental polygon: a word in the generators and its map.
struct DeckCopy {
  std::vector<std::int32_t> word;
  ModelMatrix matrix{};
  std::array<double, 2> a{}, b{};
};

struct CoverData;

/// The universal cover of a uniformized surface; a cheap handle on an immutable value.
class Cover {
 public:
  /// Throws InvalidInput for genus 0, NumericalError when doubles cannot hold the group.
  explicit Cover(UniformizedSurface surface);

  [[nodiscard]] const DeckGroup& group() const;

  /// The 16 g^2 - 8 g images of the polygon that share a side or a corner with it.
  [[nodiscard]] std::vector<DeckCopy> neighbours() const;

  /// Writes the group as JSON (docs/group.md). Throws IoError, as the others.
  void write_group(const std::string& path) const;

  /// Writes the generators as polylines on the input surface, an OBJ file with `l` lines.
  void write_loops(const std::string& path) const;

  /// Writes T cut open as an OBJ file with texture coordinates. Throws InvalidInput when the
  /// coordinates do not belong to the geometry.
  void write_uv(const std::string& path, CoverCoordinates coordinates) const;

  /// For the library's own use.
  [[nodiscard]] const CoverData& data() const { return *data_; }

 private:
  std::shared_ptr<const CoverData> data_;
};

}  // namespace ucvt
