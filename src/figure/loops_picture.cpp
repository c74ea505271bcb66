#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "figure/solid.h"
#include "result/cover_data.h"
#include "result/loops_file.h"
#include "ucvt/surface_figure.h"

namespace ucvt {
namespace {

constexpr double loop_radius = 3.2;  ///< in pixels of a picture 600 wide
constexpr double dash = 9;           ///< where loops run together, in radii

/// Dark enough to stand out from the surface and apart from each other (Tol's "bright" scheme).
constexpr Colour loop_colours[] = {{204, 51, 68},  {51, 102, 170}, {34, 136, 51}, {221, 136, 17},
                                   {136, 51, 136}, {0, 153, 170},  {110, 80, 40}};

Colour loop_colour(std::size_t i) {
  return loop_colours[i % std::size(loop_colours)];
}

/// Where a loop's name stands: where it is seen and farthest from the others and their names.
struct LoopLabel {
  bool seen = false;
  Pixel at;
};

constexpr std::size_t label_candidates = 150;

std::vector<std::vector<Pixel>> seen_points(const Raster& raster, const View& view,
                                            const std::vector<std::vector<Position>>& loops) {
  std::vector<std::vector<Pixel>> out;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::vector<Pixel>& seen = out.emplace_back();
    const std::size_t stride = std::max<std::size_t>(1, loops[i].size() / label_candidates);
    for (std::size_t k = 0; k < loops[i].size(); k += stride) {
      const Position p = view.place(loops[i][k]);
      if (raster.label_at(p[0], p[1]) == static_cast<std::int32_t>(i + 1)) {
        seen.push_back({p[0], p[1]});
      }
    }
  }
  return out;
}

std::vector<LoopLabel> place_labels(const std::vector<std::vector<Pixel>>& seen, double font,
                                    const Shot& shot) {
  std::vector<LoopLabel> out(seen.size());
  const auto room = [&](const Pixel& p, std::size_t own) {
    double nearest = std::min({p.x, p.y, shot.width - p.x, shot.height - p.y}) + font;
    for (std::size_t j = 0; j < seen.size(); ++j) {
      for (const Pixel& q : seen[j]) {
        nearest = j == own ? nearest : std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
      }
      if (out[j].seen) {
        nearest = std::min(nearest, std::hypot(p.x - out[j].at.x, p.y - out[j].at.y));
      }
    }
    return nearest;
  };
  for (std::size_t i = 0; i < seen.size(); ++i) {
    double most = -1;
    LoopLabel best;
    for (std::size_t k = 0; k < seen[i].size(); ++k) {
      const double here = room(seen[i][k], i);
      if (here > most) {
        most = here;
        // Beside the curve, on the side away from the picture's middle.
        const Pixel &p = seen[i][k], &q = seen[i][k + 1 < seen[i].size() ? k + 1 : k - 1];
        Pixel n{p.y - q.y, q.x - p.x};
        const double length = std::hypot(n.x, n.y);
        const double out_x = p.x - shot.width / 2.0, out_y = p.y - shot.height / 2.0;
        const double sign = n.x * out_x + n.y * out_y < 0 ? -1 : 1;
        const double by = length > 0 ? sign * 1.1 * font / length : 0;
        best = {true, {p.x + by * n.x, p.y + by * n.y}};
      }
    }
    out[i] = best;
  }
  return out;
}

void loops_legend(Svg& svg, const DeckGroup& group, double top, double width, double font) {
  const double item = 4 * font;
  const auto in_row = static_cast<std::size_t>(std::max(1.0, width / item));
  const std::size_t n = group.generators.size();
  svg.open("g", {{"class", "legend"}});
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t row = i / in_row, here = std::min(in_row, n - row * in_row);
    const double x =
        width / 2 + item * (static_cast<double>(i % in_row) - static_cast<double>(here) / 2);
    const double y = top + font * (1.2 + 1.8 * static_cast<double>(row));
    svg.line({x + 0.4 * font, y}, {x + 1.9 * font, y},
             {{"stroke", hex(loop_colour(i))}, {"stroke-width", number(0.3 * font)}});
    const std::string& name = group.generators[i].name;
    svg.symbol({x + 2.7 * font, y}, name.substr(0, 1), name.substr(1), "", 1.2 * font);
  }
  svg.close();
}

/// The loops that run along a piece of a curve, by its ends; the same piece of two loops has the same
/// ends to the bit.
using Piece = std::pair<Position, Position>;

Piece piece_of(const std::vector<Position>& loop, std::size_t k) {
  return std::minmax(loop[k], loop[k + 1]);
}

/// Draws loops as tubes; where several run together, dashes of their colours in turn.
void draw_loops(Raster& raster, const Shot& shot, const std::vector<std::vector<Position>>& loops) {
  std::map<Piece, std::vector<std::size_t>> on;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t k = 0; k + 1 < loops[i].size(); ++k) {
      auto& here = on[piece_of(loops[i], k)];
      if (here.empty() || here.back() != i) {
        here.push_back(i);
      }
    }
  }
  const double radius = relative(loop_radius, shot.width);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    double along = 0;
    for (std::size_t k = 0; k + 1 < loops[i].size(); ++k) {
      const auto& here = on.at(piece_of(loops[i], k));
      const Position d = minus(loops[i][k + 1], loops[i][k]);
      along += shot.view.scale * std::sqrt(dot_product(d, d));
      const auto turn = static_cast<std::size_t>(along / (dash * radius)) % here.size();
      if (here.front() == i) {
        const std::size_t shown = here[turn];
        draw_tube(
            raster, shot.view, {loops[i][k], loops[i][k + 1]}, radius,
            static_cast<std::int32_t>(shown + 1),
            [shown](const Position&, const Position& n) { return lit(loop_colour(shown), n); });
      }
    }
  }
}

}  // namespace

std::string loops_picture(const Cover& cover, const SurfacePictureOptions& options) {
  const CoverData& data = cover.data();
  const Uniformized& t = data.surface.value();
  const Shot shot = fit(t.input, options);
  Raster raster(shot.width, shot.height);
  draw_plain_mesh(raster, shot.view, t.input);
  const auto loops = loops_on_input(t, data.system);
  draw_loops(raster, shot, loops);
  raster.ball(shot.view.place(loops[0][0]), 1.8 * relative(loop_radius, shot.width),
              static_cast<std::int32_t>(loops.size() + 1),
              [](const Position& n) { return lit(ink, n); });
  const double rows = std::ceil(static_cast<double>(loops.size()) * 4 / 50);
  return framed(
      raster, shot, options.title, 0.8 + 1.8 * rows, [&](Svg& svg, double top, double font) {
        const auto labels = place_labels(seen_points(raster, shot.view, loops), font, shot);
        svg.open("g", {{"class", "labels"}});
        for (std::size_t i = 0; i < labels.size(); ++i) {
          if (labels[i].seen) {
            const std::string& name = data.group.generators[i].name;
            svg.symbol({labels[i].at.x, top + labels[i].at.y}, name.substr(0, 1), name.substr(1),
                       "", 1.6 * font);
          }
        }
        svg.close();
        loops_legend(svg, data.group, top + shot.height, shot.width, font);
      });
}

}  // namespace ucvt
