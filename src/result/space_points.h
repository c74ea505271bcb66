// Model points as they are written to files.
#pragma once

#include "ucvt/mesh.h"
#include "ucvt/space_files.h"
#include "ucvt/spaces.h"

namespace ucvt {

/// Where a model point goes in a file.
inline Position written_position(double kappa, const ModelPoint& p, Coordinates coordinates) {
  if (kappa > 0 || (kappa < 0 && coordinates == Coordinates::Model)) {
    return p;
  }
  const double scale =
      kappa < 0 && coordinates == Coordinates::Poincare ? 1 / (1 + p[2]) : 1 / p[2];
  return {p[0] * scale, p[1] * scale, 0};
}

}  // namespace ucvt
