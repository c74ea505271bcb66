// The Delaunay mesh of a tessellation, cut open where its domain is closed.
//
// A Voronoi vertex of a torus or a hyperbolic surface is a corner of three cells or more, each of
// which sees it in a lift of its own. Carried into the fundamental polygon these corners fall on one
// point, and the sites, carried along, stand round it: they are the corners of its triangle. Sites
// on one circle round an empty disk give a polygon, which is cut into a fan.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cvt/domain.h"
#include "result/space_points.h"
#include "space/offset.h"
#include "triangulation/frame.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Corners nearer to each other than this, relative to the radius of the circle, are one.
constexpr double corner_tolerance = 1e-7;

struct Lift {
  std::int32_t site = 0;
  ModelPoint at{};
};

struct VoronoiVertex {
  ModelPoint at{};
  std::vector<Lift> around;
};

double distance(const ModelPoint& p, const ModelPoint& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1]);
}

/// How far k lies outside a side, in central coordinates.
double outside(const Domain& domain, std::size_t side, const CentralPoint& k) {
  const CentralPoint& a = domain.polygon[side];
  const CentralPoint& b = domain.polygon[(side + 1) % domain.polygon.size()];
  const double x = b[0] - a[0], y = b[1] - a[1];
  return (y * (k[0] - a[0]) - x * (k[1] - a[1])) / std::hypot(x, y);
}

/// A corner and its site, in the same lift.
struct Incidence {
  ModelPoint corner{}, site{};

  void carry(double kappa, const ModelMatrix& by) {
    corner = on_model(kappa, transformed(by, corner));
    site = on_model(kappa, transformed(by, site));
  }
};

/// Collects the Voronoi vertices of a closed domain in its fundamental polygon.
class VertexCollector {
 public:
  explicit VertexCollector(const SpaceResult& result) : domain_(result.domain) {
    for (const ModelMatrix& m : domain_.across) {
      back_.push_back(inverse_isometry(domain_.kappa, m));
    }
    double widest = 0;
    for (const SpaceCell& cell : result.cells) {
      widest = std::max(widest, cell.radius);
    }
    for (const ModelPoint& p : model_corners(domain_)) {
      largest_z_ = std::max(largest_z_, p[2]);
    }
    grid_ = tolerance(widest);
  }

  void add(std::int32_t site, Incidence seen, double radius) {
    carry_into_polygon(seen);
    for (const Incidence& image : images(seen, radius)) {
      if (VoronoiVertex* const found = find(image.corner, tolerance(radius))) {
        insert(*found, {site, image.site}, tolerance(radius));
        return;
      }
    }
    at_[key(seen.corner)].push_back(vertices.size());
    vertices.push_back({seen.corner, {{site, seen.site}}});
  }

  std::vector<VoronoiVertex> vertices;

 private:
  /// In x and y of the model, which stretch lengths by z at most.
  [[nodiscard]] double tolerance(double radius) const {
    return corner_tolerance * radius * largest_z_;
  }

  void carry_into_polygon(Incidence& seen) const {
    constexpr int most_crossings = 100000;
    for (int crossing = 0; crossing < most_crossings; ++crossing) {
      const CentralPoint k = central_point(seen.corner);
      std::size_t worst = 0;
      for (std::size_t i = 1; i < back_.size(); ++i) {
        worst = outside(domain_, i, k) > outside(domain_, worst, k) ? i : worst;
      }
      if (!(outside(domain_, worst, k) > 0)) {
        return;
      }
      const double before = seen.corner[2];
      const Incidence kept = seen;
      seen.carry(domain_.kappa, back_[worst]);
      // On a side of the 4g-gon rounding may send it to and fro for ever.
      if (domain_.kappa < 0 && !(seen.corner[2] < before)) {
        seen = kept;
        return;
      }
    }
  }

  /// The incidence and, near sides, its images near other sides.
  [[nodiscard]] std::vector<Incidence> images(const Incidence& seen, double radius) const {
    const double near = tolerance(radius);
    std::vector<Incidence> out = {seen};
    for (std::size_t done = 0; done < out.size(); ++done) {
      const CentralPoint k = central_point(out[done].corner);
      for (std::size_t i = 0; i < back_.size(); ++i) {
        if (outside(domain_, i, k) < -near) {
          continue;
        }
        Incidence image = out[done];
        image.carry(domain_.kappa, back_[i]);
        if (std::none_of(out.begin(), out.end(), [&](const Incidence& other) {
              return distance(other.corner, image.corner) < 4 * near;
            })) {
          out.push_back(image);
        }
      }
    }
    return out;
  }

  using Key = std::pair<std::int64_t, std::int64_t>;
  struct Hash {
    std::size_t operator()(const Key& k) const {
      return static_cast<std::size_t>(static_cast<std::uint64_t>(k.first) * 0x9E3779B97F4A7C15u ^
                                      static_cast<std::uint64_t>(k.second) * 0xD6E8FEB86659FD93u);
    }
  };
  [[nodiscard]] Key key(const ModelPoint& p) const {
    return {static_cast<std::int64_t>(std::floor(p[0] / grid_)),
            static_cast<std::int64_t>(std::floor(p[1] / grid_))};
  }

  VoronoiVertex* find(const ModelPoint& p, double near) {
    const Key centre = key(p);
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -1; j <= 1; ++j) {
        const auto bin = at_.find({centre.first + i, centre.second + j});
        if (bin == at_.end()) {
          continue;
        }
        for (const std::size_t v : bin->second) {
          if (distance(vertices[v].at, p) <= near) {
            return &vertices[v];
          }
        }
      }
    }
    return nullptr;
  }

  static void insert(VoronoiVertex& vertex, const Lift& lift, double near) {
    if (std::none_of(vertex.around.begin(), vertex.around.end(), [&](const Lift& other) {
          return other.site == lift.site && distance(other.at, lift.at) <= 4 * near;
        })) {
      vertex.around.push_back(lift);
    }
  }

  const Domain& domain_;
  std::vector<ModelMatrix> back_;
  double largest_z_ = 1, grid_ = 1;
  std::unordered_map<Key, std::vector<std::size_t>, Hash> at_;
};

/// Numbers the lifts that occur: a site in the fundamental polygon keeps its number.
class LiftNumbers {
 public:
  LiftNumbers(const SpaceResult& result, Coordinates coordinates, TriangleMesh& mesh)
      : result_(result), coordinates_(coordinates), copies_(result.sites.size()), mesh_(mesh) {
    for (std::size_t i = 0; i < result.sites.size(); ++i) {
      number({static_cast<std::int32_t>(i), result.sites[i]});
    }
  }

  std::int32_t number(const Lift& lift) {
    const auto site = static_cast<std::size_t>(lift.site);
    // Lifts of one site are not nearer to each other than `nearest`.
    const double apart = result_.cells[site].nearest / 2;
    for (const std::int32_t v : copies_[site]) {
      if (distance(at_[static_cast<std::size_t>(v)], lift.at) < apart) {
        return v;
      }
    }
    const auto v = static_cast<std::int32_t>(at_.size());
    copies_[site].push_back(v);
    at_.push_back(lift.at);
    mesh_.positions.push_back(written_position(result_.domain.kappa, lift.at, coordinates_));
    return v;
  }

 private:
  const SpaceResult& result_;
  Coordinates coordinates_;
  std::vector<std::vector<std::int32_t>> copies_;  // of each site
  std::vector<ModelPoint> at_;
  TriangleMesh& mesh_;
};

void sort_counterclockwise(double kappa, VoronoiVertex& vertex) {
  const Frame frame = frame_at(kappa, vertex.at);
  const auto angle = [&](const Lift& lift) {
    const Offset o = offset_in(frame, lift.at);
    return std::atan2(o.y, o.x);
  };
  std::sort(vertex.around.begin(), vertex.around.end(),
            [&](const Lift& a, const Lift& b) { return angle(a) < angle(b); });
}

TriangleMesh unfolded_mesh(const SpaceResult& result, Coordinates coordinates) {
  VertexCollector collector(result);
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const Frame frame = frame_at(result.domain.kappa, result.sites[i]);
    for (const ModelPoint& corner : result.cells[i].corners) {
      const double radius = std::sqrt(2 * offset_in(frame, corner).h);
      collector.add(static_cast<std::int32_t>(i), {corner, result.sites[i]}, radius);
    }
  }
  TriangleMesh mesh;
  LiftNumbers numbers(result, coordinates, mesh);
  for (VoronoiVertex& vertex : collector.vertices) {
    sort_counterclockwise(result.domain.kappa, vertex);
    std::vector<std::int32_t> around;
    for (const Lift& lift : vertex.around) {
      around.push_back(numbers.number(lift));
    }
    for (std::size_t k = 2; k < around.size(); ++k) {
      mesh.faces.push_back({around[0], around[k - 1], around[k]});
    }
  }
  if (mesh.faces.size() != result.triangles.size()) {
    throw NumericalError(
        "the triangles of the Delaunay mesh do not fit together; ask for another number of sites");
  }
  return mesh;
}

}  // namespace

TriangleMesh delaunay_mesh(const SpaceResult& result, Coordinates coordinates) {
  const bool closed = result.domain.kind == DomainKind::Torus ||
                      result.domain.kind == DomainKind::HyperbolicSurface;
  if (closed) {
    return unfolded_mesh(result, coordinates);
  }
  if (result.triangles.empty()) {
    throw InvalidInput("the sites have no Delaunay triangle; ask for more of them");
  }
  TriangleMesh mesh;
  mesh.faces = result.triangles;
  for (const ModelPoint& p : result.sites) {
    mesh.positions.push_back(written_position(result.domain.kappa, p, coordinates));
  }
  return mesh;
}

}  // namespace ucvt
