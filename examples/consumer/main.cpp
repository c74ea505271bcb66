// Uses an installed ucvt through its public headers only: surfaces made in code, checked as closed
// surfaces; one of them, a torus, is remeshed.
#include <cmath>
#include <exception>
#include <iostream>
#include <numbers>

#include "ucvt/mesh.h"
#include "ucvt/remesh.h"
#include "ucvt/version.h"

namespace {

ucvt::TriangleMesh tetrahedron() {
  return {.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          .faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

/// Radii 1 and 0.4, cut into n x m quadrilaterals and these in two.
ucvt::TriangleMesh torus(int n, int m) {
  ucvt::TriangleMesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      const double r = 1 + 0.4 * std::cos(b);
      mesh.positions.push_back({r * std::cos(a), r * std::sin(a), 0.4 * std::sin(b)});
      const int next_i = (i + 1) % n, next_j = (j + 1) % m;
      mesh.faces.push_back({i * m + j, next_i * m + j, next_i * m + next_j});
      mesh.faces.push_back({i * m + j, next_i * m + next_j, i * m + next_j});
    }
  }
  return mesh;
}

}  // namespace

int main() {
  try {
    std::cout << "ucvt " << UCVT_VERSION << '\n';
    std::cout << "tetrahedron: genus " << ucvt::closed_surface(tetrahedron()).genus << '\n';

    const ucvt::ClosedSurface surface = ucvt::closed_surface(torus(24, 12));
    ucvt::RemeshOptions options;
    options.sites = 60;
    options.iterations = 20;
    const ucvt::RemeshResult result = ucvt::remesh(surface, options);
    std::cout << "torus: genus " << result.report.genus << ", " << result.mesh.positions.size()
              << " vertices\n";
  } catch (const std::exception& error) {
    std::cerr << "consumer: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
