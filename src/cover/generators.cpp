#include "cover/generators.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "cover/short_generators.h"
#include "triangulation/frame.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Base vertices tried; the shortest polygon wins.
constexpr std::size_t bases_tried = 16;

DeckSystem system_at(const UniformSurface& t, const std::vector<PreciseComplex>& half_direction,
                     Vertex base) {
  DeckSystem out;
  out.kappa = t.space().kappa;
  out.cut = cut_graph(t, base);
  Holonomy h = holonomy(t, half_direction, out.cut);
  out.projection = project_to_relation(out.kappa, out.cut.rim, h.loop);
  out.frame = std::move(h.frame);
  out.loop = std::move(h.loop);
  if (out.projection.converged) {
    out.canonical = shortened(out.kappa, collect_handles(out.kappa, out.cut.rim, out.loop),
                              WordReducer(out.cut.rim), out.loop);
  }
  return out;
}

/// The rim's distance from the identity when the maps are given as 3 x 3 matrices of doubles.
double matrix_residual(const DeckGroup& group) {
  std::array<std::array<DoubleDouble, 3>, 3> total{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const std::int32_t x : group.relator) {
    const ModelMatrix& g = group.generators[static_cast<std::size_t>(std::abs(x) - 1)].matrix;
    const ModelMatrix m = x > 0 ? g : inverse_isometry(group.kappa, g);
    auto next = total;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        next[i][j] = total[i][0] * DoubleDouble{m[0][j]} + total[i][1] * DoubleDouble{m[1][j]} +
                     total[i][2] * DoubleDouble{m[2][j]};
      }
    }
    total = next;
  }
  double out = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      out = std::max(out, std::abs(total[i][j].value() - (i == j ? 1 : 0)));
    }
  }
  return out;
}

/// The angle from the direction of one point to that of another, counterclockwise, in (0, 2 pi].
double angle_between(const Offset& from, const Offset& to) {
  const double turn = std::atan2(cross(from, to), from.x * to.x + from.y * to.y);
  return turn > 0 ? turn : turn + 2 * std::numbers::pi;
}

/// The sum of the polygon's angles, every one in the frame of its own corner.
double angle_sum(const DeckSystem& s, const Word& relator) {
  double sum = 0;
  for (std::size_t i = 0; i < relator.size(); ++i) {
    const std::int32_t before = relator[(i + relator.size() - 1) % relator.size()];
    sum += angle_between(image_of_origin(map_of(s.kappa, {relator[i]}, s.canonical.map)),
                         image_of_origin(map_of(s.kappa, {-before}, s.canonical.map)));
  }
  return sum;
}

}  // namespace

DeckSystem deck_system(const UniformSurface& t) {
  if (t.space().kappa > 0) {
    throw InvalidInput(
        "a sphere is its own universal cover and has no deck group; take a surface "
        "of genus 1 or more");
  }
  const auto half_direction = half_directions(t);
  DeckSystem best;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Vertex base : spread_vertices(t, bases_tried)) {
    DeckSystem system = system_at(t, half_direction, base);
    const double length = system.projection.converged
                              ? total_length(system.kappa, system.canonical.map)
                              : std::numeric_limits<double>::infinity();
    if (length < shortest) {
      shortest = length;
      best = std::move(system);
    }
  }
  if (!(shortest < std::numeric_limits<double>::infinity())) {
    throw NumericalError("the deck transformations of this surface do not close up in 32 digits");
  }
  return best;
}

std::vector<DeckMap> corner_maps(double kappa, const Word& sides,
                                 const std::vector<DeckMap>& generator) {
  std::vector<DeckMap> out(1);
  for (const std::int32_t x : sides) {
    out.push_back(product(kappa, out.back(), map_of(kappa, {x}, generator)));
  }
  return out;
}

DeckGroup deck_group(const DeckSystem& s) {
  DeckGroup out;
  out.kappa = s.kappa;
  out.genus = static_cast<int>(s.canonical.map.size() / 2);
  out.base = s.cut.base.id;
  out.relator = commutators(s.canonical.map.size());
  std::vector<DeckMap> in_doubles;
  for (std::size_t i = 0; i < s.canonical.map.size(); ++i) {
    const DeckMap& m = s.canonical.map[i];
    in_doubles.push_back(rounded(m));
    out.generators.push_back({fmt::format("{}{}", i % 2 == 0 ? 'a' : 'b', i / 2 + 1),
                              s.canonical.word[i],
                              model_matrix(s.kappa, m),
                              {m.a.re.value(), m.a.im.value()},
                              {m.b.re.value(), m.b.im.value()},
                              displacement(s.kappa, m)});
  }
  const auto corners = corner_maps(s.kappa, out.relator, s.canonical.map);
  for (std::size_t i = 0; i < out.relator.size(); ++i) {
    const Offset p = image_of_origin(corners[i]);
    out.polygon.push_back({p.x, p.y, model_z({s.kappa}, p)});
    out.paired_side.push_back(static_cast<std::int32_t>(i % 4 < 2 ? i + 2 : i - 2));
  }
  GroupCertificate& c = out.certificate;
  c.residual_before = s.projection.before;
  c.largest_change = s.projection.change;
  c.residual = off_identity(corners.back());
  c.residual_moebius = off_identity(map_of(s.kappa, out.relator, in_doubles));
  c.residual_matrix = matrix_residual(out);
  c.angle_sum = angle_sum(s, out.relator);
  return out;
}

std::vector<Word> neighbour_words(int genus) {
  // The copy whose corner j is the polygon's corner k is corner_k corner_j^-1; round corner k follow
  // each other the j of the corners' cycle.
  const Word relator = commutators(static_cast<std::size_t>(2 * genus));
  const std::size_t n = relator.size();
  std::vector<Word> corner(1);
  for (const std::int32_t x : relator) {
    corner.push_back(product({corner.back(), {x}}));
  }
  const auto paired = [](std::size_t i) { return i % 4 < 2 ? i + 2 : i - 2; };
  std::vector<Word> out;
  for (std::size_t k = 0; k < n; ++k) {
    // Across the side that begins at corner j lies a copy, there the end of the paired side.
    for (std::size_t j = (paired(k) + 1) % n; j != k; j = (paired(j) + 1) % n) {
      // The last of them lies across the side before corner k, and was the first at that corner.
      if ((paired(j) + 1) % n != k) {
        out.push_back(product({corner[k], inverse(corner[j])}));
      }
    }
  }
  return out;
}

}  // namespace ucvt
