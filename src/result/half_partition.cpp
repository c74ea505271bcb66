#include "result/half_partition.h"

#include <algorithm>
#include <map>
#include <utility>

#include "ucvt/error.h"

namespace ucvt {
namespace {

std::size_t index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

class HalfPartition {
 public:
  HalfPartition(const Partition& whole, const HalfOfDouble& half)
      : whole_(whole), half_(half), number_(whole.cells.size(), -1) {
    for (std::size_t i = 0; i < half.sites.size(); ++i) {
      number_[half.sites[i].index()] = static_cast<std::int32_t>(i);
    }
  }

  Partition run() {
    add_faces();
    add_vertices();
    for (const Vertex site : half_.sites) {
      add_cell(site);
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] std::int32_t number(std::int32_t cell) const {
    const std::int32_t n = number_[index(cell)];
    if (n < 0) {
      throw NumericalError(
          "a cell reaches across the boundary by rounding; ask for another number of sites");
    }
    return n;
  }

  void add_faces() {
    for (std::size_t f = 0; f < whole_.mesh.faces.size(); ++f) {
      if (index(whole_.input_face[f]) < half_.input_face.size()) {
        out_.mesh.faces.push_back(whole_.mesh.faces[f]);
        out_.cell.push_back(number(whole_.cell[f]));
        out_.input_face.push_back(half_.input_face[index(whole_.input_face[f])]);
      }
    }
    name_faces();
  }

  /// By the cell that has the largest part.
  void name_faces() {
    std::map<std::pair<std::int32_t, std::int32_t>, double> share;
    for (std::size_t f = 0; f < out_.cell.size(); ++f) {
      share[{out_.input_face[f], out_.cell[f]}] += face_area(whole_.mesh, out_.mesh.faces[f]);
    }
    const auto last = std::max_element(half_.input_face.begin(), half_.input_face.end());
    out_.face_cell.assign(index(*last) + 1, -1);
    std::vector<double> most(out_.face_cell.size(), -1);
    for (const auto& [part, area] : share) {
      const std::size_t face = index(part.first);
      if (area > most[face]) {
        most[face] = area, out_.face_cell[face] = part.second;
      }
    }
  }

  /// The input's first, then those of the half's faces in their order.
  void add_vertices() {
    constexpr std::int32_t unused = -1, used = -2;
    std::vector<std::int32_t> vertex(whole_.mesh.positions.size(), unused);
    for (const Corners& f : out_.mesh.faces) {
      for (const std::int32_t v : f) {
        vertex[index(v)] = used;
      }
    }
    for (std::size_t v = 0; v < vertex.size(); ++v) {
      if (v < half_.input_vertices || vertex[v] == used) {
        vertex[v] = static_cast<std::int32_t>(out_.mesh.positions.size());
        out_.mesh.positions.push_back(whole_.mesh.positions[v]);
      }
      if (v < half_.input_vertices) {
        out_.vertex_cell.push_back(number(whole_.vertex_cell[v]));
      }
    }
    for (Corners& f : out_.mesh.faces) {
      for (std::int32_t& v : f) {
        v = vertex[index(v)];
      }
    }
  }

  void add_cell(Vertex site) {
    PartitionCell cell = whole_.cells[site.index()];
    if (site.index() < half_.on_line) {
      // Two neighbours on the boundary, the others in pairs.
      cell.area /= 2;
      cell.degree = cell.degree / 2 + 1;
    }
    std::vector<std::int32_t> neighbours;
    for (const std::int32_t neighbour : cell.neighbours) {
      if (number_[index(neighbour)] >= 0) {
        neighbours.push_back(number_[index(neighbour)]);
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    cell.neighbours = std::move(neighbours);
    out_.cells.push_back(std::move(cell));
  }

  const Partition& whole_;
  const HalfOfDouble& half_;
  std::vector<std::int32_t> number_;  // by cell of the double: in the half, or -1
  Partition out_;
};

}  // namespace

Partition half_partition(const Partition& whole, const HalfOfDouble& half) {
  return HalfPartition(whole, half).run();
}

}  // namespace ucvt
