#include <algorithm>
#include <cmath>

#include "result/cover_cells.h"
#include "result/cover_data.h"
#include "triangulation/frame.h"

namespace ucvt {
namespace {

/// Copies a way may lead through; more come only of rounding.
constexpr int most_steps = 10000;

CentralPoint central(const ModelPoint& p) {
  return {p[0] / p[2], p[1] / p[2]};
}

double turn(const CentralPoint& a, const CentralPoint& b, const CentralPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The map that takes a point, which lies on the model, to the origin.
DeckMap to_origin(double kappa, const ModelPoint& p) {
  const double a = std::sqrt((1 + p[2]) / 2);
  return normalized(kappa, {{a, 0}, {-p[0] / (2 * a), -p[1] / (2 * a)}});
}

/// The middle of the largest triangle of three consecutive corners without another corner in it.
CentralPoint point_inside(const std::vector<ModelPoint>& corners) {
  const std::size_t n = corners.size();
  double largest = 0;
  CentralPoint out{};
  for (std::size_t i = 0; i < n; ++i) {
    const CentralPoint a = central(corners[i]), b = central(corners[(i + 1) % n]),
                       c = central(corners[(i + 2) % n]);
    bool is_ear = turn(a, b, c) > largest;
    for (std::size_t j = 3; j < n && is_ear; ++j) {
      const CentralPoint p = central(corners[(i + j) % n]);
      is_ear = turn(a, b, p) < 0 || turn(b, c, p) < 0 || turn(c, a, p) < 0;
    }
    if (is_ear) {
      largest = turn(a, b, c);
      out = {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
    }
  }
  return out;
}

/// How far along from p to q the line meets the side from a to b; beyond 1 where it does not.
double meets(const CentralPoint& p, const CentralPoint& q, const CentralPoint& a,
             const CentralPoint& b) {
  const double at_p = turn(a, b, p), at_q = turn(a, b, q);
  const double at_a = turn(p, q, a), at_b = turn(p, q, b);
  return at_p * at_q < 0 && at_a * at_b < 0 ? at_p / (at_p - at_q) : 2;
}

/// The angle to turn the picture back by: of the torus' longest side, or of the middle of the widest
/// angle under which the origin sees two corners that follow each other.
double bearing(double kappa, const std::vector<ModelPoint>& corners) {
  double most = 0, out = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ModelPoint &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double gap = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
    const double size = kappa == 0 ? std::hypot(b[0] - a[0], b[1] - a[1]) : gap;
    // The relative margin keeps rounding from choosing among sides of equal length.
    if (size > most * (1 + 1e-9)) {
      most = size;
      out = kappa == 0 ? std::atan2(b[1] - a[1], b[0] - a[0]) : std::atan2(a[1], a[0]) + gap / 2;
    }
  }
  return out;
}

}  // namespace

CentredPolygon::CentredPolygon(const Cover& cover) : kappa_(cover.group().kappa), cover_(cover) {
  const DeckGroup& group = cover.group();
  ModelPoint sum{0, 0, 0};
  for (const ModelPoint& p : group.polygon) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += p[k];
    }
  }
  const double norm = std::sqrt(sum[2] * sum[2] + kappa_ * (sum[0] * sum[0] + sum[1] * sum[1]));
  centring_ = to_origin(kappa_, {sum[0] / norm, sum[1] / norm, sum[2] / norm});
  const std::vector<DeckMap> corner =
      corner_maps(kappa_, group.relator, cover.data().system.canonical.map);
  const auto place_corners = [&] {
    corners_.clear();
    for (std::size_t i = 0; i < group.polygon.size(); ++i) {
      const Offset p = image_of_origin(product(kappa_, centring_, corner[i]));
      corners_.push_back({p.x, p.y, model_z({kappa_}, p)});
    }
  };
  place_corners();
  const double half = -bearing(kappa_, corners_) / 2;
  centring_ =
      normalized(kappa_, product(kappa_, {{std::cos(half), std::sin(half)}, {}}, centring_));
  place_corners();
  for (std::size_t i = 0; i < group.polygon.size(); ++i) {
    paired_.push_back(static_cast<std::size_t>(group.paired_side[i]));
    const DeckMap m = product(kappa_, corner[paired_[i]], inverse(corner[i + 1]));
    across_.push_back(product(kappa_, product(kappa_, centring_, m), inverse(centring_)));
  }
  inside_ = point_inside(corners_);
}

std::vector<ModelMatrix> CentredPolygon::neighbours() const {
  const DeckSystem& s = cover_.data().system;
  std::vector<ModelMatrix> out;
  for (const Word& word : neighbour_words(cover_.group().genus)) {
    const DeckMap m = map_of(kappa_, word, s.canonical.map);
    out.push_back(
        model_matrix(kappa_, product(kappa_, product(kappa_, centring_, m), inverse(centring_))));
  }
  return out;
}

DeckMap CentredPolygon::bringing(const ModelPoint& p) const {
  const std::size_t n = corners_.size();
  DeckMap out;
  const Offset start = from_central({kappa_}, inside_[0], inside_[1]);
  ModelPoint from{start.x, start.y, model_z({kappa_}, start)}, to = p;
  std::size_t entered = n;
  for (int step = 0; step < most_steps; ++step) {
    const auto met = [&](std::size_t i) {
      return meets(central(from), central(to), central(corners_[i]),
                   central(corners_[(i + 1) % n]));
    };
    const double after = entered < n ? met(entered) : 0;
    std::size_t exit = n;
    double first = 1;
    for (std::size_t i = 0; i < n; ++i) {
      const double t = met(i);
      if (i != entered && t < first && (entered == n || after > 1 || t > after)) {
        first = t, exit = i;
      }
    }
    if (exit == n) {
      break;
    }
    const ModelMatrix m = model_matrix(kappa_, across_[exit]);
    from = transformed(m, from), to = transformed(m, to);
    out = normalized(kappa_, product(kappa_, across_[exit], out));
    entered = paired_[exit];
  }
  return out;
}

}  // namespace ucvt
