#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "mesh/file_extension.h"
#include "mesh/invalid.h"
#include "mesh/output_file.h"
#include "ucvt/mesh.h"

namespace ucvt {
namespace {

template <typename T>
void append_text(std::string& line, T value) {
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  line.append(digits, end);
}

template <typename T>
void append_bytes(std::string& record, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (std::endian::native == std::endian::big) {
    std::reverse(raw, raw + sizeof(T));
  }
  record.append(raw, sizeof(T));
}

void write_position(OutputFile& out, std::string_view before, const Position& position) {
  std::string line(before);
  for (std::size_t k = 0; k < 3; ++k) {
    if (k > 0) {
      line += ' ';
    }
    append_text(line, position[k]);
  }
  line += '\n';
  out.write(line);
}

void write_face(OutputFile& out, std::string_view before, const Corners& face, std::int64_t first) {
  std::string line(before);
  for (const std::int32_t corner : face) {
    line += ' ';
    append_text(line, corner + first);
  }
  line += '\n';
  out.write(line);
}

void write_obj(OutputFile& out, const TriangleMesh& mesh) {
  for (const Position& p : mesh.positions) {
    write_position(out, "v ", p);
  }
  for (const Corners& f : mesh.faces) {
    write_face(out, "f", f, 1);
  }
}

void write_off(OutputFile& out, const TriangleMesh& mesh) {
  out.write(fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.faces.size()));
  for (const Position& p : mesh.positions) {
    write_position(out, "", p);
  }
  for (const Corners& f : mesh.faces) {
    write_face(out, "3", f, 0);
  }
}

void write_ply(OutputFile& out, const TriangleMesh& mesh) {
  out.write(
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
                  "property double y\nproperty double z\nelement face {}\n"
                  "property list uchar int vertex_indices\nend_header\n",
                  mesh.positions.size(), mesh.faces.size()));
  std::string record;
  for (const Position& p : mesh.positions) {
    record.clear();
    for (const double c : p) {
      append_bytes(record, c);
    }
    out.write(record);
  }
  for (const Corners& f : mesh.faces) {
    record.assign(1, '\3');
    for (const std::int32_t corner : f) {
      append_bytes(record, corner);
    }
    out.write(record);
  }
}

// Unit normal of a face, computed at size one so that nothing overflows; zero when it has no area.
Position unit_normal(const Position& a, const Position& b, const Position& c) {
  Position u, v;
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    size = std::max({size, std::abs(u[k]), std::abs(v[k])});
  }
  if (!(size > 0) || !std::isfinite(size)) {
    return {0, 0, 0};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] /= size;
    v[k] /= size;
  }
  const Position n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  if (!(length > 0)) {
    return {0, 0, 0};
  }
  return {n[0] / length, n[1] / length, n[2] / length};
}

void write_stl(OutputFile& out, const TriangleMesh& mesh) {
  constexpr std::size_t header_size = 80;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (const double c : mesh.positions[v]) {
      if (std::abs(c) > static_cast<double>(std::numeric_limits<float>::max())) {
        refuse("vertex {} has coordinate {}, which STL cannot hold; write OBJ, OFF or PLY", v, c);
      }
    }
  }
  std::string record = "ucvt, binary STL";  // must not begin with "solid"
  record.resize(header_size, ' ');
  append_bytes(record, static_cast<std::uint32_t>(mesh.faces.size()));
  out.write(record);
  for (const Corners& face : mesh.faces) {
    const auto at = [&](std::size_t k) {
      return mesh.positions[static_cast<std::size_t>(face[k])];
    };
    record.clear();
    for (const Position& p : {unit_normal(at(0), at(1), at(2)), at(0), at(1), at(2)}) {
      for (const double c : p) {
        append_bytes(record, static_cast<float>(c));
      }
    }
    record.append(2, '\0');
    out.write(record);
  }
}

}  // namespace

void write_mesh(const std::string& path, const TriangleMesh& mesh) {
  const std::string extension = path == "-" ? ".off" : file_extension(path);
  const auto writer = extension == ".obj"   ? write_obj
                      : extension == ".off" ? write_off
                      : extension == ".ply" ? write_ply
                      : extension == ".stl" ? write_stl
                                            : nullptr;
  if (writer == nullptr) {
    refuse("the extension {} names no mesh format; use .obj, .off, .ply or .stl",
           in_quotes(extension));
  }
  OutputFile out(path);
  writer(out, mesh);
  out.commit();
}

}  // namespace ucvt
