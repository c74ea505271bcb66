#include "mesh/output_file.h"

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ucvt/error.h"

namespace ucvt {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;
constexpr mode_t read_write_all = 0666;  // less the umask
constexpr mode_t permissions = 07777;

// Keeps a write to a closed pipe from killing the process, so that it is an error like others.
class PipeSignalBlock {
 public:
  PipeSignalBlock() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigemptyset(&pending);
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~PipeSignalBlock() {
    const timespec now = {0, 0};
    if (!was_pending_) {
      while (sigtimedwait(&pipe_, nullptr, &now) < 0 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  PipeSignalBlock(const PipeSignalBlock&) = delete;
  PipeSignalBlock& operator=(const PipeSignalBlock&) = delete;

 private:
  sigset_t pipe_ = {}, before_ = {};
  bool was_pending_ = false;
};

int write_all(int descriptor, std::string_view bytes) {
  const PipeSignalBlock block;
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) {
      continue;
    }
    if (done < 0) {
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
  return 0;
}

// A link keeps pointing at the file that is written.
std::string resolved(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(path, error)) {
    return path;
  }
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error || target.empty() ? path : target.string();
}

bool is_stream_path(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/stderr" || path.starts_with("/dev/fd/") ||
         path.starts_with("/proc/");
}

}  // namespace

void OutputFile::fail(const char* what, int error) const {
  throw IoError(fmt::format("cannot {}: {}; check the path, its permissions and the disk", what,
                            std::generic_category().message(error)));
}

OutputFile::OutputFile(const std::string& path) {
  if (path == "-") {
    direct_ = true;
    descriptor_ = STDOUT_FILENO;
    return;
  }
  struct stat status = {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    fail("write the file", EISDIR);
  }
  if (is_stream_path(path) || (exists && !S_ISREG(status.st_mode))) {
    open_direct(path);
    return;
  }
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    fail("write the file", errno);
  }
  open_temporary(path);
  if (exists && ::fchmod(descriptor_, status.st_mode & permissions) != 0) {
    const int error = errno;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
    fail("write the file", error);
  }
}

void OutputFile::open_direct(const std::string& path) {
  direct_ = true;
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_NOCTTY, read_write_all);
  if (descriptor_ < 0) {
    fail("open the file", errno);
  }
}

void OutputFile::open_temporary(const std::string& path) {
  static std::atomic<unsigned> counter{0};
  target_ = resolved(path);
  int error = EEXIST;
  while (descriptor_ < 0 && error == EEXIST) {
    temporary_ = fmt::format("{}.{}-{}.part", target_, ::getpid(), counter++);
    descriptor_ =
        ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, read_write_all);
    error = errno;
  }
  if (descriptor_ < 0) {
    fail("create the file", error);
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ > STDERR_FILENO) {
    ::close(descriptor_);
  }
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
  }
}

void OutputFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (!direct_ && buffer_.size() >= buffer_size) {
    flush();
  }
}

void OutputFile::flush() {
  if (const int error = write_all(descriptor_, buffer_); error != 0) {
    fail("write the file", error);
  }
  buffer_.clear();
}

void OutputFile::commit() {
  flush();
  if (descriptor_ == STDOUT_FILENO) {
    return;
  }
  if (!direct_ && ::fsync(descriptor_) != 0) {
    fail("write the file to the disk", errno);
  }
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) {
    fail("close the file", errno);
  }
  if (direct_) {
    return;
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail("rename the file", errno);
  }
  temporary_.clear();
}

}  // namespace ucvt
