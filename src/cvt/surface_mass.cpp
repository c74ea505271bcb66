#include "cvt/surface_mass.h"

#include <tbb/parallel_for.h>

namespace ucvt {

SurfaceMass::SurfaceMass(const UniformSurface& t, std::vector<double> density)
    : t_(t),
      density_(std::move(density)),
      weights_(t.connectivity().face_count()),
      pieces_(weights_.size()) {
  tbb::parallel_for(std::size_t{0}, weights_.size(), [&](std::size_t i) {
    const Face f{static_cast<std::int32_t>(i)};
    FacePieces& face = pieces_[i];
    face.triangle = t_.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      face.density[k] = density_[t_.connectivity().origin(halfedges(f)[k]).index()];
    }
    weights_[i] = integrate(t_.space(), face.triangle, face.density);
  });
}

double SurfaceMass::total() const {
  double sum = 0;
  for (const Weights& w : weights_) {
    sum += w.mass;
  }
  return sum;
}

}  // namespace ucvt
