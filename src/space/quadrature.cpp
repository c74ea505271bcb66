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

/// Adds the nodes of one orbit under the triangle's symmetries.
void add_orbit(std::vector<QuadratureNode>& nodes, double a, double b, double c, double weight) {
  nodes.push_back({a, b, c, weight});
  nodes.push_back({b, c, a, weight});
  nodes.push_back({c, a, b, weight});
  if (b != c) {
    nodes.push_back({a, c, b, weight});
    nodes.push_back({c, b, a, weight});
    nodes.push_back({b, a, c, weight});
  }
}

std::vector<QuadratureNode> symmetric_degree_6() {
  std::vector<QuadratureNode> nodes;
  add_orbit(nodes, 0.501426509658179, 0.249286745170910, 0.249286745170910, 0.116786275726379);
  add_orbit(nodes, 0.873821971016996, 0.063089014491502, 0.063089014491502, 0.050844906370207);
  add_orbit(nodes, 0.053145049844817, 0.310352451033784, 0.636502499121399, 0.082851075618374);
  return nodes;
}

std::vector<QuadratureNode> symmetric_degree_8() {
  std::vector<QuadratureNode> nodes{{1 / 3.0, 1 / 3.0, 1 / 3.0, 0.144315607677787}};
  add_orbit(nodes, 0.081414823414554, 0.459292588292723, 0.459292588292723, 0.095091634267285);
  add_orbit(nodes, 0.658861384496480, 0.170569307751760, 0.170569307751760, 0.103217370534718);
  add_orbit(nodes, 0.898905543365938, 0.050547228317031, 0.050547228317031, 0.032458497623198);
  add_orbit(nodes, 0.008394777409958, 0.263112829634638, 0.728492392955404, 0.027230314174435);
  return nodes;
}

/// Published digits end at 1e-15; this makes the weights sum to 1 to the last bit or two.
std::vector<QuadratureNode> normalized(std::vector<QuadratureNode> nodes) {
  double sum = 0;
  for (const QuadratureNode& n : nodes) {
    sum += n.weight;
  }
  for (QuadratureNode& n : nodes) {
    n.weight /= sum;
  }
  return nodes;
}

std::vector<QuadratureNode> collapsed(int degree) {
  // The Jacobian of the collapse adds one degree along s.
  const auto line = gauss_legendre((degree + 3) / 2);
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
      all[static_cast<std::size_t>(d)] = normalized(d <= 5   ? symmetric_degree_5()
                                                    : d == 6 ? symmetric_degree_6()
                                                    : d <= 8 ? symmetric_degree_8()
                                                             : collapsed(d));
    }
    return all;
  }();
  return rules[static_cast<std::size_t>(degree)];
}

}  // namespace ucvt
