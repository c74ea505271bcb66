#include "ucvt/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Mean, variation and range of the values of both, given how many there are.
class SpreadSum {
 public:
  void add(const Spread& s, double count) {
    const double deviation = s.cv * s.mean;
    min_ = count_ > 0 ? std::min(min_, s.min) : s.min;
    max_ = count_ > 0 ? std::max(max_, s.max) : s.max;
    const double total = count_ + count, step = s.mean - mean_;
    squares_ += count * deviation * deviation + step * step * count_ * count / total;
    mean_ += step * count / total;
    count_ = total;
  }
  [[nodiscard]] Spread value() const {
    const double deviation = count_ > 0 ? std::sqrt(squares_ / count_) : 0;
    return {mean_, mean_ != 0 ? deviation / std::abs(mean_) : 0, min_, max_};
  }

 private:
  double count_ = 0, mean_ = 0, squares_ = 0, min_ = 0, max_ = 0;
};

RemeshResult remesh_named(const Component& component, const RemeshOptions& options) {
  const auto named = [&](const std::exception& error) {
    return fmt::format("the component of face {}: {}", component.input_face.front(), error.what());
  };
  try {
    return remesh(component.surface, options);
  } catch (const InvalidInput& error) {
    throw InvalidInput(named(error));
  } catch (const NumericalError& error) {
    throw NumericalError(named(error));
  }
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const auto first = static_cast<std::int32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  for (const Corners& f : more.faces) {
    mesh.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  }
}

/// Puts partitions of components into one of the whole mesh.
class PartitionJoiner {
 public:
  explicit PartitionJoiner(const std::vector<Component>& components) {
    for (const Component& c : components) {
      const std::vector<std::int32_t>& own = c.surface.input_vertex;
      out_.input_vertex.insert(out_.input_vertex.end(), own.begin(), own.end());
      out_.input_face.insert(out_.input_face.end(), c.input_face.begin(), c.input_face.end());
    }
    std::sort(out_.input_vertex.begin(), out_.input_vertex.end());
    std::sort(out_.input_face.begin(), out_.input_face.end());
    all().mesh.positions.resize(out_.input_vertex.size());
    all().vertex_cell.resize(out_.input_vertex.size());
    all().face_cell.resize(out_.input_face.size());
  }

  void add(const Component& component, Partition&& part) {
    const auto first_cell = static_cast<std::int32_t>(all().cells.size());
    add_vertices(component, part, first_cell);
    std::vector<std::int32_t> face;
    for (std::size_t f = 0; f < part.face_cell.size(); ++f) {
      face.push_back(place(out_.input_face, component.input_face[f]));
      all().face_cell[index(face[f])] = part.face_cell[f] + first_cell;
    }
    for (std::size_t f = 0; f < part.mesh.faces.size(); ++f) {
      const Corners& c = part.mesh.faces[f];
      all().mesh.faces.push_back(
          {number_[index(c[0])], number_[index(c[1])], number_[index(c[2])]});
      all().cell.push_back(part.cell[f] + first_cell);
      all().input_face.push_back(face[index(part.input_face[f])]);
    }
    for (PartitionCell& cell : part.cells) {
      for (std::int32_t& neighbour : cell.neighbours) {
        neighbour += first_cell;
      }
      all().cells.push_back(std::move(cell));
    }
    all().colours = std::max(all().colours, part.colours);
  }

  JoinedPartition take() { return std::move(out_); }

 private:
  static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
  static std::int32_t place(const std::vector<std::int32_t>& ascending, std::int32_t number) {
    const auto found = std::lower_bound(ascending.begin(), ascending.end(), number);
    return static_cast<std::int32_t>(found - ascending.begin());
  }
  Partition& all() { return out_.partition; }

  void add_vertices(const Component& component, const Partition& part, std::int32_t first_cell) {
    const std::vector<std::int32_t>& input = component.surface.input_vertex;
    number_.clear();
    for (std::size_t v = 0; v < input.size(); ++v) {
      number_.push_back(place(out_.input_vertex, input[v]));
      const std::size_t n = index(number_.back());
      all().mesh.positions[n] = part.mesh.positions[v];
      all().vertex_cell[n] = part.vertex_cell[v] + first_cell;
    }
    for (std::size_t v = input.size(); v < part.mesh.positions.size(); ++v) {
      number_.push_back(static_cast<std::int32_t>(all().mesh.positions.size()));
      all().mesh.positions.push_back(part.mesh.positions[v]);
    }
  }

  JoinedPartition out_;
  std::vector<std::int32_t> number_;  // of each vertex of the part
};

}  // namespace

std::vector<RemeshResult> remesh(const std::vector<Component>& components,
                                 const RemeshOptions& options) {
  if (components.size() == 1) {
    return {remesh(components.front().surface, options)};
  }
  if (!options.initial_sites.empty() || !options.initial_size.empty()) {
    throw InvalidInput(
        fmt::format("initial sites lie on one component, but there are {}; remesh that one",
                    components.size()));
  }
  const std::vector<int> sites = share_sites(components, options.sites);
  std::vector<RemeshResult> results;
  for (std::size_t i = 0; i < components.size(); ++i) {
    RemeshOptions own = options;
    own.sites = sites[i];
    results.push_back(remesh_named(components[i], own));
  }
  return results;
}

TriangleMesh joined_mesh(const std::vector<RemeshResult>& results) {
  TriangleMesh mesh;
  for (const RemeshResult& r : results) {
    append(mesh, r.mesh);
  }
  return mesh;
}

JoinedReport joined_report(const std::vector<RemeshResult>& results) {
  if (results.size() == 1) {
    return {results[0].report, results[0].cvt, results[0].cell_area_3d};
  }
  JoinedReport out;
  out.remesh.simplicial = out.cvt.converged = true;
  SpreadSum areas;
  double move = 0;
  for (const RemeshResult& r : results) {
    out.remesh.vertices += r.report.vertices;
    out.remesh.faces += r.report.faces;
    out.remesh.genus += r.report.genus;
    out.remesh.boundary_loops += r.report.boundary_loops;
    out.remesh.simplicial = out.remesh.simplicial && r.report.simplicial;
    out.remesh.sites_added += r.report.sites_added;
    out.cvt.method = r.cvt.method;
    out.cvt.sites += r.cvt.sites;
    out.cvt.iterations += r.cvt.iterations;
    out.cvt.converged = out.cvt.converged && r.cvt.converged;
    out.cvt.seconds += r.cvt.seconds;
    move = r.cvt.max_move.empty() ? move : std::max(move, r.cvt.max_move.back());
    areas.add(r.cell_area_3d, static_cast<double>(r.cvt.sites));
  }
  out.cvt.max_move = {move};
  out.remesh.quality = measure_quality(joined_mesh(results));
  out.cell_area_3d = areas.value();
  return out;
}

JoinedPartition partition(const std::vector<Component>& components,
                          const std::vector<RemeshResult>& results) {
  PartitionJoiner joiner(components);
  for (std::size_t i = 0; i < components.size(); ++i) {
    joiner.add(components[i], partition(results[i]));
  }
  return joiner.take();
}

JoinedPartition partition(const OpenSurface& surface, const RemeshResult& result) {
  JoinedPartition out{partition(result), surface.input_vertex, {}};
  out.input_face.resize(surface.mesh.faces.size());
  std::iota(out.input_face.begin(), out.input_face.end(), 0);
  return out;
}

}  // namespace ucvt
