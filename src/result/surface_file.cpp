#include "result/surface_file.h"

#include <bit>
#include <cstring>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "cover/layout.h"
#include "mesh/output_file.h"

namespace ucvt {
namespace {

static_assert(std::endian::native == std::endian::little, "the PLY says little endian");

template <class Number>
void put(std::string& out, Number value) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  out.append(bytes, sizeof value);
}

std::string header(const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment geometry {}\ncomment genus {}\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property double log_scale\n{}element face {}\nproperty list uchar int vertex_indices\n"
      "property list uchar double chord\nproperty list uchar int twin\n"
      "property list uchar double layout\nend_header\n",
      t.report.geometry, 1 - c.euler_number() / 2, c.vertex_count(),
      t.mirror.empty() ? "" : "property int mirror\n", c.face_count());
}

/// Every vertex of T as a point of T, for the way back to the input.
std::vector<SurfacePoint> vertices_as_points(const Connectivity& c) {
  std::vector<SurfacePoint> out;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const Halfedge h = c.outgoing({static_cast<std::int32_t>(v)});
    SurfacePoint p{h.face(), {0, 0, 0}};
    p.bary[static_cast<std::size_t>(h.id % 3)] = 1;
    out.push_back(p);
  }
  return out;
}

}  // namespace

void write_surface(const std::string& path, const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  std::string out = header(t);
  std::vector<Position> position = t.input.positions;
  if (c.vertex_count() > position.size()) {
    const auto carried = positions_on_input(t, vertices_as_points(c));
    position.insert(position.end(), carried.begin() + static_cast<std::ptrdiff_t>(position.size()),
                    carried.end());
  }
  for (std::size_t v = 0; v < position.size(); ++v) {
    for (const double x : position[v]) {
      put(out, x);
    }
    put(out, t.log_scale[v]);
    if (!t.mirror.empty()) {
      put(out, t.mirror[v]);
    }
  }
  const auto layout = fundamental_domain(t.surface, {0});
  for (std::size_t f = 0; f < c.face_count(); ++f) {
    const auto side = halfedges({static_cast<std::int32_t>(f)});
    put<std::uint8_t>(out, 3);
    for (const Halfedge h : side) {
      put(out, c.origin(h).id);
    }
    // Side i of the file is opposite to corner i.
    put<std::uint8_t>(out, 3);
    for (const Halfedge h : side) {
      put(out, t.surface.chord(h.next()));
    }
    put<std::uint8_t>(out, 3);
    for (const Halfedge h : side) {
      const Halfedge twin = c.twin(h.next());
      put(out, twin.prev().id);
    }
    put<std::uint8_t>(out, 9);
    for (const Offset& p : layout[f]) {
      put(out, p.x);
      put(out, p.y);
      put(out, model_z(t.surface.space(), p));
    }
  }
  OutputFile file(path);
  file.write(out);
  file.commit();
}

UniformizedSurface::UniformizedSurface(std::shared_ptr<const Uniformized> value)
    : value_(std::move(value)) {}

const UniformizationReport& UniformizedSurface::report() const {
  return value_->report;
}

void UniformizedSurface::write(const std::string& path) const {
  write_surface(path, *value_);
}

UniformizedSurface uniformize(const ClosedSurface& surface, const UniformizeOptions& options) {
  return UniformizedSurface(
      std::make_shared<const Uniformized>(uniformize_surface(surface, options)));
}

}  // namespace ucvt
