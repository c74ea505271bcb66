// Words of a text held in memory, with their line numbers.
//
// Lines end with LF, CR or CRLF; words are parted by blanks and control characters; `#` begins a
// comment that ends with the line, where the options say so; a backslash at the end of a line joins
// the next one to it, where the options say so. Step: reading text meshes.
#pragma once

#include <cstdint>
#include <string_view>

namespace ucvt {

struct TextScannerOptions {
  bool hash_comments = true;
  bool continued_lines = false;
};

/// Walks once over a text. The text must outlive the scanner and the words it gives.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text, TextScannerOptions options = {})
      : text_(text), options_(options) {}

  /// The next word, on this line or a later one; empty at the end of the text.
  std::string_view word();

  /// The next word of this line; empty at the end of the line, which is not passed.
  std::string_view word_in_line();

  /// Passes the end of this line, and the lines that it is continued on.
  void skip_line();

  /// Puts the scanner back before the given rest of the last word that it gave.
  void put_back(std::string_view rest_of_word);

  [[nodiscard]] bool at_end() const { return position_ >= text_.size(); }
  /// The line, from 1, that the scanner stands on: that of the word given last.
  [[nodiscard]] std::int64_t line() const { return line_; }
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - position_; }

 private:
  [[nodiscard]] bool at_line_end() const {
    return text_[position_] == '\n' || text_[position_] == '\r';
  }
  bool pass_continuation();
  void skip_blanks_in_line();
  void pass_line_end();

  std::string_view text_;
  TextScannerOptions options_;
  std::size_t position_ = 0;
  std::int64_t line_ = 1;
};

/// Reads the whole word as a decimal number, with an optional sign; `nan` and `inf` give those.
/// Too small a number gives 0; too large a one infinity. False when the word is something else.
bool parse_real(std::string_view word, double& value);

/// Reads the whole word as a decimal integer, with an optional sign; false when it is none.
bool parse_integer(std::string_view word, std::int64_t& value);

}  // namespace ucvt
