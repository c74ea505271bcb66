// Uniformization: what is reported of it, and how long computations are watched.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ucvt {

/// Where a computation stands, as told to a Monitor.
struct Progress {
  const char* stage = "";  ///< "uniformize" or "optimize"
  int iteration = 0;
  double residual = 0;  ///< largest angle error in radians, or largest relative move
};

/// Called now and then; returning false asks the computation to stop at the next safe point.
using Monitor = std::function<bool(const Progress&)>;

/// What `uniformize` found; angles in radians, area in the uniform metric.
struct UniformizationReport {
  std::string geometry;  ///< "spherical", "euclidean" or "hyperbolic"
  int newton_iterations = 0;
  std::int64_t euclidean_flips = 0;
  std::int64_t ptolemy_flips = 0;
  std::int64_t refined_vertices = 0;
  double max_angle_error = 0;
  double area = 0;
  double log_scale_min = 0;
  double log_scale_max = 0;
  double seconds = 0;
};

}  // namespace ucvt
