#include "app/checkpoint_file.h"

#include "app/failure.h"
#include "ucvt/error.h"

namespace ucvt {

CheckpointFile::CheckpointFile(const CheckpointArguments& arguments)
    : arguments_(arguments), last_(std::chrono::steady_clock::now()) {}

Checkpoint CheckpointFile::writer() {
  if (arguments_.path.empty()) {
    return nullptr;
  }
  return [this](const SavedSites& state) { offer(state); };
}

void CheckpointFile::offer(const SavedSites& state) {
  const std::lock_guard lock(mutex_);
  unwritten_ = state;
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - last_;
  if (passed.count() >= arguments_.every_seconds) {
    write();
  }
}

void CheckpointFile::save() {
  const std::lock_guard lock(mutex_);
  write();
}

bool CheckpointFile::written() const {
  const std::lock_guard lock(mutex_);
  return written_;
}

void CheckpointFile::write() {
  if (!unwritten_) {
    return;
  }
  try {
    write_sites(arguments_.path, *unwritten_);
    unwritten_.reset();
    written_ = true;
  } catch (const IoError& error) {
    print_line_to_stderr(arguments_.path + ": " + error.what());
  }
  last_ = std::chrono::steady_clock::now();
}

}  // namespace ucvt
