// What a computation tells while it runs, on stderr.
//
// On a terminal one line is rewritten and wiped in the end; with --verbose every iteration gets a
// line of its own, wherever stderr goes. This is also where an interruption reaches the library.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "app/options.h"
#include "app/supervisor.h"
#include "ucvt/uniformize.h"

namespace ucvt {

class ProgressLine {
 public:
  /// Keeps a reference to the supervisor.
  ProgressLine(const SharedArguments& shared, const Supervisor& supervisor);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;

  /// To be given to the library; must not outlive this object.
  [[nodiscard]] Monitor monitor();

  /// Wipes the line.
  void clear();

 private:
  bool tell(const Progress& progress);
  void rewrite(const std::string& text);

  const Supervisor& supervisor_;
  bool verbose_;
  bool terminal_;
  std::size_t shown_ = 0;  ///< characters on the line
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ucvt
