#include <sys/resource.h>

#include "run_program.h"

namespace ucvt::test {
namespace {

TEST(Outputs, AreTriedBeforeTheInputIsRead) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("none/out.off");
  const Outcome outcome =
      run({"remesh", folder.file("no_such.off"), "-n", "9", "--tolerance", "0.01", "-o", missing});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), "ucvt: " + missing + ": ");

  const std::string directory = folder.file("dir.ply");
  std::filesystem::create_directory(directory);
  const Outcome onto = run({"remesh", torus_file(folder), "-n", "9", "--tolerance", "0.01", "-o",
                            folder.file("a.off"), "--surface", directory});
  EXPECT_EQ(onto.status, 1);
  EXPECT_HAS(only_line(onto.err), directory);
  EXPECT_EQ(folder.entries(), 2U);  // torus and directory
}

TEST(Outputs, ThatCannotBeWrittenLeaveNothing) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  std::string where = folder.file("locked"), why = "Permission denied";
  std::filesystem::create_directory(where);
  std::filesystem::permissions(where, std::filesystem::perms::owner_exec);
  if (::geteuid() == 0) {  // who may write everywhere but in a file
    where = input, why = "Not a directory";
  }
  const Outcome outcome =
      run({"remesh", input, "-n", "9", "--tolerance", "0.01", "-o", where + "/a.off"});
  std::filesystem::permissions(folder.file("locked"), std::filesystem::perms::owner_all);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), why);
  EXPECT_EQ(folder.entries(), 2U);  // torus and directory
}

TEST(Outputs, LargerThanTheLimitOnFilesLeaveNothing) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), output = folder.file("o.off");
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small = {4096, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const Outcome outcome = run({"remesh", input, "-n", "400", "--tolerance", "0.01", "-o", output,
                               "--surface", folder.file("t.ply"), "--quiet"});
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), "File too large");
  EXPECT_EQ(folder.entries(), 1U);  // the torus
}

TEST(Outputs, StandardStreamsAreFiles) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), output = folder.file("out.off");
  ASSERT_EQ(
      run({"remesh", input, "-n", "40", "--tolerance", "0.01", "-o", output, "--quiet"}).status, 0);
  const Outcome piped =
      run({"remesh", "-", "-n", "40", "--tolerance", "0.01", "-o", "-"}, slurp(input));
  EXPECT_EQ(piped.status, 0) << piped.err;
  EXPECT_EQ(piped.err, "");
  EXPECT_EQ(piped.out, slurp(output));

  const Outcome report =
      run({"remesh", "-", "-n", "40", "--tolerance", "0.01", "-o", output, "--report", "-"},
          slurp(input));
  EXPECT_EQ(report.status, 0) << report.err;
  EXPECT_EQ(nlohmann::json::parse(report.out)["input"]["file"], "-");
}

TEST(Outputs, AStdoutThatTakesNothingIsAnError) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  for (const Stdout out : {Stdout::closed, Stdout::full_disk, Stdout::broken_pipe}) {
    if (out == Stdout::full_disk && !std::filesystem::exists("/dev/full")) {
      continue;
    }
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"remesh", input, "-n", "40", "--tolerance", "0.01", "-o", "-"},
             {"info", input},
             {"--version"}}) {
      const Outcome outcome = run(arguments, "", out);
      EXPECT_EQ(outcome.status, 1) << arguments.front();
      EXPECT_HAS(only_line(outcome.err), "ucvt: standard output: ");
    }
  }
}

TEST(Outputs, AreWrittenWithAClosedStdout) {
  const TemporaryFolder folder;
  const std::string output = folder.file("out.off");
  const Outcome outcome = run(
      {"remesh", torus_file(folder), "-n", "40", "--tolerance", "0.01", "-o", output, "--quiet"},
      "", Stdout::closed);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(closed_surface(read_mesh(output)).genus, 1);
}

}  // namespace
}  // namespace ucvt::test
