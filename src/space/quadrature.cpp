#include "space/quadrature.h"

#include <array>
#include <cmath>
#include <numbers>

namespace ucvt {
namespace {

struct LineNode {
  double x, weight;
};

/// Gauss-Legendre on [0, 1] with n nodes, by Newton's method on the Legendre recurrence.
std::vector<LineNode> gauss_legendre(int n) {
  std::vector<LineNode> nodes;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    double slope = 0;
    for (int step = 0; step < 100; ++step) {
      double p0 = 1, p1 = x;
      for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }
      slope = n * (x * p1 - p0) / (x * x - 1);
      const double dx = p1 / slope;
      x -= dx;
      if (std::abs(dx) < 1e-16) {
        break;
      }
    }
    nodes.push_back({(1 - x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

std::vector<QuadratureNode> symmetric_degree_5() {
  const double r = std::sqrt(15.0);
  std::vector<QuadratureNode> nodes{{1 / 3.0, 1 / 3.0, 1 / 3.0, 9.0 / 40}};
  for (const double sign : {-1.0, 1.0}) {
    const double b = (6 + sign * r) / 21, a = 1 - 2 * b, w = (155 + sign * r) / 1200;
    nodes.push_back({a, b, b, w});
    nodes.push_back({b, a, b, w});
    nodes.push_back({b, b, a, w});
  }
  return nodes;
}

std::vector<QuadratureNode> collapsed(int degree) {
  // The Jacobian of the collapse adds one degree along s.
  const auto line = gauss_legendre(degree / 2 + 1);
  std::vector<QuadratureNode> nodes;
  for (const auto& [s, ws] : line) {
    for (const auto& [t, wt] : line) {
      nodes.push_back({1 - s, s * (1 - t), s * t, 2 * s * ws * wt});
    }
  }
  return nodes;
}

constexpr int max_degree = 64;

}  // namespace

const std::vector<QuadratureNode>& triangle_rule(int degree) {
  static const auto rules = [] {
    std::array<std::vector<QuadratureNode>, max_degree + 1> all;
    for (int d = 0; d <= max_degree; ++d) {
      all[static_cast<std::size_t>(d)] = d <= 5 ? symmetric_degree_5() : collapsed(d);
    }
    return all;
  }();
  return rules[static_cast<std::size_t>(degree)];
}

}  // namespace ucvt
