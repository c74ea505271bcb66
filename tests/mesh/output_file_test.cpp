#include "mesh/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

TEST(OutputFile, AppearsWithTheCommitOnly) {
  const TemporaryFolder folder;
  {
    OutputFile out(folder.file("a"));
    out.write("one ");
    out.write(std::string(3 << 20, 'x'));
    EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
    out.commit();
    EXPECT_EQ(slurp(folder.file("a")).size(), 4U + (3 << 20));
  }
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFile, LeavesNothingWithoutACommit) {
  const TemporaryFolder folder;
  folder.write("a", "old");
  {
    OutputFile out(folder.file("a"));
    out.write(std::string(3 << 20, 'x'));
  }
  EXPECT_EQ(slurp(folder.file("a")), "old");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(OutputFile, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  folder.write("a", "old");
  ASSERT_EQ(::chmod(folder.file("a").c_str(), 0640), 0);
  std::filesystem::create_symlink("a", folder.file("link"));
  OutputFile out(folder.file("link"));
  out.write("new");
  out.commit();
  EXPECT_EQ(slurp(folder.file("a")), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  struct stat status = {};
  ASSERT_EQ(::stat(folder.file("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(OutputFile, FailuresAreIoErrors) {
  const TemporaryFolder folder;
  EXPECT_THROW(OutputFile(folder.file("none/a")), IoError);
  EXPECT_THROW(OutputFile(folder.file("")), IoError);
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(OutputFile, AFullDiskIsAnIoError) {
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full here";
  }
  OutputFile out("/dev/full");
  out.write("x");
  EXPECT_THROW(out.commit(), IoError);
}

TEST(OutputFile, WritesDevicesAndPipesDirectly) {
  OutputFile null("/dev/null");
  null.write("x");
  null.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  const int reader = ::open(folder.file("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  {
    OutputFile out(folder.file("pipe"));
    out.write("hello");
    out.commit();
  }
  char text[8] = {};
  EXPECT_EQ(::read(reader, text, sizeof text), 5);
  EXPECT_STREQ(text, "hello");
  OutputFile broken(folder.file("pipe"));
  ::close(reader);
  broken.write("x");
  EXPECT_THROW(broken.commit(), IoError);  // not a signal
}

TEST(OutputFile, StandardOutputIsWrittenAtTheCommit) {
  testing::internal::CaptureStdout();
  {
    OutputFile("-").write("lost");
  }
  OutputFile out("-");
  out.write("kept");
  out.commit();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "kept");
}

}  // namespace
}  // namespace ucvt::test
