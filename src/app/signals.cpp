#include "app/signals.h"

#include <atomic>
#include <string_view>

#include <signal.h>
#include <unistd.h>

namespace ucvt {
namespace {

struct SignalState {
  std::atomic<bool> computing{false};
  std::atomic<bool> interrupted{false};
};
// Any thread may be the one that the handler runs on, so that volatile sig_atomic_t is not enough.
static_assert(std::atomic<bool>::is_always_lock_free, "needed in a signal handler");

SignalState& state() {
  static constinit SignalState the_state;
  return the_state;
}

extern "C" void note_signal(int /*signal*/) {
  if (state().computing.load()) {
    state().interrupted.store(true);
    return;
  }
  constexpr std::string_view line = "ucvt: interrupted; no output was written\n";
  [[maybe_unused]] const ssize_t done = ::write(STDERR_FILENO, line.data(), line.size());
  ::_exit(1);
}

void catch_signal(int signal) {
  struct sigaction before = {};
  if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) {
    return;
  }
  struct sigaction action = {};
  action.sa_handler = note_signal;
  // Reset: the second signal has its default action.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_signals() {
  catch_signal(SIGINT);
  catch_signal(SIGTERM);
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  ::sigemptyset(&ignore.sa_mask);
  ::sigaction(SIGPIPE, &ignore, nullptr);
  ::sigaction(SIGXFSZ, &ignore, nullptr);
}

void begin_computation() {
  state().computing.store(true);
}

bool interrupted() {
  return state().interrupted.load();
}

}  // namespace ucvt
