#include <algorithm>
#include <random>

#include "run_program.h"

namespace ucvt::test {
namespace {

std::vector<std::string> long_run(const TemporaryFolder& folder) {
  return {"remesh",       torus_file(folder),
          "-n",           "300",
          "-o",           folder.file("o.off"),
          "--method",     "lloyd",
          "--tolerance",  "1e-300",
          "--iterations", "1000000"};
}

std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Limits, ATimeLimitEndsARunInOrder) {
  const TemporaryFolder folder;
  const Outcome outcome = run(with(long_run(folder), {"--time-limit", "0.5"}));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(only_line(outcome.err),
            "ucvt: stopped after 0.5 seconds as asked for; no output was written\n");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(Limits, ATimeLimitHoldsWhileInputIsAwaited) {
  const TemporaryFolder folder;
  const std::string fifo = folder.file("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const Outcome outcome = run({"info", fifo, "--time-limit", "0.2"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), "stopped after 0.2 seconds");
}

TEST(Limits, MemoryThatEndsIsOneLine) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need memory of their own";
#endif
  for (const char* megabytes : {"1", "20"}) {
    const TemporaryFolder folder;
    const std::string input = folder.file("torus.off");
    write_mesh(input, grid_surface(400, 300));
    const Outcome outcome = run(
        {"remesh", input, "-n", "30000", "-o", folder.file("o.off"), "--memory-limit", megabytes});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_HAS(only_line(outcome.err), "not enough memory");
    EXPECT_EQ(folder.entries(), 1U);
  }
}

TEST(Checkpoints, AStoppedRunGoesOnToTheSameBytes) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), state = folder.file("state.json");
  const auto run_to = [&](const std::string& name, const std::vector<std::string>& more) {
    return run(
        with({"remesh", input, "-n", "300", "--tolerance", "1e-10", "--iterations", "400", "-o",
              folder.file(name + ".off"), "--sites", folder.file(name + ".json"), "--quiet"},
             more));
  };
  run_to("whole", {});
  // Killed at random moments, and at last not.
  std::minstd_rand random(1);
  std::vector<std::string> more{"--checkpoint", state, "--checkpoint-every", "0"};
  for (int kill = 0; kill < 5; ++kill) {
    const bool resumes = std::filesystem::exists(state);
    Program program(
        with({"remesh", input, "-n", "300", "--tolerance", "1e-10", "--iterations", "400", "-o",
              folder.file("parts.off"), "--sites", folder.file("parts.json"), "--quiet"},
             resumes ? with(more, {"--init", state}) : more));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 700));
    program.send(SIGKILL);
    program.wait();
  }
  run_to("parts", std::filesystem::exists(state) ? with(more, {"--init", state}) : more);
  EXPECT_EQ(slurp(folder.file("parts.off")), slurp(folder.file("whole.off")));
  EXPECT_EQ(slurp(folder.file("parts.json")), slurp(folder.file("whole.json")));
  EXPECT_FALSE(slurp(folder.file("whole.off")).empty());
}

TEST(Checkpoints, AnInterruptionSavesTheLastState) {
  const TemporaryFolder folder;
  const std::string state = folder.file("state.json");
  Program program(with(long_run(folder), {"--checkpoint", state, "--verbose"}));
  ASSERT_TRUE(program.says("iteration  250"));
  program.send(SIGTERM);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.err.ends_with("no output was written; go on with --init " + state + "\n"))
      << outcome.err.substr(outcome.err.size() - 200);
  EXPECT_EQ(read_json(state)["progress"]["sites"], 300);
}

TEST(Checkpoints, DoNotGoToStandardOutput) {
  const TemporaryFolder folder;
  const Outcome outcome = run(with(long_run(folder), {"--checkpoint", "-"}));
  EXPECT_EQ(outcome.status, 2);
}

TEST(Signals, AtRandomMomentsEndARunInOrder) {
  std::minstd_rand random(2);
  for (int i = 0; i < 12; ++i) {
    const TemporaryFolder folder;
    Program program(with(long_run(folder), {"--verbose"}));
    ASSERT_TRUE(program.says("iteration"));
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 400));
    program.send(i % 2 == 0 ? SIGTERM : SIGINT);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.ends_with("\nucvt: interrupted; no output was written\n"));
    EXPECT_EQ(folder.entries(), 1U);
  }
}

}  // namespace
}  // namespace ucvt::test
