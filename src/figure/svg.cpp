#include "figure/svg.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

unsigned char byte_at(std::string_view s, std::size_t i) {
  return i < s.size() ? static_cast<unsigned char>(s[i]) : 0;
}

/// Bytes of the character at the start of `s` when it is good UTF-8 that XML may hold, else 0.
std::size_t character_bytes(std::string_view s) {
  const unsigned lead = byte_at(s, 0);
  if (lead < 0x80) {
    return lead >= 0x20 || lead == '\n' || lead == '\t' ? 1 : 0;
  }
  const std::size_t n = lead >= 0xC2 && lead < 0xE0   ? 2
                        : lead >= 0xE0 && lead < 0xF0 ? 3
                        : lead >= 0xF0 && lead < 0xF5 ? 4
                                                      : 0;
  unsigned code = n == 2 ? lead & 0x1FU : n == 3 ? lead & 0x0FU : lead & 0x07U;
  for (std::size_t i = 1; i < n; ++i) {
    if ((byte_at(s, i) & 0xC0U) != 0x80) {
      return 0;
    }
    code = code << 6U | (byte_at(s, i) & 0x3FU);
  }
  const bool overlong = (n == 3 && code < 0x800) || (n == 4 && code < 0x10000);
  const bool forbidden = (code >= 0xD800 && code < 0xE000) || code == 0xFFFE || code == 0xFFFF;
  return overlong || forbidden || code > 0x10FFFF ? 0 : n;
}

}  // namespace

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) {
    throw InvalidInput("a coordinate of the figure is not finite; check sites, cells and view");
  }
  std::string s = fmt::format("{:.{}f}", value, decimals);
  if (decimals > 0) {
    s.erase(s.find_last_not_of('0') + 1);
  }
  if (s.back() == '.') {
    s.pop_back();
  }
  return s == "-0" ? "0" : s;
}

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t n = character_bytes(text);
    const std::string_view c = text.substr(0, std::max<std::size_t>(n, 1));
    if (n == 0) {
      out += replacement;
    } else if (c == "&") {
      out += "&amp;";
    } else if (c == "<") {
      out += "&lt;";
    } else if (c == ">") {
      out += "&gt;";
    } else if (c == "\"") {
      out += "&quot;";
    } else {
      out += c;
    }
    text.remove_prefix(c.size());
  }
  return out;
}

Path& Path::step(char command, const Pixel& to) {
  data_ += command;
  data_ += number(to.x, decimals_) + ' ' + number(to.y, decimals_);
  return *this;
}

Path& Path::arc(double radius, bool clockwise, const Pixel& to) {
  const std::string r = number(radius, decimals_);
  data_ += fmt::format("A{0} {0} 0 0 {1} {2} {3}", r, clockwise ? 1 : 0, number(to.x, decimals_),
                       number(to.y, decimals_));
  return *this;
}

Path& Path::close() {
  data_ += 'Z';
  return *this;
}

Svg::Svg(double width, double height, double font_px) {
  const std::string w = number(width), h = number(height);
  out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
               {"version", "1.1"},
               {"width", w},
               {"height", h},
               {"viewBox", fmt::format("0 0 {} {}", w, h)},
               {"font-family", "Helvetica, Arial, 'DejaVu Sans', sans-serif"},
               {"font-size", number(font_px)}});
  element("rect", {{"width", w}, {"height", h}, {"fill", "#ffffff"}});
}

void Svg::tag(std::string_view element, Attributes attributes) {
  out_ += '<';
  out_ += element;
  for (const Attribute& a : attributes) {
    out_ += fmt::format(" {}=\"{}\"", a.name, escaped(a.value));
  }
}

void Svg::open(std::string_view element, Attributes attributes) {
  tag(element, attributes);
  out_ += ">\n";
  open_.emplace_back(element);
}

void Svg::close() {
  out_ += fmt::format("</{}>\n", open_.back());
  open_.pop_back();
}

void Svg::element(std::string_view element, Attributes attributes) {
  tag(element, attributes);
  out_ += "/>\n";
}

void Svg::text(const Pixel& at, std::string_view content, Attributes attributes) {
  tag("text", attributes);
  out_ +=
      fmt::format(" x=\"{}\" y=\"{}\">{}</text>\n", number(at.x), number(at.y), escaped(content));
}

void Svg::symbol(const Pixel& at, std::string_view letter, std::string_view below,
                 std::string_view above, double font_px) {
  const double small = 0.66 * font_px, down = 0.22 * font_px, up = 0.62 * font_px;
  const auto span = [&](std::string_view text, double dx, double dy) {
    tag("tspan", {{"dx", number(dx)}, {"dy", number(dy)}, {"font-size", number(small)}});
    out_ += '>';
    out_ += escaped(text);
    out_ += "</tspan>";
  };
  tag("text", {{"font-size", number(font_px)},
               {"font-family", "'Latin Modern Roman', 'Times New Roman', 'DejaVu Serif', serif"},
               {"text-anchor", "middle"},
               {"stroke", "#ffffff"},
               {"stroke-width", number(0.2 * font_px)},
               {"stroke-linejoin", "round"},
               {"paint-order", "stroke"},
               {"x", number(at.x)},
               {"y", number(at.y + 0.32 * font_px)}});
  out_ += '>';
  tag("tspan", {{"font-style", "italic"}});
  out_ += '>';
  out_ += escaped(letter);
  out_ += "</tspan>";
  span(below, 0, down);
  if (!above.empty()) {
    // The exponent stands above the index.
    span(above, -0.55 * small * static_cast<double>(below.size()), -down - up + down / 2);
  }
  out_ += "</text>\n";
}

void Svg::circle(const Pixel& centre, double radius, Attributes attributes) {
  tag("circle", attributes);
  out_ += fmt::format(" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", number(centre.x), number(centre.y),
                      number(radius));
}

void Svg::line(const Pixel& from, const Pixel& to, Attributes attributes) {
  tag("line", attributes);
  out_ += fmt::format(" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", number(from.x),
                      number(from.y), number(to.x), number(to.y));
}

std::string Svg::finish() && {
  close();
  return std::move(out_);
}

double text_width(std::string_view text, double font_px) {
  double em = 0;
  for (const char c : text) {
    const bool continuation = (static_cast<unsigned char>(c) & 0xC0U) == 0x80;
    const bool narrow = std::string_view(" .,:;()[]|'ijlft").find(c) != std::string_view::npos;
    const bool wide = (c >= 'A' && c <= 'Z') || c == 'm' || c == 'w';
    em += continuation ? 0 : narrow ? 0.38 : wide ? 0.85 : 0.63;
  }
  return em * font_px;
}

}  // namespace ucvt
