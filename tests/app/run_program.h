// Runs the ucvt command as a user would and catches what it says.
//
// Standard streams are files in a folder of their own, so that nothing can block; a program that
// hangs is ended by its alarm. Signals have their default actions, whatever the tests inherited.
#pragma once

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mesh/mesh_test_support.h"

namespace ucvt::test {

struct Outcome {
  int status = -1;  ///< of the exit; 128 + signal when one ended the program
  std::string out, err;
};

/// Where the standard output goes.
enum class Stdout { file, closed, full_disk, broken_pipe };

inline std::string only_line(const std::string& err) {
  EXPECT_FALSE(err.empty());
  EXPECT_EQ(err.find('\n'), err.size() - 1) << "not exactly one line: " << err;
  EXPECT_EQ(err.rfind("ucvt: ", 0), 0U) << err;
  return err;
}

class Program {
 public:
  explicit Program(std::vector<std::string> arguments, const std::string& input = "",
                   Stdout out = Stdout::file) {
    folder_.write("in", input);
    arguments.insert(arguments.begin(), UCVT_CLI);
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ < 0) {
      throw std::runtime_error("cannot fork");
    }
    if (pid_ == 0) {
      become(argv, out);
    }
  }
  ~Program() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) const { ::kill(pid_, signal); }

  /// Waits until the program has said this on stderr; false when it ended before.
  bool says(const std::string& text) const {
    while (slurp(folder_.file("err")).find(text) == std::string::npos) {
      siginfo_t info = {};
      ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
      if (info.si_pid != 0) {
        return false;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }

  Outcome wait() {
    int status = 0;
    ::waitpid(pid_, &status, 0);
    pid_ = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            slurp(folder_.file("out")), slurp(folder_.file("err"))};
  }

 private:
  [[noreturn]] void become(const std::vector<char*>& argv, Stdout out) const {
    constexpr unsigned longest_run_seconds = 300;
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) {
      ::signal(signal, SIG_DFL);
    }
    constexpr int write_new = O_WRONLY | O_CREAT | O_TRUNC;
    redirect(::open(folder_.file("in").c_str(), O_RDONLY), STDIN_FILENO);
    redirect(::open(folder_.file("err").c_str(), write_new, 0600), STDERR_FILENO);
    if (out == Stdout::file) {
      redirect(::open(folder_.file("out").c_str(), write_new, 0600), STDOUT_FILENO);
    } else if (out == Stdout::full_disk) {
      redirect(::open("/dev/full", O_WRONLY), STDOUT_FILENO);
    } else if (out == Stdout::closed) {
      ::close(STDOUT_FILENO);
    } else {
      int ends[2] = {};
      if (::pipe(ends) != 0) {
        ::_exit(126);
      }
      ::close(ends[0]);
      redirect(ends[1], STDOUT_FILENO);
    }
    ::alarm(longest_run_seconds);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  static void redirect(int from, int to) {
    if (::dup2(from, to) < 0) {
      ::_exit(126);
    }
    ::close(from);
  }

  TemporaryFolder folder_;
  pid_t pid_ = 0;
};

inline Outcome run(std::vector<std::string> arguments, const std::string& input = "",
                   Stdout out = Stdout::file) {
  return Program(std::move(arguments), input, out).wait();
}

inline nlohmann::json read_json(const std::string& path) {
  return nlohmann::json::parse(slurp(path));
}

/// A torus of 240 vertices as a file in the folder.
inline std::string torus_file(const TemporaryFolder& folder) {
  const std::string path = folder.file("torus.off");
  write_mesh(path, grid_surface(20, 12));
  return path;
}

}  // namespace ucvt::test
