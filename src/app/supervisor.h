// What may end a run before its time: SIGINT and SIGTERM, --time-limit, --memory-limit.
//
// A thread of its own watches. A computation that is asked to stop does so at its next safe point; one
// that does not reach one soon is ended from here, which is in order as long as no output is being
// written: a run either ends by one line and without outputs, or writes all of them.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "app/checkpoint_file.h"
#include "app/failure.h"
#include "app/options.h"
#include "ucvt/error.h"

namespace ucvt {

class Supervisor {
 public:
  /// Catches signals and starts to watch. Keeps a reference to the checkpoint, which may be null.
  explicit Supervisor(const LimitArguments& limits, CheckpointFile* checkpoint = nullptr);
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor(Supervisor&&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;
  Supervisor& operator=(Supervisor&&) = delete;

  /// For monitors: true when the computation is to stop.
  [[nodiscard]] bool stop_asked() const { return asked_.load(); }

  /// Runs a computation. Throws Failure when it was asked to stop, and saves the checkpoint when it
  /// could not finish.
  template <typename Work>
  auto watch(const Work& work) -> decltype(work()) {
    try {
      return work();
    } catch (const Cancelled&) {
      throw stopped();
    } catch (...) {
      save();
      throw;
    }
  }

  /// Outputs are written from here on, and nothing ends the run. Throws Failure when it was asked to
  /// stop before.
  void begin_outputs();

 private:
  void look_on();
  /// Whether something asks for the end of the run.
  [[nodiscard]] bool is_due() const;
  void save();
  /// What is said when the run ends before its time; saves the checkpoint.
  Failure stopped();
  void end_watch();

  LimitArguments limits_;
  CheckpointFile* checkpoint_;
  std::chrono::steady_clock::time_point start_;
  std::atomic<bool> asked_{false};
  std::mutex mutex_;
  std::condition_variable ended_changed_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace ucvt
