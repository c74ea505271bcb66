#include "result/site_points.h"

#include <cmath>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {

std::vector<SurfacePoint> as_points(const std::vector<Site>& sites, std::size_t faces) {
  std::vector<SurfacePoint> out;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Site& s = sites[i];
    double sum = 0;
    bool valid = s.face >= 0 && static_cast<std::size_t>(s.face) < faces;
    for (const double b : s.bary) {
      valid = valid && b >= 0, sum += b;
    }
    if (!valid || !(std::abs(sum - 1) < 1e-6)) {
      throw InvalidInput(
          fmt::format("initial site {} (face {}) does not lie on the surface, which "
                      "has {} faces; give sites made for the same mesh and count",
                      i, s.face, faces));
    }
    out.push_back({{s.face}, s.bary});
  }
  return out;
}

std::vector<Site> as_sites(const std::vector<SurfacePoint>& points) {
  std::vector<Site> out;
  for (const SurfacePoint& p : points) {
    out.push_back({p.face.id, p.bary});
  }
  return out;
}

}  // namespace ucvt
