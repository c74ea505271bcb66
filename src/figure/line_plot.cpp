#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "figure/svg.h"
#include "figure/ticks.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"

namespace ucvt {
namespace {

constexpr double font = 13;
constexpr double line_width = 1.6;
constexpr double pad = 0.05;  ///< left free above and below the curves

struct Style {
  std::string_view colour, dashes;
};

// Colours told apart in all common kinds of colour blindness (after Okabe and Ito, darkened for
// white paper), and dashes for prints without colour.
constexpr std::array<Style, 6> styles{{{"#000000", "none"},
                                       {"#c04a00", "7 3"},
                                       {"#0068a8", "2 2.5"},
                                       {"#00805c", "10 3 2 3"},
                                       {"#b0508a", "4 2"},
                                       {"#806800", "12 3 2 2 2 3"}}};

/// Linear coordinate along an axis.
double along(const PlotAxis& axis, double value) {
  return axis.scale == AxisScale::Log ? std::log10(value) : value;
}

bool drawable(const PlotAxis& axis, double value) {
  return std::isfinite(value) && (axis.scale == AxisScale::Linear || value > 0);
}

struct Range {
  double lo = std::numeric_limits<double>::max(), hi = std::numeric_limits<double>::lowest();

  void include(double v) { lo = std::min(lo, v), hi = std::max(hi, v); }
};

/// Where the plot lies and what it spans, in coordinates along the axes.
struct PlotArea {
  double left = 0, right = 0, top = 0, bottom = 0;
  Range x, y;

  [[nodiscard]] double px(double v) const {
    return left + (right - left) * (v - x.lo) / (x.hi - x.lo);
  }
  [[nodiscard]] double py(double v) const {
    return bottom - (bottom - top) * (v - y.lo) / (y.hi - y.lo);
  }
};

void widen(Range& r, double share) {
  const double span = r.hi - r.lo, size = std::max(std::abs(r.lo), std::abs(r.hi));
  // A range of a few roundings has no ticks: it is as good as one value.
  const bool flat = span <= 1e-12 * size;
  const double by = flat ? (size > 0 ? 0.1 * size : 1) : share * span;
  r.lo -= by, r.hi += by;
}

void check(const PlotSpec& spec) {
  for (const PlotSeries& s : spec.series) {
    if (s.x.size() != s.y.size()) {
      throw InvalidInput(fmt::format("series '{}' has {} x and {} y; give as many of each", s.name,
                                     s.x.size(), s.y.size()));
    }
  }
  if (spec.width < 200 || spec.height < 150 || spec.width > 20000 || spec.height > 20000) {
    throw InvalidInput(fmt::format("plot of {} x {} pixels; give 200 x 150 to 20000 x 20000",
                                   spec.width, spec.height));
  }
}

void set_ranges(const PlotSpec& spec, PlotArea& f) {
  for (const PlotSeries& s : spec.series) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (drawable(spec.x, s.x[i]) && drawable(spec.y, s.y[i])) {
        f.x.include(along(spec.x, s.x[i]));
        f.y.include(along(spec.y, s.y[i]));
      }
    }
  }
  if (f.x.lo > f.x.hi) {
    throw InvalidInput("no point to plot; give finite values, positive ones on logarithmic axes");
  }
  widen(f.x, 0);
  widen(f.y, pad);
}

Ticks ticks_of(const PlotAxis& axis, const Range& r, int count) {
  return axis.scale == AxisScale::Log ? log_ticks(std::pow(10.0, r.lo), std::pow(10.0, r.hi), count)
                                      : linear_ticks(r.lo, r.hi, count);
}

double widest(const std::vector<std::string>& labels) {
  double w = 0;
  for (const std::string& s : labels) {
    w = std::max(w, text_width(s, font));
  }
  return w;
}

/// As many ticks as leave their labels apart.
Ticks x_ticks(const PlotAxis& axis, const Range& r, double width) {
  for (int count = 10; count > 2; --count) {
    Ticks t = ticks_of(axis, r, count);
    double last = -width;
    bool apart = true;
    for (std::size_t i = 0; i < t.at.size(); ++i) {
      const double x = width * (along(axis, t.at[i]) - r.lo) / (r.hi - r.lo);
      const double half = text_width(t.labels[i], font) / 2;
      apart = apart && x - half > last;
      last = x + half + font;
    }
    if (apart) {
      return t;
    }
  }
  return ticks_of(axis, r, 2);
}

void draw_axes(Svg& svg, const PlotSpec& spec, const PlotArea& f, const Ticks& xt,
               const Ticks& yt) {
  const double middle_x = (f.left + f.right) / 2, middle_y = (f.top + f.bottom) / 2;
  svg.open("g", {{"class", "axes"}, {"stroke", "none"}, {"stroke-width", "1"}});
  for (std::size_t i = 0; i < xt.at.size(); ++i) {
    const double x = f.px(along(spec.x, xt.at[i]));
    svg.line({x, f.top}, {x, f.bottom}, {{"stroke", "#e2e2e2"}});
    svg.line({x, f.bottom}, {x, f.bottom + 5}, {{"stroke", "#000000"}});
    svg.text({x, f.bottom + 6 + font}, xt.labels[i],
             {{"class", "x-tick"}, {"text-anchor", "middle"}});
  }
  for (std::size_t i = 0; i < yt.at.size(); ++i) {
    const double y = f.py(along(spec.y, yt.at[i]));
    svg.line({f.left, y}, {f.right, y}, {{"stroke", "#e2e2e2"}});
    svg.line({f.left - 5, y}, {f.left, y}, {{"stroke", "#000000"}});
    svg.text({f.left - 8, y + 0.35 * font}, yt.labels[i],
             {{"class", "y-tick"}, {"text-anchor", "end"}});
  }
  svg.element("rect", {{"x", number(f.left)},
                       {"y", number(f.top)},
                       {"width", number(f.right - f.left)},
                       {"height", number(f.bottom - f.top)},
                       {"fill", "none"},
                       {"stroke", "#000000"}});
  const auto titled = [](const PlotAxis& axis, const Ticks& t) {
    return t.factor.empty()
               ? axis.title
               : fmt::format("{}{}({})", axis.title, axis.title.empty() ? "" : " ", t.factor);
  };
  svg.text({middle_x, f.bottom + 8 + 2.6 * font}, titled(spec.x, xt), {{"text-anchor", "middle"}});
  svg.text({0, 0}, titled(spec.y, yt),
           {{"text-anchor", "middle"},
            {"transform",
             fmt::format("translate({} {}) rotate(-90)", number(1.4 * font), number(middle_y))}});
  svg.close();
}

Path curve(const PlotSpec& spec, const PlotSeries& s, const PlotArea& f) {
  Path path;
  bool drawing = false;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const bool good = drawable(spec.x, s.x[i]) && drawable(spec.y, s.y[i]);
    if (good) {
      const Pixel p{f.px(along(spec.x, s.x[i])), f.py(along(spec.y, s.y[i]))};
      // A lone point is a dot: a line to itself with round ends.
      drawing ? path.line(p) : path.move(p).line(p);
    }
    drawing = good;
  }
  return path;
}

void draw_curves(Svg& svg, const PlotSpec& spec, const PlotArea& f) {
  svg.open("g", {{"class", "curves"},
                 {"fill", "none"},
                 {"stroke-width", number(line_width)},
                 {"stroke-linejoin", "round"},
                 {"stroke-linecap", "round"}});
  for (std::size_t i = 0; i < spec.series.size(); ++i) {
    const Style& style = styles[i % styles.size()];
    svg.element("path", {{"stroke", std::string(style.colour)},
                         {"stroke-dasharray", std::string(style.dashes)},
                         {"d", curve(spec, spec.series[i], f).data()}});
  }
  svg.close();
}

constexpr double sample_px = 34;  ///< of line beside each name

double legend_width(const PlotSpec& spec) {
  double w = 0;
  for (const PlotSeries& s : spec.series) {
    w = std::max(w, s.name.empty() ? 0 : text_width(s.name, font) + sample_px + 2 * font);
  }
  return std::min(w, 0.45 * spec.width);
}

void draw_legend(Svg& svg, const PlotSpec& spec, const PlotArea& f) {
  svg.open("g", {{"class", "legend"}, {"stroke-width", number(line_width)}});
  double y = f.top + 0.6 * font;
  for (std::size_t i = 0; i < spec.series.size(); ++i) {
    if (spec.series[i].name.empty()) {
      continue;
    }
    const Style& style = styles[i % styles.size()];
    const double x = f.right + font;
    svg.line(
        {x, y}, {x + sample_px, y},
        {{"stroke", std::string(style.colour)}, {"stroke-dasharray", std::string(style.dashes)}});
    svg.text({x + sample_px + 0.5 * font, y + 0.35 * font}, spec.series[i].name);
    y += 1.6 * font;
  }
  svg.close();
}

}  // namespace

std::string line_plot(const PlotSpec& spec) {
  check(spec);
  PlotArea f;
  set_ranges(spec, f);
  f.top = font * (spec.title.empty() ? 1 : 2.8);
  f.bottom = spec.height - 4 * font;
  const Ticks yt = ticks_of(spec.y, f.y, std::max(2, static_cast<int>((f.bottom - f.top) / 40)));
  f.left = widest(yt.labels) + 8 + 2.2 * font;
  f.right = spec.width - std::max(legend_width(spec), 1.5 * font);
  const Ticks xt = x_ticks(spec.x, f.x, f.right - f.left);

  Svg svg(spec.width, spec.height, font);
  draw_axes(svg, spec, f, xt, yt);
  draw_curves(svg, spec, f);
  draw_legend(svg, spec, f);
  if (!spec.title.empty()) {
    svg.text({(f.left + f.right) / 2, 1.7 * font}, spec.title,
             {{"text-anchor", "middle"}, {"font-size", number(1.15 * font)}});
  }
  return std::move(svg).finish();
}

}  // namespace ucvt
