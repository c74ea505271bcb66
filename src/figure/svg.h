// A small writer of SVG documents: elements, groups, text, path data.
//
// Coordinates are pixels, x to the right and y down, with three decimals. The same calls give the
// same bytes everywhere.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace ucvt {

struct Pixel {
  double x = 0, y = 0;
};

/// A number with at most so many decimals, without trailing zeros or a negative zero.
/// Throws InvalidInput when it is not finite.
std::string number(double value, int decimals = 3);

/// Text fit for XML: markup escaped; what XML or UTF-8 cannot hold replaced by U+FFFD.
std::string escaped(std::string_view text);

/// Path data of a `path` element.
class Path {
 public:
  /// Coordinates are written with so many decimals, up to three.
  explicit Path(int decimals = 3) : decimals_(decimals) {}
  Path& move(const Pixel& to) { return step('M', to); }
  Path& line(const Pixel& to) { return step('L', to); }
  /// The shorter arc of a circle; clockwise as seen on the screen.
  Path& arc(double radius, bool clockwise, const Pixel& to);
  Path& close();

  [[nodiscard]] bool empty() const { return data_.empty(); }
  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  Path& step(char command, const Pixel& to);

  int decimals_;
  std::string data_;
};

struct Attribute {
  std::string_view name;
  std::string value;
};
using Attributes = std::initializer_list<Attribute>;

/// A document under construction; black sans-serif text on white.
class Svg {
 public:
  Svg(double width, double height, double font_px);

  void open(std::string_view element, Attributes attributes);
  void close();
  void element(std::string_view element, Attributes attributes);
  void text(const Pixel& at, std::string_view content, Attributes attributes = {});
  /// An italic letter with an index below and, not empty, an exponent above; black with a white rim.
  void symbol(const Pixel& at, std::string_view letter, std::string_view below,
              std::string_view above, double font_px);
  void circle(const Pixel& centre, double radius, Attributes attributes = {});
  void line(const Pixel& from, const Pixel& to, Attributes attributes = {});

  /// The whole document. Requires every group closed.
  [[nodiscard]] std::string finish() &&;

 private:
  void tag(std::string_view element, Attributes attributes);

  std::string out_;
  std::vector<std::string> open_;
};

/// About how wide a text is set in the document's font, a little more rather than less.
double text_width(std::string_view text, double font_px);

}  // namespace ucvt
