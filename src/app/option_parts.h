// What the commands' options have in common: numbers, flags, and checks of the outputs asked for.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/options.h"

namespace ucvt {

extern const char* const version_line;

/// A number written in decimal; CLI11 would read 010 as eight.
template <typename Number>
bool parse_decimal(std::string_view text, Number& value) {
  const char* const first = text.data();  // NOLINT(bugprone-suspicious-stringview-data-usage)
  const char* const end = first + text.size();
  const auto [stop, error] = std::from_chars(first, end, value);
  return error == std::errc() && stop == end;
}

/// Adds an option that takes a number for which `accepts` holds.
template <typename Number, typename Accepts>
CLI::Option* add_number(CLI::App& app, const std::string& name, Number& target,
                        const Accepts& accepts, const std::string& wanted,
                        const std::string& description) {
  const auto read = [name, &target, accepts, wanted](const CLI::results_t& values) {
    const std::string& text = values.at(0);
    Number value = 0;
    if (!parse_decimal(text, value) || !accepts(value)) {
      throw CLI::ValidationError(name, fmt::format("'{}' is not {}", text, wanted));
    }
    target = value;
    return true;
  };
  return app.add_option(name, read, description);
}

/// Adds an option that takes one of a few words.
template <typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& target,
                        const std::vector<std::pair<std::string, Value>>& choices,
                        const std::string& description) {
  std::string words;
  for (const auto& choice : choices) {
    words += (words.empty() ? "" : "|") + choice.first;
  }
  const auto read = [name, &target, choices, words](const std::string& text) {
    for (const auto& [word, value] : choices) {
      if (word == text) {
        target = value;
        return;
      }
    }
    throw CLI::ValidationError(name, fmt::format("'{}' is none of {}", text, words));
  };
  return app.add_option_function<std::string>(name, read, description)->type_name(words);
}

/// --report, --quiet, --verbose, --version, --time-limit, --memory-limit.
void add_shared(CLI::App& app, SharedArguments& shared);
/// An option that takes a time.
void add_seconds(CLI::App& app, const std::string& name, double& seconds,
                 const std::string& description);
void add_threads(CLI::App& app, int& threads);
void add_seed(CLI::App& app, std::uint64_t& seed);
void add_method(CLI::App& app, Method& method);
CLI::Option* add_sites(CLI::App& app, int& sites);

struct StopFlags {
  CLI::Option* iterations = nullptr;
  CLI::Option* tolerance = nullptr;

  /// A tolerance was given and no number of iterations.
  [[nodiscard]] bool ask_for_convergence() const;
};
StopFlags add_stop(CLI::App& app, int& iterations, double& tolerance);

/// Throws Failure (ExitStatus::Usage) that ends in the hint at the command's --help.
[[noreturn]] void fail_usage(const std::string& message, const std::string& command);

/// The paths that are not empty.
std::vector<std::string> asked_for(std::vector<std::string> paths);

/// One output at most goes to standard output or to a file. Throws Failure.
void check_outputs(const std::vector<std::string>& outputs, const std::string& command);

/// A path that is given, unless "-", must have one of the extensions. Throws Failure.
void check_extension(const std::string& option, const std::string& path,
                     const std::vector<std::string>& known, const std::string& command);

}  // namespace ucvt
