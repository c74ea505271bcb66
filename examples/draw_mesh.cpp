// Draws triangle meshes as an SVG picture, side by side and to the same scale.
//
//   example_draw_mesh IN... OUT.svg [--azimuth A] [--elevation E]
//
// Orthographic view from the direction at azimuth A (degrees from the x axis, counterclockwise) and
// elevation E above the xy plane; z is up. Painter's algorithm: faces that look away are dropped, the
// others are painted from far to near. Every face has one shade, between a cold one where it turns
// from the light and a warm one where it faces it. `rsvg-convert OUT.svg -o OUT.png` makes pixels.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "ucvt/mesh.h"

namespace {

using Vector = ucvt::Position;
using Colour = std::array<double, 3>;

constexpr double panel_width = 720, margin = 24;          ///< pixels
constexpr Vector light{-0.60, 0.60, 0.45};                ///< right, up, towards the viewer
constexpr Colour cold{30, 70, 120}, warm{255, 240, 205};  ///< red, green, blue
constexpr const char* edge_style = "stroke=\"#16243a\" stroke-width=\"0.6\"";

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector normal(const Vector& a, const Vector& b, const Vector& c) {
  const Vector u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A mesh in the viewer's coordinates: right, up, towards the viewer.
std::vector<Vector> seen_from(const std::vector<Vector>& points, double azimuth, double elevation) {
  const double ca = std::cos(azimuth), sa = std::sin(azimuth);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  const Vector right{-sa, ca, 0}, up{-se * ca, -se * sa, ce}, towards{ce * ca, ce * sa, se};
  std::vector<Vector> out;
  out.reserve(points.size());
  for (const Vector& p : points) {
    out.push_back({dot(p, right), dot(p, up), dot(p, towards)});
  }
  return out;
}

struct Panel {
  std::vector<Vector> points;
  std::vector<ucvt::Corners> faces;
  Vector low{}, high{};
};

Panel make_panel(const ucvt::TriangleMesh& mesh, double azimuth, double elevation) {
  Panel out{seen_from(mesh.positions, azimuth, elevation), mesh.faces, {}, {}};
  out.low.fill(std::numeric_limits<double>::infinity());
  out.high.fill(-std::numeric_limits<double>::infinity());
  for (const Vector& p : out.points) {
    for (std::size_t i = 0; i < 3; ++i) {
      out.low[i] = std::min(out.low[i], p[i]);
      out.high[i] = std::max(out.high[i], p[i]);
    }
  }
  return out;
}

Colour shade(const Vector& n) {
  const double facing = dot(n, light) / std::sqrt(dot(n, n) * dot(light, light));
  const double t = std::pow((1 + facing) / 2, 2);
  Colour out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = std::round(cold[i] + t * (warm[i] - cold[i]));
  }
  return out;
}

/// Writes one panel whose lower left corner lies at (left, bottom), in pixels.
void draw(std::ostream& svg, const Panel& panel, double left, double bottom, double scale) {
  struct Visible {
    double depth;
    std::array<Vector, 3> corner;
    Colour colour;
  };
  std::vector<Visible> visible;
  for (const ucvt::Corners& f : panel.faces) {
    std::array<Vector, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = panel.points[static_cast<std::size_t>(f[i])];
    }
    const Vector n = normal(corner[0], corner[1], corner[2]);
    if (n[2] > 0) {
      visible.push_back({corner[0][2] + corner[1][2] + corner[2][2], corner, shade(n)});
    }
  }
  std::stable_sort(visible.begin(), visible.end(),
                   [](const Visible& a, const Visible& b) { return a.depth < b.depth; });
  svg << "<g " << edge_style << " stroke-linejoin=\"round\">\n";
  for (const Visible& face : visible) {
    svg << "<path d=\"";
    for (std::size_t i = 0; i < 3; ++i) {
      svg << (i == 0 ? 'M' : 'L') << left + scale * (face.corner[i][0] - panel.low[0]) << ' '
          << bottom - scale * (face.corner[i][1] - panel.low[1]);
    }
    svg << "Z\" fill=\"rgb(" << std::setprecision(0) << face.colour[0] << ',' << face.colour[1]
        << ',' << face.colour[2] << ")\"/>\n"
        << std::setprecision(2);
  }
  svg << "</g>\n";
}

void write_svg(const std::string& path, const std::vector<Panel>& panels) {
  double wide = 0, high = 0;
  for (const Panel& p : panels) {
    wide = std::max(wide, p.high[0] - p.low[0]);
    high = std::max(high, p.high[1] - p.low[1]);
  }
  const double scale = (panel_width - 2 * margin) / wide;
  const double width = panel_width * static_cast<double>(panels.size());
  const double height = std::ceil(scale * high + 2 * margin);
  std::ofstream svg(path);
  svg << std::fixed << std::setprecision(2);
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height << "\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (std::size_t i = 0; i < panels.size(); ++i) {
    draw(svg, panels[i], panel_width * static_cast<double>(i) + margin, height - margin, scale);
  }
  svg << "</svg>\n";
  svg.close();
  if (!svg) {
    throw std::runtime_error("cannot write " + path);
  }
}

struct Options {
  std::vector<std::string> paths;  ///< meshes, then the picture
  double azimuth = -90, elevation = 40;
};

double parse_angle(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw std::invalid_argument("'" + text + "' is not an angle in degrees");
  }
  return value;
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool has_value = i + 1 < arguments.size();
    if (arguments[i] == "--azimuth" && has_value) {
      options.azimuth = parse_angle(arguments[++i]);
    } else if (arguments[i] == "--elevation" && has_value) {
      options.elevation = parse_angle(arguments[++i]);
    } else if (!arguments[i].starts_with("--")) {
      options.paths.push_back(arguments[i]);
    } else {
      throw std::invalid_argument("unexpected argument '" + arguments[i] + "'");
    }
  }
  if (options.paths.size() < 2) {
    throw std::invalid_argument(
        "usage: example_draw_mesh IN... OUT.svg [--azimuth A] [--elevation E]");
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    const double radians = std::numbers::pi / 180;
    std::vector<Panel> panels;
    for (std::size_t i = 0; i + 1 < options.paths.size(); ++i) {
      panels.push_back(make_panel(ucvt::read_mesh(options.paths[i]), options.azimuth * radians,
                                  options.elevation * radians));
    }
    write_svg(options.paths.back(), panels);
  } catch (const std::invalid_argument& error) {
    std::cerr << "example_draw_mesh: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "example_draw_mesh: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
