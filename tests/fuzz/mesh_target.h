// One reader of meshes as a fuzz target: what it accepts must survive everything that looks at it.
#pragma once

#include "fuzz_input.h"
#include "mesh/readers.h"
#include "ucvt/mesh.h"

namespace ucvt::fuzz {

inline void check_indices(const TriangleMesh& mesh) {
  for (const auto& face : mesh.faces) {
    for (const auto v : face) {
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.positions.size()) {
        std::abort();
      }
    }
  }
}

template <typename Reader>
int read(Reader reader, const std::uint8_t* data, std::size_t size) {
  tolerate_faults([&] {
    const TriangleMesh mesh = reader(as_text(data, size));
    check_indices(mesh);
    static_cast<void>(survey(mesh));
    static_cast<void>(closed_surface(mesh));
  });
  return 0;
}

}  // namespace ucvt::fuzz
