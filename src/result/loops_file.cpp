#include "result/loops_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

namespace ucvt {
namespace {

/// Points taken along every edge of T, both ends included.
constexpr int samples = 33;

/// A sample this near to the line of its neighbours, relative to their distance, is left out.
constexpr double straight = 1e-9;

/// Points along a halfedge, evenly by the weights that count on the input.
void sample(const Uniformized& t, Halfedge h, std::vector<SurfacePoint>& out) {
  const Connectivity& c = t.surface.connectivity();
  const double tilt = std::exp(t.log_scale[c.origin(h).index()] - t.log_scale[c.head(h).index()]);
  for (int i = 0; i < samples; ++i) {
    const double along = static_cast<double>(i) / (samples - 1);
    const double from = 1 - along, to = along * tilt;
    SurfacePoint p{h.face(), {0, 0, 0}};
    const auto slot = static_cast<std::size_t>(h.id % 3);
    p.bary[slot] = from / (from + to);
    p.bary[(slot + 1) % 3] = to / (from + to);
    out.push_back(p);
  }
}

bool on_segment(const Position& p, const Position& a, const Position& b) {
  double length2 = 0, along = 0, off2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    length2 += (b[k] - a[k]) * (b[k] - a[k]);
    along += (b[k] - a[k]) * (p[k] - a[k]);
  }
  for (std::size_t k = 0; k < 3 && length2 > 0; ++k) {
    const double off = p[k] - a[k] - along / length2 * (b[k] - a[k]);
    off2 += off * off;
  }
  return off2 <= straight * straight * length2;
}

/// The samples without those on the way from one bend to the next.
std::vector<Position> bends(const Position* first, const Position* last) {
  std::vector<Position> out{*first};
  for (const Position* p = first + 1; p + 1 < last; ++p) {
    if (!on_segment(*p, out.back(), *(p + 1))) {
      out.push_back(*p);
    }
  }
  out.push_back(*(last - 1));
  return out;
}

}  // namespace

std::vector<std::vector<Position>> loops_on_input(const Uniformized& t, const DeckSystem& s) {
  const Connectivity& c = t.surface.connectivity();
  std::vector<std::vector<Halfedge>> paths;
  std::map<Halfedge, std::size_t> edge;  // one halfedge of each: its place among the curves
  std::vector<SurfacePoint> points;
  for (const Word& w : s.canonical.word) {
    paths.push_back(loop_path(s.cut, c, w));
    for (const Halfedge h : paths.back()) {
      if (edge.emplace(std::min(h, c.twin(h)), edge.size()).second) {
        sample(t, std::min(h, c.twin(h)), points);
      }
    }
  }
  const std::vector<Position> on_input = positions_on_input(t, points);
  std::vector<std::vector<Position>> curves;
  for (std::size_t i = 0; i < on_input.size(); i += samples) {
    curves.push_back(bends(&on_input[i], &on_input[i] + samples));
  }
  std::vector<std::vector<Position>> out;
  for (const auto& path : paths) {
    std::vector<Position>& loop = out.emplace_back();
    for (const Halfedge h : path) {
      std::vector<Position> curve = curves[edge.at(std::min(h, c.twin(h)))];
      if (c.twin(h) < h) {
        std::reverse(curve.begin(), curve.end());
      }
      loop.insert(loop.end(), curve.begin() + (loop.empty() ? 0 : 1), curve.end());
    }
    // The last point is the base again, carried there from another face.
    loop.back() = loop.front();
  }
  return out;
}

std::string loops_obj(const Uniformized& t, const DeckSystem& s, const DeckGroup& group) {
  std::string out;
  std::size_t next = 1;
  const auto loops = loops_on_input(t, s);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::string line = "l";
    const std::size_t first = next;
    for (std::size_t k = 0; k + 1 < loops[i].size(); ++k, ++next) {
      const Position& p = loops[i][k];
      fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p[0], p[1], p[2]);
      fmt::format_to(std::back_inserter(line), " {}", next);
    }
    fmt::format_to(std::back_inserter(out), "o {}\n{} {}\n", group.generators[i].name, line, first);
  }
  return out;
}

}  // namespace ucvt
