#include "triangulation/frame.h"

#include <cmath>

namespace ucvt {
namespace {

/// Above this z, x and y tell a model point best, and z follows from them.
constexpr double upright = 0.5;

double inner(double kappa, const ModelPoint& a, const ModelPoint& b) {
  return a[2] * b[2] + kappa * (a[0] * b[0] + a[1] * b[1]);
}

double metric(double kappa, const ModelPoint& a, const ModelPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + kappa * a[2] * b[2];
}

ModelPoint sum(const ModelPoint& a, double t, const ModelPoint& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

ModelPoint scaled(const ModelPoint& a, double t) {
  return {t * a[0], t * a[1], t * a[2]};
}

/// Rows that give the x, y, z of a model point in the frame with the given axes.
ModelMatrix rows(double k, const ModelPoint& e1, const ModelPoint& e2, const ModelPoint& p) {
  const ModelPoint z{k * p[0], k * p[1], p[2]};
  const auto axis = [&](const ModelPoint& e) {
    // g(E, P) vanishes but for kappa = 0, where it moves the plane's origin.
    return sum({e[0], e[1], k * e[2]}, -metric(k, e, p), z);
  };
  return {axis(e1), axis(e2), z};
}

}  // namespace

ModelPoint Frame::E2() const {
  return {P[1] * E1[2] - P[2] * E1[1], P[2] * E1[0] - P[0] * E1[2],
          kappa * (P[0] * E1[1] - P[1] * E1[0])};
}

ModelPoint on_model(double kappa, const ModelPoint& p) {
  if (p[2] > upright) {
    return {p[0], p[1], std::sqrt(1 - kappa * (p[0] * p[0] + p[1] * p[1]))};
  }
  return scaled(p, 1 / std::sqrt(inner(kappa, p, p)));
}

ModelPoint model_point(const Frame& f, const Offset& x) {
  const ModelPoint d = sum(sum(scaled(f.P, -f.kappa * x.h), x.x, f.E1), x.y, f.E2());
  return on_model(f.kappa, sum(f.P, 1, d));
}

Offset offset_in(const Frame& f, const ModelPoint& p) {
  ModelPoint d = sum(p, -1, f.P);
  const double z = p[2] + f.P[2];
  if (z > upright) {
    // The model's equation, subtracted: the rounding of the two z does not matter.
    d[2] = -f.kappa * (d[0] * (p[0] + f.P[0]) + d[1] * (p[1] + f.P[1])) / z;
  }
  return on_quadric(
      {f.kappa}, {metric(f.kappa, f.E1, d), metric(f.kappa, f.E2(), d), metric(f.kappa, d, d) / 2});
}

Frame orthonormal(const Frame& f) {
  const double k = f.kappa;
  Frame out{k, on_model(k, f.P), f.E1};
  const ModelPoint &p = out.P, &e = f.E1;
  if (p[2] > upright) {
    // |E|^2 with E_z from <P, E> = 0 and P_z from <P, P> = 1 put in: no difference when kappa < 0.
    out.E1[2] = -k * (p[0] * e[0] + p[1] * e[1]) / p[2];
    const double turn = p[0] * e[1] - p[1] * e[0];
    const double norm2 = e[0] * e[0] + e[1] * e[1] - k * turn * turn;
    out.E1 = scaled(out.E1, p[2] / std::sqrt(norm2));
    return out;
  }
  out.E1 = sum(e, -inner(k, e, p), p);
  out.E1 = scaled(out.E1, 1 / std::sqrt(metric(k, out.E1, out.E1)));
  return out;
}

Frame carried(const Frame& f, const Offset& to) {
  // The transvection of offset.h, on the first axis.
  const ModelPoint along = sum(scaled(f.E1, to.x), to.y, f.E2());
  const ModelPoint change = sum(f.P, 1 / (2 - f.kappa * to.h), along);
  return orthonormal({f.kappa, model_point(f, to), sum(f.E1, -f.kappa * to.x, change)});
}

Frame frame_at(double kappa, const ModelPoint& p) {
  const Frame base{kappa, {0, 0, p[2] < 0 ? -1.0 : 1.0}, {1, 0, 0}};
  Frame out = carried(base, offset_in(base, p));
  out.P = p;
  return orthonormal(out);
}

Frame turned(const Frame& f, const Rotation& by) {
  return orthonormal({f.kappa, f.P, sum(scaled(f.E1, by.cosine), by.sine, f.E2())});
}

ModelMatrix taking(const Frame& from, const Frame& to) {
  const ModelMatrix in = rows(from.kappa, from.E1, from.E2(), from.P);
  const std::array<ModelPoint, 3> out{to.E1, to.E2(), to.P};
  ModelMatrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      m[i][j] = out[0][i] * in[0][j] + out[1][i] * in[1][j] + out[2][i] * in[2][j];
    }
  }
  return m;
}

ModelPoint transformed(const ModelMatrix& m, const ModelPoint& p) {
  const auto row = [&](std::size_t i) { return m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2]; };
  return {row(0), row(1), row(2)};
}

ModelMatrix inverse_isometry(double kappa, const ModelMatrix& m) {
  // An isometry's columns are the image of the frame at the model's origin.
  const auto column = [&](std::size_t j) { return ModelPoint{m[0][j], m[1][j], m[2][j]}; };
  return rows(kappa, column(0), column(1), column(2));
}

}  // namespace ucvt
