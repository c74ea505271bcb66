#include "cover/holonomy.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace ucvt {
namespace {

/// Newton's steps of the projection; it converges quadratically.
constexpr int most_iterations = 50;

/// (cos, sin) of half the angle at a halfedge's origin, in its face.
PreciseComplex half_angle(const UniformSurface& t, Halfedge h) {
  const DoubleDouble a{t.chord(h)}, b{t.chord(h.prev())}, c{t.chord(h.next())};
  const DoubleDouble kappa{t.space().kappa}, half{0.5}, one{1};
  // docs/tangent-quadric.md, "Triangles from their chords".
  const DoubleDouble heron = (a + b + c) * (a + b - c) * (c + (a - b)) * (c - (a - b));
  const DoubleDouble det2 = DoubleDouble{0.25} * (heron - kappa * a * a * b * b * c * c);
  const DoubleDouble ha = half * a * a, hb = half * b * b;
  const DoubleDouble cosine = ha + hb - half * c * c - kappa * ha * hb, sine = sqrt(det2);
  const DoubleDouble norm = sqrt(cosine * cosine + det2);
  const bool sharp = cosine.high > 0;
  const DoubleDouble large =
      sqrt(half * (one + (sharp ? cosine : -cosine) / norm));  // the larger of the two
  const DoubleDouble small = half * sine / (norm * large);
  return sharp ? PreciseComplex{large, small} : PreciseComplex{small, large};
}

/// From the frame at h's origin to the frame at its head.
DeckMap step(const UniformSurface& t, const std::vector<PreciseComplex>& direction, Halfedge h) {
  const double kappa = t.space().kappa;
  const DoubleDouble half = DoubleDouble{0.5} * DoubleDouble{t.chord(h)};
  const DeckMap along{{sqrt(DoubleDouble{1} - DoubleDouble{kappa} * half * half), 0}, {half, 0}};
  // The twin looks back: a half turn.
  const PreciseComplex back =
      PreciseComplex{0, 1} * conj(direction[t.connectivity().twin(h).index()]);
  return product(kappa, product(kappa, {direction[h.index()], {}}, along), {back, {}});
}

/// i theta and beta of a tangent vector at the identity, as numbers of (a, b).
using Tangent = std::array<DoubleDouble, 3>;

/// P X P^-1.
Tangent conjugated(double kappa, const DeckMap& p, const Tangent& x) {
  const DeckMap m = product(kappa, product(kappa, p, {{0, x[0]}, {x[1], x[2]}}), inverse(p));
  return {m.a.im, m.b.re, m.b.im};
}

/// Columns of the rim's derivative by loop i, moved as X_i (1 + x).
std::vector<std::array<Tangent, 3>> rim_derivative(double kappa, const Word& rim,
                                                   const std::vector<DeckMap>& loop) {
  std::vector<std::array<Tangent, 3>> out(loop.size());
  DeckMap before;
  for (const std::int32_t x : rim) {
    const auto i = static_cast<std::size_t>(std::abs(x) - 1);
    const DeckMap after = product(kappa, before, x > 0 ? loop[i] : inverse(loop[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      Tangent unit{};
      unit[k] = 1;
      const Tangent change = conjugated(kappa, x > 0 ? after : before, unit);
      for (std::size_t c = 0; c < 3; ++c) {
        out[i][k][c] = out[i][k][c] + (x > 0 ? change[c] : -change[c]);
      }
    }
    before = after;
  }
  return out;
}

/// Solves a 3 x 3 system; the pivot is the largest of its column.
Tangent solved(std::array<Tangent, 3> m, Tangent r) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < 3; ++k) {
      pivot = std::abs(m[k][i].high) > std::abs(m[pivot][i].high) ? k : pivot;
    }
    std::swap(m[i], m[pivot]);
    std::swap(r[i], r[pivot]);
    for (std::size_t k = i + 1; k < 3; ++k) {
      const DoubleDouble f = m[k][i] / m[i][i];
      for (std::size_t j = i; j < 3; ++j) {
        m[k][j] = m[k][j] - f * m[i][j];
      }
      r[k] = r[k] - f * r[i];
    }
  }
  for (std::size_t i = 3; i-- > 0;) {
    for (std::size_t j = i + 1; j < 3; ++j) {
      r[i] = r[i] - m[i][j] * r[j];
    }
    r[i] = r[i] / m[i][i];
  }
  return r;
}

/// One step of Newton's method, of least squares.
void newton_step(double kappa, const Word& rim, const DeckMap& off, std::vector<DeckMap>& loop) {
  const auto columns = rim_derivative(kappa, rim, loop);
  std::array<Tangent, 3> normal{};
  for (const auto& three : columns) {
    for (const Tangent& x : three) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          normal[i][j] = normal[i][j] + x[i] * x[j];
        }
      }
    }
  }
  const Tangent multiplier = solved(normal, {-off.a.im, -off.b.re, -off.b.im});
  for (std::size_t i = 0; i < loop.size(); ++i) {
    Tangent x{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        x[k] = x[k] + columns[i][k][c] * multiplier[c];
      }
    }
    loop[i] =
        normalized(kappa, product(kappa, loop[i], normalized(kappa, {{1, x[0]}, {x[1], x[2]}})));
  }
}

double largest_number(const DeckMap& m) {
  return std::max(
      {std::abs(m.a.re.high), std::abs(m.a.im.high), std::abs(m.b.re.high), std::abs(m.b.im.high)});
}

double largest_change(const std::vector<DeckMap>& from, const std::vector<DeckMap>& to) {
  double out = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    out = std::max(out, difference(from[i], to[i]) / largest_number(from[i]));
  }
  return out;
}

}  // namespace

std::vector<PreciseComplex> half_directions(const UniformSurface& t) {
  const Connectivity& c = t.connectivity();
  std::vector<PreciseComplex> out(c.halfedge_count());
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    PreciseComplex turn{1, 0};
    c.for_outgoing({static_cast<std::int32_t>(v)}, [&](Halfedge h) {
      out[h.index()] = turn;
      turn = turn * half_angle(t, h);
    });
  }
  return out;
}

Holonomy holonomy(const UniformSurface& t, const std::vector<PreciseComplex>& half_direction,
                  const CutGraph& cut) {
  const double kappa = t.space().kappa;
  const Connectivity& c = t.connectivity();
  Holonomy out;
  out.frame.resize(c.vertex_count());
  for (const Vertex v : cut.by_distance) {
    const Halfedge home = cut.towards_base[v.index()];
    if (home.id >= 0) {
      out.frame[v.index()] =
          product(kappa, out.frame[c.head(home).index()], step(t, half_direction, c.twin(home)));
    }
  }
  for (const Halfedge h : cut.edge) {
    const DeckMap there =
        product(kappa, out.frame[c.origin(h).index()], step(t, half_direction, h));
    out.loop.push_back(
        normalized(kappa, product(kappa, there, inverse(out.frame[c.head(h).index()]))));
  }
  return out;
}

DeckMap map_of(double kappa, const Word& word, const std::vector<DeckMap>& generator) {
  DeckMap out;
  for (const std::int32_t x : word) {
    const DeckMap& g = generator[static_cast<std::size_t>(std::abs(x) - 1)];
    out = product(kappa, out, x > 0 ? g : inverse(g));
  }
  return out;
}

RelationFit project_to_relation(double kappa, const Word& rim, std::vector<DeckMap>& loop) {
  const std::vector<DeckMap> start = loop;
  DeckMap off = map_of(kappa, rim, loop);
  RelationFit out{off_identity(off), 0, 0, 0, false};
  if (kappa == 0) {
    for (DeckMap& m : loop) {
      // The image of the origin stays; the turn goes.
      m = {{1, 0}, m.a * m.b};
    }
    out.after = off_identity(map_of(kappa, rim, loop));
    out.change = largest_change(start, loop);
    out.converged = true;
    return out;
  }
  out.after = out.before;
  while (out.iterations < most_iterations) {
    std::vector<DeckMap> next = loop;
    newton_step(kappa, rim, normalized(kappa, off), next);
    const DeckMap left = map_of(kappa, rim, next);
    ++out.iterations;
    if (!(off_identity(left) < out.after)) {
      break;
    }
    loop = std::move(next);
    off = left;
    out.after = off_identity(off);
  }
  out.change = largest_change(start, loop);
  out.converged = out.after < 1e-12;
  return out;
}

}  // namespace ucvt
