// What the tests of the mesh room share: a folder of their own, small surfaces, caught messages.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "ucvt/error.h"
#include "ucvt/mesh.h"

namespace ucvt::test {

/// A folder that is removed with all it holds.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "ucvt-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw IoError("cannot make a folder");
    }
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
    return file(name);
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

inline std::string slurp(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Reads a mesh from the bytes of a file of this name.
inline TriangleMesh read_bytes(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return read_mesh(folder.write(name, bytes));
}

/// The message of the InvalidInput that the call throws, or "" with a failure.
template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
    return message;
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

inline std::string read_refusal(const std::string& name, const std::string& bytes) {
  return refusal([&] { read_bytes(name, bytes); });
}

inline std::string closed_refusal(const TriangleMesh& mesh) {
  return refusal([&] { closed_surface(mesh); });
}

#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

/// A rows x columns grid of squares cut in two, glued to a torus, or to a Klein bottle when the
/// columns are glued in reverse.
inline TriangleMesh grid_surface(std::int32_t rows, std::int32_t columns, bool klein = false) {
  TriangleMesh mesh;
  for (std::int32_t i = 0; i < rows; ++i) {
    for (std::int32_t j = 0; j < columns; ++j) {
      const double a = 2 * std::numbers::pi * i / rows, b = 2 * std::numbers::pi * j / columns;
      const double r = 2 + std::cos(b);
      mesh.positions.push_back({r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  }
  const auto at = [&](std::int32_t i, std::int32_t j) {
    if (klein && i == rows) {
      j = 2 * columns - j;
    }
    return (i % rows) * columns + j % columns;
  };
  for (std::int32_t i = 0; i < rows; ++i) {
    for (std::int32_t j = 0; j < columns; ++j) {
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

inline TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

}  // namespace ucvt::test
