#include "run_program.h"

namespace ucvt::test {
namespace {

TEST(Signals, AnInterruptedRunLeavesNoFile) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TemporaryFolder folder;
    Program program({"remesh", torus_file(folder), "-n", "200", "-o", folder.file("o.off"),
                     "--surface", folder.file("t.ply"), "--sites", folder.file("s.json"),
                     "--report", folder.file("r.json"), "--tolerance", "1e-15", "--iterations",
                     "1000000", "--verbose"});
    ASSERT_TRUE(program.says("optimize"));
    program.send(signal);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.ends_with("\nucvt: interrupted; no output was written\n"));
    EXPECT_EQ(folder.entries(), 1U);  // the torus
  }
}

TEST(Signals, AWaitForInputIsInterruptedToo) {
  const TemporaryFolder folder;
  const std::string fifo = folder.file("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  Program program({"info", fifo});
  // The open for writing returns when the program has opened the fifo for reading.
  const int writer = ::open(fifo.c_str(), O_WRONLY);
  ASSERT_GE(writer, 0);
  program.send(SIGINT);
  const Outcome outcome = program.wait();
  ::close(writer);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(only_line(outcome.err), "ucvt: interrupted; no output was written\n");
}

}  // namespace
}  // namespace ucvt::test
