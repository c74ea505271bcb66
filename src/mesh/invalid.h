// How the mesh room says that an input is not acceptable: one fmt line thrown as InvalidInput.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "ucvt/error.h"

namespace ucvt {

/// Throws InvalidInput with the formatted line.
template <typename... Args>
[[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) {
  throw InvalidInput(fmt::format(format, std::forward<Args>(args)...));
}

/// A piece of the input fit for a one-line message: at most 40 characters, printable, in quotes.
std::string in_quotes(std::string_view piece);

/// "1 face", "2 faces".
std::string counted(long long count, std::string_view singular, std::string_view plural);

}  // namespace ucvt
