#include "app/supervisor.h"

#include <new>
#include <system_error>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "app/signals.h"

namespace ucvt {
namespace {

/// Between two looks; and how long a computation has to stop by itself.
constexpr std::chrono::milliseconds between_looks{20};
constexpr std::chrono::milliseconds grace{300};

constexpr rlim_t bytes_per_megabyte = 1'000'000;

void limit_memory(std::int64_t megabytes) {
  const rlim_t bytes = static_cast<rlim_t>(megabytes) * bytes_per_megabyte;
  struct rlimit limit = {};
  if (::getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur > bytes) {
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_DATA, &limit);
  }
}

}  // namespace

Supervisor::Supervisor(const LimitArguments& limits, CheckpointFile* checkpoint)
    : limits_(limits), checkpoint_(checkpoint), start_(std::chrono::steady_clock::now()) {
  if (limits.megabytes > 0) {
    limit_memory(limits.megabytes);
  }
  catch_signals();
  try {
    thread_ = std::thread([this] { look_on(); });
  } catch (const std::system_error&) {
    throw std::bad_alloc();  // there is no room for a thread
  }
}

Supervisor::~Supervisor() {
  end_watch();
}

void Supervisor::end_watch() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ended_changed_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

bool Supervisor::is_due() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  return interrupted() || (limits_.seconds > 0 && passed.count() >= limits_.seconds);
}

void Supervisor::look_on() {
  std::unique_lock lock(mutex_);
  const auto ended = [this] { return ended_; };
  while (!is_due()) {
    if (ended_changed_.wait_for(lock, between_looks, ended)) {
      return;
    }
  }
  asked_.store(true);
  if (ended_changed_.wait_for(lock, grace, ended)) {
    return;
  }
  // The lock is held: the run cannot begin with its outputs meanwhile.
  print_line_to_stderr(stopped().what());
  ::_exit(static_cast<int>(ExitStatus::NotFinished));
}

void Supervisor::save() {
  if (checkpoint_ != nullptr) {
    checkpoint_->save();
  }
}

Failure Supervisor::stopped() {
  std::string line = interrupted()
                         ? "interrupted"
                         : fmt::format("stopped after {} seconds as asked for", limits_.seconds);
  line += "; no output was written";
  save();
  if (checkpoint_ != nullptr && checkpoint_->written()) {
    line += fmt::format("; go on with --init {}", checkpoint_->path());
  }
  return {ExitStatus::NotFinished, line};
}

void Supervisor::begin_outputs() {
  end_watch();
  if (asked_.load() || interrupted()) {
    throw stopped();
  }
}

}  // namespace ucvt
