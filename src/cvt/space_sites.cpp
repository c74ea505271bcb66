#include "cvt/space_sites.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <tbb/parallel_for.h>

#include "cvt/domain.h"
#include "cvt/multilevel.h"
#include "cvt/polygon_delaunay.h"
#include "triangulation/closed_spaces.h"
#include "triangulation/hilbert_order.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Applies deck transformations to a frame and a point until the point is in the polygon.
void carry_into_polygon(const Domain& domain, Frame& frame, ModelPoint& p) {
  const std::size_t sides = domain.across.size();
  while (sides > 0 && !contains(domain, p)) {
    const CentralPoint k = central_point(p);
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t i = 0; i < sides; ++i) {
      const CentralPoint &a = domain.polygon[i], &b = domain.polygon[(i + 1) % sides];
      const double outside = (b[1] - a[1]) * (k[0] - a[0]) - (b[0] - a[0]) * (k[1] - a[1]);
      if (outside > most) {
        worst = i, most = outside;
      }
    }
    const ModelMatrix back = inverse_isometry(domain.kappa, domain.across[worst]);
    frame.P = transformed(back, frame.P);
    frame.E1 = transformed(back, frame.E1);
    frame = orthonormal(frame);
    p = on_model(domain.kappa, transformed(back, p));
  }
}

void move_into_polygon(const Domain& domain, Frame& frame) {
  ModelPoint p = frame.P;
  carry_into_polygon(domain, frame, p);
}

/// The offset in `from` of the lift of a point in the polygon that lies near `about`.
Offset offset_of_lift(const Domain& domain, const Frame& from, const ModelPoint& p,
                      const Offset& about) {
  const Space s{domain.kappa};
  Frame frame = from;
  ModelPoint near = model_point(frame, about);
  carry_into_polygon(domain, frame, near);
  Offset best = offset_in(frame, p);
  double least = chord2(s, best, about);
  // Near a side the lift may be the one across it.
  const double doubtful = 1e-6 * about.h;
  for (std::size_t i = 0; least > doubtful && i < domain.across.size(); ++i) {
    const Offset other = offset_in(frame, on_model(domain.kappa, transformed(domain.across[i], p)));
    const double distance = chord2(s, other, about);
    if (distance < least) {
      least = distance, best = other;
    }
  }
  // At a corner, several sides away, what is there is kept.
  return least > doubtful ? about : best;
}

ModelPoint unit(const ModelPoint& p) {
  const double length = std::hypot(p[0], p[1], p[2]);
  return {p[0] / length, p[1] / length, p[2] / length};
}

/// Of a step that leads out of a polygon: less is not tried.
constexpr double least_part = 1e-9;

/// Sites in the first block of the insertion.
constexpr std::size_t first_block = 64;

/// A biased randomized insertion order (Amenta, Choi, Rote 2003): blocks of doubling size of sites
/// picked evenly, each along a space-filling curve. Neighbours in the triangulation then have edges
/// of like length at all times, which keeps its offsets exact, and every walk is short.
std::vector<std::size_t> insertion_order(const std::vector<ModelPoint>& sites) {
  std::vector<std::size_t> order = hilbert_order(sites);
  int doublings = 0;
  while ((first_block << doublings) < sites.size()) {
    ++doublings;
  }
  // Block 0 gets one site in 2^doublings, the last one half of them.
  const auto block = [&](std::size_t i) {
    const std::uint64_t random = (i + 1) * 0x9E3779B97F4A7C15u;
    const std::uint64_t mixed = (random ^ random >> 32) * 0xD6E8FEB86659FD93u;
    return std::max(0, doublings - std::countl_zero(mixed ^ mixed >> 32));
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return block(a) < block(b); });
  return order;
}

double distance(Space s, const Offset& p) {
  return length_of_chord(s, std::sqrt(2 * p.h));
}

class ClosedSites : public SpaceSites {
 public:
  ClosedSites(const Domain& domain, const std::vector<ModelPoint>& sites)
      : ClosedSites(domain, triangulate_closed(domain), sites) {}

  void cell(std::size_t i, SiteCell& out) const override {
    const Connectivity& c = d_.connectivity();
    const Space s = d_.space();
    out.corner.clear();
    out.degree = 0;
    double least = HUGE_VAL;
    c.for_outgoing({static_cast<std::int32_t>(i)}, [&](Halfedge h) {
      const Offset& a = d_.offset(h);
      least = std::min(least, a.h);
      const Central k = circumcentre(a, d_.offset(c.rotate(h)));
      out.corner.push_back(from_central(s, k.x, k.y));
      ++out.degree;
    });
    out.nearest = distance(s, {0, 0, least});
  }

  void move(const std::vector<Offset>& target) override {
    std::vector<Offset> reached(target.size());
    for (std::size_t i = 0; i < target.size(); ++i) {
      reached[i] = d_.move({static_cast<std::int32_t>(i)}, target[i]);
    }
    tbb::parallel_for(std::size_t{0}, frames_.size(), [&](std::size_t i) {
      frames_[i] = orthonormal(carried(frames_[i], reached[i]));
      move_into_polygon(domain_, frames_[i]);
    });
    correct_offsets(frames_);
    d_.make_delaunay();
  }

  void save() override {
    SpaceSites::save();
    saved_d_ = d_;
  }
  void restore() override {
    SpaceSites::restore();
    d_ = *saved_d_;
  }

  [[nodiscard]] std::vector<ModelPoint> middles(std::size_t most) const override {
    std::vector<ModelPoint> out;
    for (const Halfedge h : longest_edges(d_, most)) {
      const Frame& from = frames_[d_.connectivity().origin(h).index()];
      Frame at = orthonormal(carried(from, half_way(d_.space(), d_.offset(h))));
      move_into_polygon(domain_, at);
      out.push_back(at.P);
    }
    return out;
  }

  [[nodiscard]] std::vector<std::array<std::int32_t, 3>> triangles() const override {
    const Connectivity& c = d_.connectivity();
    std::vector<std::array<std::int32_t, 3>> out;
    out.reserve(c.face_count());
    for (std::size_t f = 0; f < c.face_count(); ++f) {
      const auto h = halfedges({static_cast<std::int32_t>(f)});
      out.push_back({c.origin(h[0]).id, c.origin(h[1]).id, c.origin(h[2]).id});
    }
    return out;
  }

 private:
  ClosedSites(const Domain& domain, SpaceTriangulation base, const std::vector<ModelPoint>& sites)
      : domain_(domain), d_(std::move(base.triangulation)) {
    std::vector<Frame>& frame = base.frame;  // by vertex
    const std::size_t base_count = frame.size();
    frame.reserve(base_count + sites.size());
    const std::vector<std::size_t> order = insertion_order(sites);
    std::size_t near = 0;
    bool base_left = true;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const ModelPoint& p = sites[order[k]];
      // The walk starts at the site before, or at the base vertex that is nearer.
      for (std::size_t v = 0; base_left && v < base_count; ++v) {
        near = offset_in(frame[v], p).h < offset_in(frame[near], p).h ? v : near;
      }
      const Offset at = offset_in(frame[near], p);
      if (at.h == 0) {
        throw InvalidInput("two sites, or a site and a corner of the domain, coincide; move one");
      }
      const Vertex v = d_.insert({static_cast<std::int32_t>(near)}, {at, {}});
      frame.push_back(orthonormal(carried(frame[near], at)));
      near = v.index();
      // All edges that the insertion made end at the new vertex.
      d_.connectivity().for_outgoing(v, [&](Halfedge h) {
        correct_offset(h, frame);
        correct_offset(d_.connectivity().twin(h), frame);
      });
      // Early, so that no long edge to them meets the short ones to come.
      if (k + 1 == std::min(order.size(), first_block)) {
        for (std::size_t b = 0; b < base_count; ++b) {
          d_.remove({static_cast<std::int32_t>(b)});
        }
        base_left = false;
        d_.compact();
        frame.erase(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(base_count));
        near -= base_count;
        correct_offsets(frame);
      }
    }
    d_.make_delaunay();
    if (std::abs(d_.area() - domain.area) > 1e-6 * domain.area) {
      throw NumericalError("the sites lie in one hemisphere; start from others");
    }
    std::vector<Vertex> number;
    frames_.resize(sites.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      number.push_back({static_cast<std::int32_t>(order[k])});
      frames_[order[k]] = frame[k];
      move_into_polygon(domain_, frames_[order[k]]);
    }
    d_.renumber(number);
  }

  /// Sets an offset in D to what the vertices' frames say.
  void correct_offset(Halfedge h, const std::vector<Frame>& frame) {
    const Connectivity& c = d_.connectivity();
    const Frame& from = frame[c.origin(h).index()];
    d_.correct(h, offset_of_lift(domain_, from, frame[c.head(h).index()].P, d_.offset(h)));
  }
  void correct_offsets(const std::vector<Frame>& frame) {
    tbb::parallel_for(std::size_t{0}, d_.connectivity().halfedge_count(), [&](std::size_t i) {
      correct_offset({static_cast<std::int32_t>(i)}, frame);
    });
  }

  Domain domain_;
  DelaunayTriangulation d_;
  std::optional<DelaunayTriangulation> saved_d_;
};

class PolygonSites : public SpaceSites {
 public:
  PolygonSites(const Domain& domain, const std::vector<ModelPoint>& sites)
      : domain_(domain), corners_(model_corners(domain)) {
    for (const ModelPoint& p : sites) {
      frames_.push_back(frame_at(domain.kappa, p));
    }
    connect();
  }

  void cell(std::size_t i, SiteCell& out) const override {
    const auto neighbours = delaunay_.neighbours(i);
    PolygonCell polygon = clipped_cell(corners_, frames_[i], points_, neighbours);
    out.corner = std::move(polygon.corner);
    out.degree = static_cast<int>(std::count_if(polygon.across.begin(), polygon.across.end(),
                                                [](std::int32_t j) { return j >= 0; }));
    out.nearest = 0;
    for (const std::int32_t j : neighbours) {
      const double d =
          distance({domain_.kappa}, offset_in(frames_[i], points_[static_cast<std::size_t>(j)]));
      out.nearest = out.nearest == 0 ? d : std::min(out.nearest, d);
    }
  }

  void move(const std::vector<Offset>& target) override {
    for (std::size_t i = 0; i < target.size(); ++i) {
      frames_[i] = moved(frames_[i], target[i]);
    }
    connect();
  }

  void save() override {
    SpaceSites::save();
    saved_delaunay_ = delaunay_;
  }
  void restore() override {
    SpaceSites::restore();
    points_ = points();
    delaunay_ = saved_delaunay_;
  }

  [[nodiscard]] std::vector<std::array<std::int32_t, 3>> triangles() const override {
    return delaunay_.triangles;
  }

 private:
  /// The frame carried to a point, or less far along the way there, in the polygon.
  [[nodiscard]] Frame moved(const Frame& from, const Offset& to) const {
    const Space s{domain_.kappa};
    Offset stop = to;
    for (double part = 1; part > least_part; part /= 2) {
      const Frame there = orthonormal(carried(from, stop));
      if (contains(domain_, there.P)) {
        return there;
      }
      const double scale = part / 2 / model_z(s, to);
      stop = from_central(s, scale * to.x, scale * to.y);
    }
    return from;
  }

  void connect() {
    points_ = points();
    delaunay_ = delaunay_in_polygon(domain_, points_);
  }

  Domain domain_;
  std::vector<ModelPoint> corners_, points_;
  PolygonDelaunay delaunay_, saved_delaunay_;
};

/// Two sites on the sphere have hemispheres for cells, three have lunes between the two poles of the
/// circle through them.
class FewSitesOnSphere : public SpaceSites {
 public:
  explicit FewSitesOnSphere(const std::vector<ModelPoint>& sites) {
    for (const ModelPoint& p : sites) {
      frames_.push_back(frame_at(1, p));
    }
    check_distinct();
  }

  void cell(std::size_t i, SiteCell& out) const override {
    out.corner.clear();
    out.degree = static_cast<int>(count()) - 1;
    out.nearest = HUGE_VAL;
    for (std::size_t j = 0; j < count(); ++j) {
      if (j != i) {
        out.nearest = std::min(out.nearest, distance({1}, offset_in(frames_[i], frames_[j].P)));
      }
    }
    count() == 2 ? hemisphere(i, out) : lune(i, out);
  }

  void move(const std::vector<Offset>& target) override {
    for (std::size_t i = 0; i < target.size(); ++i) {
      frames_[i] = orthonormal(carried(frames_[i], target[i]));
    }
    check_distinct();
  }

  [[nodiscard]] std::vector<std::array<std::int32_t, 3>> triangles() const override { return {}; }

 private:
  void check_distinct() const {
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (offset_in(frames_[i], frames_[j].P).h == 0) {
          throw InvalidInput("two sites coincide; move one");
        }
      }
    }
  }

  void hemisphere(std::size_t i, SiteCell& out) const {
    const ModelPoint &p = frames_[i].P, &q = frames_[1 - i].P;
    ModelPoint pole{};
    for (std::size_t c = 0; c < 3; ++c) {
      pole[c] = p[c] - q[c];
    }
    const Frame about = frame_at(1, unit(pole));
    const ModelPoint e1 = about.E1, e2 = about.E2();
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      out.corner.push_back(offset_in(
          frames_[i], {x * e1[0] + y * e2[0], x * e1[1] + y * e2[1], x * e1[2] + y * e2[2]}));
    }
  }

  void lune(std::size_t i, SiteCell& out) const {
    const auto minus = [&](std::size_t a, std::size_t b) {
      ModelPoint d{};
      for (std::size_t c = 0; c < 3; ++c) {
        d[c] = frames_[a].P[c] - frames_[b].P[c];
      }
      return d;
    };
    const auto crossed = [](const ModelPoint& a, const ModelPoint& b) {
      return ModelPoint{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                        a[0] * b[1] - a[1] * b[0]};
    };
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const ModelPoint pole = unit(crossed(minus(j, i), minus(k, i)));
    // The middle of the side towards each of the other two: nearer to the site than to the third.
    const auto middle = [&](std::size_t towards, std::size_t third) {
      ModelPoint m = unit(crossed(minus(towards, i), pole));
      double side = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        side += m[c] * minus(i, third)[c];
      }
      for (double& x : m) {
        x = side < 0 ? -x : x;
      }
      return m;
    };
    const ModelPoint opposite{-pole[0], -pole[1], -pole[2]};
    for (const ModelPoint& p : {pole, middle(k, j), opposite, middle(j, k)}) {
      out.corner.push_back(offset_in(frames_[i], p));
    }
  }
};

}  // namespace

std::vector<ModelPoint> SpaceSites::points() const {
  std::vector<ModelPoint> out;
  out.reserve(frames_.size());
  for (const Frame& f : frames_) {
    out.push_back(f.P);
  }
  return out;
}

std::unique_ptr<SpaceSites> make_sites(const Domain& domain, const std::vector<ModelPoint>& sites) {
  switch (domain.kind) {
    case DomainKind::PlanePolygon:
    case DomainKind::HyperbolicPolygon:
      return std::make_unique<PolygonSites>(domain, sites);
    case DomainKind::Sphere:
      if (sites.size() < 4) {
        return std::make_unique<FewSitesOnSphere>(sites);
      }
      break;
    default:
      break;
  }
  return std::make_unique<ClosedSites>(domain, sites);
}

void sort_along_curve(std::vector<ModelPoint>& points) {
  std::vector<ModelPoint> out;
  out.reserve(points.size());
  for (const std::size_t i : hilbert_order(points)) {
    out.push_back(points[i]);
  }
  points = std::move(out);
}

}  // namespace ucvt
