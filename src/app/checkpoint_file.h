// The file of --checkpoint: the state of a run, written now and then while it goes on.
//
// The library hands over the state at every restart point; it is kept, and written when long enough has
// passed or the run is ended before its time. The file is always a whole one.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "app/options.h"
#include "ucvt/remesh.h"

namespace ucvt {

class CheckpointFile {
 public:
  explicit CheckpointFile(const CheckpointArguments& arguments);

  /// For RemeshOptions; must not outlive this object. Empty where no checkpoint is asked for.
  [[nodiscard]] Checkpoint writer();

  /// Writes the last state, unless the file holds it. From any thread.
  void save();

  /// Whether the file holds a state of this run.
  [[nodiscard]] bool written() const;

  [[nodiscard]] const std::string& path() const { return arguments_.path; }

 private:
  void offer(const SavedSites& state);
  /// A file that cannot be written is told and tried again at the next restart point: the run goes on.
  void write();

  CheckpointArguments arguments_;
  mutable std::mutex mutex_;
  std::optional<SavedSites> unwritten_;
  bool written_ = false;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace ucvt
