#include "result/uv_file.h"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

std::vector<Position> vertex_positions(const Uniformized& t) {
  const Connectivity& c = t.surface.connectivity();
  std::vector<SurfacePoint> points;
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    const Halfedge h = c.outgoing({static_cast<std::int32_t>(v)});
    SurfacePoint p{h.face(), {0, 0, 0}};
    p.bary[static_cast<std::size_t>(h.id % 3)] = 1;
    points.push_back(p);
  }
  std::vector<Position> out = positions_on_input(t, points);
  std::copy(t.input.positions.begin(), t.input.positions.end(), out.begin());
  return out;
}

}  // namespace

std::string uv_obj(const Uniformized& t, const DeckSystem& s, CoverCoordinates coordinates) {
  const Connectivity& c = t.surface.connectivity();
  const std::vector<DeckMap> corner = laid_out(t.surface, s);
  std::string out, faces;
  for (const Position& p : vertex_positions(t)) {
    fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p[0], p[1], p[2]);
  }
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> lift;
  for (std::size_t i = 0; i < corner.size(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    const auto [place, is_new] =
        lift.emplace(std::pair{c.origin(h).id, s.cut.letters_before[i]}, lift.size() + 1);
    if (is_new) {
      const auto uv = coordinates_of(s.kappa, corner[i], coordinates);
      if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) {
        throw NumericalError("the layout of this surface reaches farther than doubles");
      }
      fmt::format_to(std::back_inserter(out), "vt {} {}\n", uv[0], uv[1]);
    }
    faces += fmt::format("{} {}/{}{}", i % 3 == 0 ? "f" : "", c.origin(h).id + 1, place->second,
                         i % 3 == 2 ? "\n" : "");
  }
  return out + faces;
}

}  // namespace ucvt
