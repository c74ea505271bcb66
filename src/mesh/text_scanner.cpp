#include "mesh/text_scanner.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

#include "mesh/invalid.h"

namespace ucvt {
namespace {

bool is_word_character(char c) {
  return static_cast<unsigned char>(c) > ' ' && c != '\x7f';
}

// from_chars does not tell a number too small from one too large.
double out_of_range_value(std::string_view word) {
  const double value = std::strtod(std::string(word).c_str(), nullptr);
  if (value > 1) {
    return std::numeric_limits<double>::infinity();
  }
  if (value < -1) {
    return -std::numeric_limits<double>::infinity();
  }
  return value;
}

// "3.1+e2": some exporters put the exponent's sign before its letter.
bool parse_swapped_exponent(std::string_view word, std::size_t rest, double& value) {
  if (rest + 2 >= word.size() || (word[rest] != '+' && word[rest] != '-')) {
    return false;
  }
  if (word[rest + 1] != 'e' && word[rest + 1] != 'E') {
    return false;
  }
  std::string straight(word);
  std::swap(straight[rest], straight[rest + 1]);
  const char* end = straight.data() + straight.size();
  const auto [stop, error] = std::from_chars(straight.data(), end, value);
  return error == std::errc() && stop == end;
}

}  // namespace

std::string in_quotes(std::string_view piece) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : piece.substr(0, longest)) {
    text += c >= ' ' && c < '\x7f' ? c : '?';
  }
  if (piece.size() > longest) {
    text += "...";
  }
  return text + "'";
}

std::string counted(long long count, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

void TextScanner::pass_line_end() {
  if (text_[position_] == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n') {
    ++position_;
  }
  ++position_;
  ++line_;
}

bool TextScanner::pass_continuation() {
  if (!options_.continued_lines || text_[position_] != '\\') {
    return false;
  }
  std::size_t after = position_ + 1;
  while (after < text_.size() && (text_[after] == ' ' || text_[after] == '\t')) {
    ++after;
  }
  if (after < text_.size() && text_[after] != '\n' && text_[after] != '\r') {
    return false;
  }
  position_ = after;
  if (!at_end()) {
    pass_line_end();
  }
  return true;
}

void TextScanner::skip_blanks_in_line() {
  while (!at_end() && !at_line_end()) {
    if (options_.hash_comments && text_[position_] == '#') {
      while (!at_end() && !at_line_end()) {
        ++position_;
      }
    } else if (!is_word_character(text_[position_])) {
      ++position_;
    } else if (!pass_continuation()) {
      return;
    }
  }
}

std::string_view TextScanner::word_in_line() {
  skip_blanks_in_line();
  const std::size_t begin = position_;
  while (!at_end() && is_word_character(text_[position_])) {
    if (text_[position_] == '#' && options_.hash_comments) {
      break;
    }
    if (text_[position_] == '\\' && options_.continued_lines) {
      // A word may touch the backslash that continues its line; it ends there.
      const std::size_t end = position_;
      const std::int64_t line = line_;
      if (pass_continuation()) {
        position_ = end;
        line_ = line;
        break;
      }
    }
    ++position_;
  }
  return text_.substr(begin, position_ - begin);
}

std::string_view TextScanner::word() {
  while (true) {
    const std::string_view found = word_in_line();
    if (!found.empty() || at_end()) {
      return found;
    }
    pass_line_end();
  }
}

void TextScanner::skip_line() {
  while (!at_end()) {
    if (at_line_end()) {
      pass_line_end();
      return;
    }
    if (options_.hash_comments && text_[position_] == '#') {
      while (!at_end() && !at_line_end()) {
        ++position_;
      }
    } else if (!pass_continuation()) {
      ++position_;
    }
  }
}

void TextScanner::put_back(std::string_view rest_of_word) {
  position_ = static_cast<std::size_t>(rest_of_word.data() - text_.data());
}

bool parse_real(std::string_view word, double& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  const char* end = word.data() + word.size();
  // NOLINTNEXTLINE(bugprone-suspicious-stringview-data-usage): from_chars takes the end too
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop == end && error == std::errc()) {
    return true;
  }
  if (stop == end && error == std::errc::result_out_of_range) {
    value = out_of_range_value(word);
    return true;
  }
  if (error != std::errc()) {
    return false;
  }
  return parse_swapped_exponent(word, static_cast<std::size_t>(stop - word.data()), value);
}

bool parse_integer(std::string_view word, std::int64_t& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  const char* end = word.data() + word.size();
  // NOLINTNEXTLINE(bugprone-suspicious-stringview-data-usage): from_chars takes the end too
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop == end && error == std::errc::result_out_of_range) {
    value = word[0] == '-' ? std::numeric_limits<std::int64_t>::min()
                           : std::numeric_limits<std::int64_t>::max();
    return true;
  }
  return stop == end && error == std::errc();
}

}  // namespace ucvt
