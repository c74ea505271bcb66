#include "conformal/krylov.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ucvt {
namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

void multiply(const SymmetricMatrix& a, const Vector& x, Vector& y) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    double sum = a.diagonal[i] * x[i];
    a.for_row(i, [&](std::size_t j, double value) { sum += value * x[j]; });
    y[i] = sum;
  }
}

}  // namespace

KrylovResult conjugate_gradients(const SymmetricMatrix& a, const Preconditioner& m, const Vector& b,
                                 double reduction, int limit, Vector& x) {
  const std::size_t n = b.size();
  x.assign(n, 0);
  Vector r = b, z(n), ap(n);
  m(r, z);
  Vector p = z;
  double rz = dot(r, z);
  const double wanted = reduction * reduction * rz;
  KrylovResult out;
  out.converged = !(rz > 0);
  while (!out.converged && out.iterations < limit) {
    ++out.iterations;
    multiply(a, p, ap);
    const double curvature = dot(p, ap);
    if (!(curvature > 0)) {
      return out;
    }
    const double step = rz / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += step * p[i];
      r[i] -= step * ap[i];
    }
    m(r, z);
    const double next = dot(r, z);
    out.converged = next <= wanted;
    const double turn = next / rz;
    for (std::size_t i = 0; i < n; ++i) {
      p[i] = z[i] + turn * p[i];
    }
    rz = next;
  }
  return out;
}

KrylovResult minimal_residuals(const SymmetricMatrix& a, const Preconditioner& m, const Vector& b,
                               double reduction, int limit, Vector& x) {
  // Lanczos vectors v with z = M v, directions w; the names are those of Elman, Silvester and Wathen.
  const std::size_t n = b.size();
  x.assign(n, 0);
  Vector v_old(n), v = b, v_new(n), z(n), z_new(n), w_old(n), w(n), w_new(n);
  m(v, z);
  double gamma_old = 1, gamma = std::sqrt(dot(v, z)), eta = gamma;
  double c_old = 1, c = 1, s_old = 0, s = 0;
  const double wanted = reduction * gamma;
  KrylovResult out;
  out.converged = !(gamma > 0);
  while (!out.converged && out.iterations < limit) {
    ++out.iterations;
    for (double& value : z) {
      value /= gamma;
    }
    multiply(a, z, v_new);
    const double delta = dot(v_new, z);
    for (std::size_t i = 0; i < n; ++i) {
      v_new[i] -= delta / gamma * v[i] + gamma / gamma_old * v_old[i];
    }
    m(v_new, z_new);
    const double gamma_new = std::sqrt(std::max(0.0, dot(v_new, z_new)));
    const double a0 = c * delta - c_old * s * gamma, a1 = std::hypot(a0, gamma_new);
    const double a2 = s * delta + c_old * c * gamma, a3 = s_old * gamma;
    if (!(a1 > 0)) {
      return out;
    }
    c_old = std::exchange(c, a0 / a1), s_old = std::exchange(s, gamma_new / a1);
    for (std::size_t i = 0; i < n; ++i) {
      w_new[i] = (z[i] - a3 * w_old[i] - a2 * w[i]) / a1;
      x[i] += c * eta * w_new[i];
    }
    eta *= -s;
    out.converged = std::abs(eta) <= wanted;
    gamma_old = std::exchange(gamma, gamma_new);
    std::swap(v_old, v), std::swap(v, v_new), std::swap(z, z_new);
    std::swap(w_old, w), std::swap(w, w_new);
  }
  return out;
}

}  // namespace ucvt
