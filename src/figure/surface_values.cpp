#include "figure/surface_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>

#include "result/density.h"

namespace ucvt {
namespace {

/// The third corner when the first side runs from 0 to 1; imaginary part 0 when there is none.
std::complex<double> apex(const std::array<double, 3>& side) {
  const double a = side[1] / side[0], b = side[2] / side[0];
  const double x = (1 + b * b - a * a) / 2;
  // Heron's formula as Kahan writes it, from the longest side to the shortest.
  std::array<double, 3> s{1, a, b};
  std::sort(s.begin(), s.end(), std::greater<>());
  const double area16 = (s[0] + (s[1] + s[2])) * (s[2] - (s[0] - s[1])) * (s[2] + (s[0] - s[1])) *
                        (s[0] + (s[1] - s[2]));
  return {x, area16 > 0 ? std::sqrt(area16) / 2 : 0};
}

/// The faces of T that some Ptolemy flip made.
std::vector<char> made_by_ptolemy(const Uniformized& t) {
  std::vector<char> out(t.surface.connectivity().face_count(), 0);
  const auto& changes = t.intrinsic.log.changes();
  const auto flat = static_cast<std::size_t>(t.intrinsic.euclidean_flips + t.intrinsic.splits);
  for (std::size_t i = flat; i < changes.size(); ++i) {
    out[changes[i].h.face().index()] = out[changes[i].t.face().index()] = 1;
  }
  return out;
}

}  // namespace

double dilatation(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  // The map x + i y -> z + mu conj(z), up to a similarity, that takes one apex to the other and keeps
  // 0 and 1: its dilatation is (1 + |mu|)/(1 - |mu|).
  const std::complex<double> p = apex(from), q = apex(to);
  if (!(p.imag() > 0) || !(q.imag() > 0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double mu = std::abs(q - p) / std::abs(q - std::conj(p));
  return (1 + mu) / (1 - mu);
}

std::vector<double> area_distortion(const Uniformized& t) {
  std::vector<double> out = conformal_factor(t);
  const double whole =
      std::accumulate(t.vertex_area_3d.begin(), t.vertex_area_3d.end(), 0.0) / t.report.area;
  out.resize(t.input.positions.size());
  for (double& x : out) {
    x = std::log10(x / whole);
  }
  return out;
}

std::vector<double> angle_distortion(const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  const std::vector<char> unflat = made_by_ptolemy(t);
  std::vector<double> sum(c.vertex_count()), count(c.vertex_count());
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    std::array<double, 3> from{}, to{};
    const auto side = halfedges({static_cast<std::int32_t>(f)});
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = std::exp(t.intrinsic.log_length[side[i].index()]);
      to[i] = t.surface.chord(side[i]);
    }
    const double k =
        unflat[f] != 0 ? std::numeric_limits<double>::quiet_NaN() : dilatation(from, to);
    for (const Halfedge h : side) {
      if (std::isfinite(k)) {
        sum[c.origin(h).index()] += k, ++count[c.origin(h).index()];
      }
    }
  }
  std::vector<double> out;
  for (std::size_t v = 0; v < t.input.positions.size(); ++v) {
    out.push_back(sum[v] / count[v]);
  }
  return out;
}

}  // namespace ucvt
