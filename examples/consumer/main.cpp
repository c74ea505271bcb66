// Uses an installed ucvt through its public headers only: a tetrahedron made in code, checked as a
// closed surface.
#include <exception>
#include <iostream>

#include "ucvt/mesh.h"
#include "ucvt/version.h"

int main() {
  try {
    const ucvt::TriangleMesh tetrahedron{
        .positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
        .faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
    const ucvt::ClosedSurface surface = ucvt::closed_surface(tetrahedron);
    std::cout << "ucvt " << UCVT_VERSION << ": " << surface.mesh.positions.size()
              << " vertices, genus " << surface.genus << '\n';
  } catch (const std::exception& error) {
    std::cerr << "consumer: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
