#include "cvt/surface_mass.h"

#include <tbb/parallel_for.h>

namespace ucvt {

SurfaceMass::SurfaceMass(const UniformSurface& t, std::vector<double> density)
    : t_(t), density_(std::move(density)), weights_(t.connectivity().face_count()) {
  tbb::parallel_for(std::size_t{0}, weights_.size(), [&](std::size_t f) {
    const Face face{static_cast<std::int32_t>(f)};
    weights_[f] = integrate(t_.space(), t_.triangle(face), corner_densities(face));
  });
}

std::array<double, 3> SurfaceMass::corner_densities(Face f) const {
  std::array<double, 3> rho{};
  for (std::size_t i = 0; i < 3; ++i) {
    rho[i] = density_[t_.connectivity().origin(halfedges(f)[i]).index()];
  }
  return rho;
}

}  // namespace ucvt
