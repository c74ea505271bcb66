#include "cvt/surface_mass.h"

#include <tbb/parallel_for.h>

namespace ucvt {

SurfaceMass::SurfaceMass(const UniformSurface& t, std::vector<double> density)
    : t_(t),
      density_(std::move(density)),
      pieces_(t.connectivity().face_count()),
      share_(t.connectivity().vertex_count()) {
  tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
    const Face f{static_cast<std::int32_t>(i)};
    FacePieces& face = pieces_[i];
    face.triangle = t_.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      face.density[k] = density_[t_.connectivity().origin(halfedges(f)[k]).index()];
    }
    face.weights = integrate(t_.space(), face.triangle, face.density);
  });
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const auto corners = t_.vertex_order().corners({static_cast<std::int32_t>(i)});
    for (std::size_t k = 0; k < 3; ++k) {
      const CornerShare face = pieces_[i].share(k);
      CornerShare& vertex = share_[corners[k]];
      vertex.mu += face.mu, vertex.excess += face.excess;
    }
  }
}

double SurfaceMass::total() const {
  double sum = 0;
  for (const FacePieces& face : pieces_) {
    sum += face.weights.mass(t_.space());
  }
  return sum;
}

}  // namespace ucvt
