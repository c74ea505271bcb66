#include "paper_method/lloyd.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "result/density.h"
#include "ucvt/error.h"

namespace ucvt::paper {
namespace {

/// Of this process: what else runs on the machine does not count.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// The density cf^2 about a site: cf is linear over the triangles of T, which are developed on the way
/// from one point to the next.
class DensityWalk {
 public:
  DensityWalk(const UniformSurface& t, const std::vector<double>& conformal_factor, Place start)
      : t_(t), factor_(conformal_factor), at_(std::move(start)) {}

  double operator()(const Offset& p) {
    const std::size_t limit = 100 + 3 * t_.connectivity().face_count();
    for (std::size_t step = 0; step < limit; ++step) {
      std::array<double, 3> b{};
      for (std::size_t i = 0; i < 3; ++i) {
        b[i] = orientation(t_.space(), p, at_.corner[(i + 1) % 3], at_.corner[(i + 2) % 3]);
      }
      const auto least = static_cast<std::size_t>(std::ranges::min_element(b) - b.begin());
      if (b[least] >= -on_edge * t_.det(at_.face)) {
        return density(b);
      }
      cross_side((least + 1) % 3);
    }
    throw NumericalError("the walk to a sample did not end");
  }

 private:
  /// Beyond an edge by no more than this part of the triangle is on it.
  static constexpr double on_edge = 1e-12;

  [[nodiscard]] double density(const std::array<double, 3>& b) const {
    double sum = 0, factor = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += b[i];
      factor += b[i] * factor_[t_.connectivity().origin(halfedges(at_.face)[i]).index()];
    }
    return (factor / sum) * (factor / sum);
  }

  void cross_side(std::size_t side) {
    const Halfedge h = halfedges(at_.face)[side], twin = t_.connectivity().twin(h);
    const Offset u = at_.corner[side], v = at_.corner[(side + 1) % 3];
    const auto j = static_cast<std::size_t>(twin.id % 3);
    at_.face = twin.face();
    at_.corner[j] = v, at_.corner[(j + 1) % 3] = u, at_.corner[(j + 2) % 3] = t_.develop(h, u, v);
  }

  const UniformSurface& t_;
  const std::vector<double>& factor_;
  Place at_;
};

/// The largest distance from the site of a corner of its cell, projected to the plane z = 0.
double cell_radius(Space s, const std::vector<Offset>& around) {
  double out = 0;
  for (std::size_t j = 0; j + 1 < around.size(); ++j) {
    const Central c = circumcentre(around[j], around[j + 1]);
    const Offset p = from_central(s, c.x, c.y);
    out = std::max(out, std::hypot(p.x, p.y));
  }
  return out;
}

}  // namespace

Lloyd::Lloyd(const Uniformized& t, const std::vector<SurfacePoint>& sites, int grid)
    : t_(t.surface), conformal_factor_(ucvt::conformal_factor(t)), grid_(grid) {
  LaidOut laid_out = laid_out_domain(t_, sites);
  domain_ = std::move(laid_out.domain);
  sites_ = std::move(laid_out.sites);
}

Offset Lloyd::centroid_of(const PlacedSite& site, const Diagram& d,
                          const std::vector<std::int32_t>& neighbours) const {
  const Space s = t_.space();
  std::vector<Offset> around;
  for (const std::int32_t j : neighbours) {
    around.push_back(offset_in(site.frame, d.points[static_cast<std::size_t>(j)]));
  }
  const double radius = cell_radius(s, around);
  const double step = 2 * radius / grid_;
  DensityWalk density(t_, conformal_factor_, site.place);
  Moments sum;
  for (int row = 0; row < grid_; ++row) {
    for (int k = 0; k < grid_; ++k) {
      // To and fro, so that a sample is near the one before.
      const int column = row % 2 == 0 ? k : grid_ - 1 - k;
      const double x = (column + 0.5) * step - radius, y = (row + 0.5) * step - radius;
      const Offset p = on_quadric(s, {x, y, 0});
      const double z = model_z(s, p);
      if (std::isfinite(z) && std::ranges::all_of(around, [&](const Offset& a) {
            return a.x * x + a.y * y <= a.h * z;
          })) {
        const double rho = density(p);
        sum += {rho, rho * x, rho * y, rho * p.h};
      }
    }
  }
  return sum.m > 0 ? centroid(s, sum) : Offset{};
}

void Lloyd::run(int iterations) {
  for (int i = 0; i < iterations; ++i, ++timing_.iterations) {
    double start = processor_seconds();
    const Diagram d = current_diagram();
    const auto around = neighbours(d);
    timing_.diagrams += processor_seconds() - start;
    start = processor_seconds();
    std::vector<Offset> centroids;
    for (std::size_t k = 0; k < sites_.size(); ++k) {
      const bool closed = around[k].size() > 3 && around[k].front() == around[k].back();
      centroids.push_back(closed ? centroid_of(sites_[k], d, around[k]) : Offset{});
    }
    for (std::size_t k = 0; k < sites_.size(); ++k) {
      PlacedSite& site = sites_[k];
      move_place(t_, site.place, centroids[k]);
      site.frame = carried(site.frame, centroids[k]);
      bring_back(domain_, site.frame);
    }
    timing_.centroids += processor_seconds() - start;
  }
}

std::vector<SurfacePoint> Lloyd::sites() const {
  std::vector<SurfacePoint> out;
  for (const PlacedSite& s : sites_) {
    out.push_back(point_of(s.place));
  }
  return out;
}

}  // namespace ucvt::paper
