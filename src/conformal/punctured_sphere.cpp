#include "conformal/punctured_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>

#include "conformal/moebius_balance.h"
#include "conformal/plane_layout.h"

namespace ucvt {
namespace {

/// Punctures tried before giving up, Newton's steps for each, and the angle by which a link vertex
/// must turn inwards before it is let go: less than that the sphere itself mends.
constexpr std::size_t max_punctures = 64;
constexpr int max_inverted_steps = 10, max_plane_steps = 500, max_polish_steps = 10;
constexpr double reflex_tolerance = 1e-3;

/// Angle error in the plane, radians: the sphere itself mends the rest.
constexpr double plane_tolerance = 1e-6;

/// Least angle sum below pi opposite to the edges of a vertex' star, or nothing when the star
/// touches itself: how safely Delaunay the star is.
std::optional<double> star_safety(const IntrinsicTriangulation& t, Vertex v) {
  const Connectivity& c = t.connectivity;
  std::vector<Vertex> link;
  double safety = 4;
  const auto doubled_cosine = [&](Halfedge h) {
    const double a = t.log_length[h.next().index()], b = t.log_length[h.prev().index()];
    return std::exp(a - b) + std::exp(b - a) - std::exp(2 * t.log_length[h.index()] - a - b);
  };
  c.for_outgoing(v, [&](Halfedge h) {
    link.push_back(c.head(h));
    safety = std::min(safety, doubled_cosine(h) + doubled_cosine(c.twin(h)));
  });
  std::sort(link.begin(), link.end());
  const bool simple = std::adjacent_find(link.begin(), link.end()) == link.end() &&
                      !std::binary_search(link.begin(), link.end(), v) && link.size() >= 3;
  if (!simple) {
    return std::nullopt;
  }
  return safety;
}

std::vector<Vertex> punctures_by_safety(const IntrinsicTriangulation& t) {
  std::vector<std::pair<double, Vertex>> ranked;
  for (std::size_t v = 0; v < t.connectivity.vertex_count(); ++v) {
    const Vertex vertex{static_cast<std::int32_t>(v)};
    if (const auto safety = star_safety(t, vertex)) {
      ranked.push_back({-*safety, vertex});
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<Vertex> out;
  for (const auto& [safety, v] : ranked) {
    out.push_back(v);
  }
  return out;
}

/// About the distance from `source` over the surface.
std::vector<double> distances(const IntrinsicTriangulation& t, Vertex source) {
  std::vector<double> out(t.connectivity.vertex_count(), HUGE_VAL);
  using Entry = std::pair<double, Vertex>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto length = [&](Halfedge h) { return std::exp(t.log_length[h.index()]); };
  // Of the vertex opposite to h, over a source laid out beyond h at its ends' distances.
  const auto across = [&](Halfedge h) {
    const double base = length(h), left = length(h.prev()), right = length(h.next());
    const double i = out[t.connectivity.origin(h).index()];
    const double j = out[t.connectivity.head(h).index()];
    const double x = (base + (left - right) * ((left + right) / base)) / 2;
    const double source_x = (base + (i - j) * ((i + j) / base)) / 2;
    const double y = std::sqrt(std::max(0.0, left * left - x * x));
    const double depth = std::sqrt(std::max(0.0, i * i - source_x * source_x));
    const double crossing = (x * depth + source_x * y) / (y + depth);
    return crossing > 0 && crossing < base ? std::hypot(x - source_x, y + depth) : HUGE_VAL;
  };
  out[source.index()] = 0;
  queue.push({0, source});
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > out[v.index()]) {
      continue;
    }
    const auto lower = [&](Vertex w, double by) {
      if (by < out[w.index()]) {
        out[w.index()] = by;
        queue.push({by, w});
      }
    };
    t.connectivity.for_outgoing(v, [&](Halfedge h) {
      lower(t.connectivity.head(h), out[v.index()] + length(h));
      lower(t.connectivity.head(h.next()), across(h));
      lower(t.connectivity.head(h), across(h.prev()));
    });
  }
  return out;
}

/// The flat metric of the plane for one puncture.
class PuncturedPlane {
 public:
  /// Where Newton's method starts: from the input's metric, or from that inverted at the puncture.
  enum class Start : char { Input, Inverted };

  PuncturedPlane(IntrinsicTriangulation& t, std::vector<double>& u, Vertex puncture, Start start)
      : t_(t), u_(u), puncture_(puncture), solver_(Space{0}, t, u, roles()) {
    double mean = 0;
    int degree = 0;
    t_.connectivity.for_outgoing(puncture_, [&](Halfedge h) {
      mean += 2 * t_.log_length[h.index()];
      ++degree;
    });
    pin_ = mean / degree;
    solver_.set_pin(pin_);
    u_.assign(u_.size(), 0);
    if (start == Start::Inverted) {
      const std::vector<double> distance = distances(t_, puncture_);
      for (std::size_t v = 0; v < u_.size(); ++v) {
        u_[v] = v == puncture_.index() ? 0 : pin_ - 2 * std::log(distance[v]);
      }
    }
    t_.connectivity.for_outgoing(puncture_, [&](Halfedge h) { hold(h); });
  }

  /// Gives up after `limit` steps or changes of the link.
  MetricSolver::Result solve(int limit, const MetricSolver::Watch& watch) {
    MetricSolver::Result total;
    for (int round = 0; round < limit && total.iterations < limit; ++round) {
      const auto result = solver_.solve(plane_tolerance, limit - total.iterations, watch);
      total.iterations += result.iterations;
      total.max_angle_error = result.max_angle_error;
      if (!solver_.link_is_simple() || result.max_angle_error > plane_tolerance) {
        return total;
      }
      if (!release_reflex()) {
        total.converged = true;
        return total;
      }
    }
    return total;
  }

  [[nodiscard]] double pin() const { return pin_; }

 private:
  [[nodiscard]] std::vector<VertexRole> roles() const {
    std::vector<VertexRole> role(t_.connectivity.vertex_count(), VertexRole::Solved);
    role[puncture_.index()] = VertexRole::Puncture;
    t_.connectivity.for_outgoing(
        puncture_, [&](Halfedge h) { role[t_.connectivity.head(h).index()] = VertexRole::Held; });
    return role;
  }

  void hold(Halfedge from_puncture) {
    const Vertex v = t_.connectivity.head(from_puncture);
    u_[v.index()] = pin_ - 2 * t_.log_length[from_puncture.index()];
  }

  /// Lets link vertices go where the polygon is not convex; true when there were any.
  bool release_reflex() {
    const std::vector<double> angle = solver_.angle_sums();
    const Connectivity& c = t_.connectivity;
    std::vector<Halfedge> reflex;
    int degree = 0;
    c.for_outgoing(puncture_, [&](Halfedge h) {
      ++degree;
      const double excess = angle[c.head(h).index()] - std::numbers::pi;
      // Neighbours wait for the next round: their own angles change.
      const bool after_another = !reflex.empty() && c.rotate(reflex.back()) == h;
      if (excess > reflex_tolerance && !after_another) {
        reflex.push_back(h);
      }
    });
    bool any = false;
    for (const Halfedge h : reflex) {
      if (degree-- <= 3) {
        break;
      }
      const Vertex v = c.head(h);
      const double excess = angle[v.index()] - std::numbers::pi;
      ptolemy_flip(t_, h);
      solver_.set_role(v, VertexRole::Solved);
      // The new triangle is flat as yet; give it room.
      u_[v.index()] += std::clamp(excess / 2, 1e-6, 0.2);
      any = true;
    }
    return any;
  }

  IntrinsicTriangulation& t_;
  std::vector<double>& u_;
  Vertex puncture_;
  MetricSolver solver_;
  double pin_ = 0;
};

Vertex nearest(const std::vector<PlanePoint>& p, Vertex puncture, const StereographicFrame& to) {
  Vertex best;
  double least = HUGE_VAL;
  for (std::size_t v = 0; v < p.size(); ++v) {
    const double d = std::hypot(p[v].x - to.centre.x, p[v].y - to.centre.y);
    if (v != puncture.index() && d < least) {
      least = d, best = {static_cast<std::int32_t>(v)};
    }
  }
  return best;
}

/// A scale that separates the nearer half of the weight about `root` from the rest.
double median_distance(const std::vector<PlanePoint>& p, const std::vector<double>& weight,
                       Vertex puncture) {
  std::vector<std::pair<double, double>> by_distance;
  double total = 0;
  for (std::size_t v = 0; v < p.size(); ++v) {
    if (v == puncture.index()) {
      continue;
    }
    by_distance.push_back({std::hypot(p[v].x, p[v].y), weight[v]});
    total += weight[v];
  }
  std::sort(by_distance.begin(), by_distance.end());
  double sum = 0;
  for (const auto& [d, w] : by_distance) {
    sum += w;
    if (sum >= total / 2 && d > 0) {
      return d;
    }
  }
  return by_distance.back().first;
}

/// The puncture, which is the north pole, the vertex nearest to the equator, and the one farthest
/// from the plane of those two.
std::array<Vertex, 3> apart_on_sphere(const std::vector<PlanePoint>& p, Vertex puncture,
                                      const StereographicFrame& frame) {
  std::array<Vertex, 3> out{puncture, {}, {}};
  PlanePoint axis;
  for (std::size_t place = 1; place < 3; ++place) {
    double best = -1;
    for (std::size_t v = 0; v < p.size(); ++v) {
      const Vertex vertex{static_cast<std::int32_t>(v)};
      if (vertex == puncture || vertex == out[1]) {
        continue;
      }
      const double x = (p[v].x - frame.centre.x) / frame.scale;
      const double y = (p[v].y - frame.centre.y) / frame.scale;
      const double r = std::hypot(x, y), horizontal = r < 1 ? r / (1 + r * r) : 1 / (r + 1 / r);
      // Twice this is the distance from the polar axis, then from the plane through it and out[1].
      const double score =
          place == 1 ? horizontal : horizontal * std::abs(axis.x * y - axis.y * x) / r;
      if (score > best) {
        best = score;
        out[place] = vertex;
        if (place == 1) {
          axis = {x / r, y / r};
        }
      }
    }
  }
  return out;
}

/// Lays the plane out about the barycentre and moves the log scales onto the sphere. Returns three
/// vertices in about orthogonal directions there; nothing when positions are no numbers any more.
std::optional<std::array<Vertex, 3>> wrap_onto_sphere(const IntrinsicTriangulation& t,
                                                      std::vector<double>& u, Vertex puncture,
                                                      double pin,
                                                      const std::vector<double>& weight) {
  // Positions are accurate relative to their distance from the root of the layout, so the root has
  // to be at the middle of the weight: find it, lay out again about it, until it stays.
  Vertex root{puncture.id == 0 ? 1 : 0};
  std::vector<PlanePoint> p;
  StereographicFrame frame;
  for (int round = 0; round < 10; ++round) {
    p = lay_out_plane(t, u, puncture, root);
    frame = {{0, 0}, median_distance(p, weight, puncture)};
    frame = conformal_barycentre(p, weight, puncture.index(), frame);
    const Vertex next = nearest(p, puncture, frame);
    if (next.id < 0) {
      return std::nullopt;
    }
    if (next == root) {
      break;
    }
    root = next;
  }
  for (std::size_t v = 0; v < p.size(); ++v) {
    if (v == puncture.index()) {
      continue;
    }
    const double x = (p[v].x - frame.centre.x) / frame.scale;
    const double y = (p[v].y - frame.centre.y) / frame.scale;
    const double r = std::hypot(x, y);
    // log(2 / (scale (1 + r^2))), also where r^2 would overflow.
    const double log_1_r2 = r < 1e8 ? std::log1p(r * r) : 2 * std::log(r);
    u[v] += std::numbers::ln2 - std::log(frame.scale) - log_1_r2;
  }
  u[puncture.index()] = std::numbers::ln2 + std::log(frame.scale) - pin;
  const auto apart = apart_on_sphere(p, puncture, frame);
  if (apart[1].id < 0 || apart[2].id < 0) {
    return std::nullopt;
  }
  return apart;
}

/// Newton's method on the sphere itself takes off what the way there left: rounding of the layout,
/// and link vertices so nearly straight that neither side of the bound holds them to 1e-10.
MetricSolver::Result polish(IntrinsicTriangulation& t, std::vector<double>& u,
                            const std::array<Vertex, 3>& held, const MetricSolver::Watch& watch) {
  std::vector<VertexRole> role(u.size(), VertexRole::Solved);
  for (const Vertex v : held) {
    role[v.index()] = VertexRole::Held;
  }
  return MetricSolver({1}, t, u, std::move(role)).solve(1e-10, max_polish_steps, watch);
}

}  // namespace

MetricSolver::Result solve_sphere(IntrinsicTriangulation& t, std::vector<double>& u,
                                  const std::vector<double>& weight,
                                  const MetricSolver::Enough& enough,
                                  const MetricSolver::Watch& watch) {
  MetricSolver::Result out;
  const auto candidates = punctures_by_safety(t);
  const std::size_t attempts = std::min(candidates.size(), max_punctures) + 1;
  for (std::size_t attempt = 0; attempt < attempts && !candidates.empty(); ++attempt) {
    // The first puncture gets a few steps from a good start before the safe one.
    const bool first = attempt == 0;
    const Vertex puncture = candidates[first ? 0 : attempt - 1];
    u.assign(t.connectivity.vertex_count(), 0);
    if (!first) {
      MetricSolver(Space{0}, t, u, std::vector<VertexRole>(u.size(), VertexRole::Held))
          .flip_to_delaunay();
      if (!star_safety(t, puncture)) {
        continue;
      }
    }
    using Start = PuncturedPlane::Start;
    PuncturedPlane plane(t, u, puncture, first ? Start::Inverted : Start::Input);
    const auto result = plane.solve(first ? max_inverted_steps : max_plane_steps, watch);
    out.iterations += result.iterations;
    out.max_angle_error = result.max_angle_error;
    if (!result.converged) {
      continue;
    }
    const auto apart = wrap_onto_sphere(t, u, puncture, plane.pin(), weight);
    if (!apart) {
      continue;
    }
    if (enough(u)) {
      out.converged = true;
      return out;
    }
    const auto polished = polish(t, u, *apart, watch);
    out.iterations += polished.iterations;
    out.max_angle_error = polished.max_angle_error;
    out.converged = polished.converged;
    if (out.converged) {
      return out;
    }
  }
  return out;
}

}  // namespace ucvt
