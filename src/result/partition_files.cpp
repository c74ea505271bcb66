// Writers of partition.h: PLY and CSV.
#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "mesh/output_file.h"
#include "result/colouring.h"
#include "ucvt/partition.h"

namespace ucvt {
namespace {

template <class T>
void put(std::string& record, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (std::endian::native == std::endian::big) {
    std::reverse(raw, raw + sizeof(T));
  }
  record.append(raw, sizeof(T));
}

}  // namespace

void write_partition(const std::string& path, const Partition& p) {
  OutputFile file(path);
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
                  "property double y\nproperty double z\nelement face {}\n"
                  "property list uchar int vertex_indices\nproperty int cell\n"
                  "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
                  p.mesh.positions.size(), p.mesh.faces.size()));
  std::string record;
  for (const Position& x : p.mesh.positions) {
    record.clear();
    for (const double c : x) {
      put(record, c);
    }
    file.write(record);
  }
  for (std::size_t f = 0; f < p.mesh.faces.size(); ++f) {
    record.assign(1, '\3');
    for (const std::int32_t v : p.mesh.faces[f]) {
      put(record, v);
    }
    put(record, p.cell[f]);
    const auto cell = static_cast<std::size_t>(p.cell[f]);
    const auto colour = static_cast<std::size_t>(p.cells[cell].colour);
    for (const std::uint8_t channel : cell_palette[colour % cell_palette.size()]) {
      put(record, channel);
    }
    file.write(record);
  }
  file.commit();
}

void write_labels(const std::string& path, const Partition& p,
                  const std::vector<std::int32_t>& input_vertex,
                  const std::vector<std::int32_t>& input_face) {
  OutputFile file(path);
  file.write("element,number,cell\n");
  for (std::size_t v = 0; v < p.vertex_cell.size(); ++v) {
    if (input_vertex[v] >= 0) {
      file.write(fmt::format("vertex,{},{}\n", input_vertex[v], p.vertex_cell[v]));
    }
  }
  for (std::size_t f = 0; f < p.face_cell.size(); ++f) {
    const auto number = input_face.empty() ? static_cast<std::int32_t>(f) : input_face[f];
    if (number >= 0) {
      file.write(fmt::format("face,{},{}\n", number, p.face_cell[f]));
    }
  }
  file.commit();
}

void write_cells(const std::string& path, const Partition& p) {
  OutputFile file(path);
  file.write("cell,x,y,z,area_3d,area,radius,nearest,degree,colour,neighbours\n");
  for (std::size_t i = 0; i < p.cells.size(); ++i) {
    const PartitionCell& c = p.cells[i];
    file.write(fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", i, c.site[0], c.site[1], c.site[2],
                           c.area_3d, c.area, c.radius, c.nearest, c.degree, c.colour,
                           fmt::join(c.neighbours, " ")));
  }
  file.commit();
}

}  // namespace ucvt
