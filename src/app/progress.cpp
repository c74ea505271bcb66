#include "app/progress.h"

#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

namespace ucvt {
namespace {

constexpr std::chrono::milliseconds between_rewrites{100};

std::string described(const Progress& progress) {
  const bool uniformizing = std::string_view(progress.stage) == "uniformize";
  return fmt::format("{:<10}  iteration {:>4}  {} {:.2e}", progress.stage, progress.iteration,
                     uniformizing ? "angle error (rad)" : "largest move", progress.residual);
}

}  // namespace

ProgressLine::ProgressLine(const SharedArguments& shared, const Supervisor& supervisor)
    : supervisor_(supervisor),
      verbose_(shared.verbose),
      terminal_(!shared.quiet && !shared.verbose && ::isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now()) {}

ProgressLine::~ProgressLine() {
  clear();
}

Monitor ProgressLine::monitor() {
  return [this](const Progress& progress) { return tell(progress); };
}

bool ProgressLine::tell(const Progress& progress) {
  if (supervisor_.stop_asked()) {
    return false;  // the last line is the supervisor's
  }
  if (verbose_) {
    const std::string line = described(progress) + "\n";
    std::fwrite(line.data(), 1, line.size(), stderr);
  } else if (const auto now = std::chrono::steady_clock::now(); terminal_ && now >= next_) {
    next_ = now + between_rewrites;
    rewrite(described(progress));
  }
  return true;
}

void ProgressLine::rewrite(const std::string& text) {
  const std::string line = fmt::format("\r{:<{}}\r{}", "", shown_, text);
  std::fwrite(line.data(), 1, line.size(), stderr);
  shown_ = text.size();
}

void ProgressLine::clear() {
  if (shown_ > 0) {
    rewrite("");
  }
}

}  // namespace ucvt
