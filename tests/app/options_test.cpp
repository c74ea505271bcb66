#include "run_program.h"

namespace ucvt::test {
namespace {

struct WrongUsage {
  std::vector<std::string> arguments;
  std::string says, hint;
};

TEST(Options, WrongUsageIsOneLineWithAHint) {
  const std::string remesh = "; try 'ucvt remesh --help'\n";
  const std::vector<WrongUsage> cases = {
      {{}, "no command", "; try 'ucvt --help'\n"},
      {{"frobnicate"}, "'frobnicate'", "; try 'ucvt --help'\n"},
      {{"--frobnicate"}, "'--frobnicate'", "; try 'ucvt --help'\n"},
      {{"remesh"}, "required", remesh},
      {{"remesh", "in.off", "-n", "10"}, "-o is required", remesh},
      {{"remesh", "in.off", "-o", "o.off"}, "-n N, the number of sites, is missing", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "0"}, "'0'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "-7"}, "'-7'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "1.5"}, "'1.5'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "99999999999"}, "'99999999999'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "ten"}, "'ten'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", ""}, "-n", remesh},
      {{"remesh", "in.off", "-o", "", "-n", "9"}, "-o is empty", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--tolerance", "0"}, "--tolerance", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--tolerance", "nan"}, "'nan'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--iterations", "-1"}, "'-1'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--seed", "-1"}, "--seed", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--threads", "0"}, "--threads", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--method", "magic"}, "'magic'", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "more"}, "more", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "-n", "8"}, "-n", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--quiet", "--verbose"}, "--quiet", remesh},
      {{"remesh", "in.off", "-o", "o.xyz", "-n", "9"}, "'.xyz'", remesh},
      {{"remesh", "in.off", "-o", "o", "-n", "9"}, "extension", remesh},
      {{"remesh", "in.off", "-o", "o.off", "-n", "9", "--surface", "t.off"}, "'.off'", remesh},
      {{"remesh", "in.off", "-o", "-", "-n", "9", "--report", "-"}, "more than one", remesh},
      {{"remesh", "in.off", "-o", "t.ply", "-n", "9", "--surface", "./t.ply"}, "t.ply", remesh},
      {{"remesh", "-", "-o", "o.off", "--init", "-"}, "standard input", remesh},
      {{"uniformize", "in.off"}, "-o is required", "; try 'ucvt uniformize --help'\n"},
      {{"uniformize", "in.off", "-o", "o.off"}, "'.off'", "; try 'ucvt uniformize --help'\n"},
      {{"info"}, "IN is required", "; try 'ucvt info --help'\n"},
      {{"info", "in.off", "-n", "3"}, "-n", "; try 'ucvt info --help'\n"},
  };
  for (const WrongUsage& wrong : cases) {
    const Outcome outcome = run(wrong.arguments);
    const std::string line = only_line(outcome.err);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_EQ(outcome.out, "");
    EXPECT_HAS(line, wrong.says);
    EXPECT_TRUE(line.ends_with(wrong.hint)) << line;
  }
}

TEST(Options, HelpAndVersionAreResults) {
  for (const std::string command : {"remesh", "uniformize", "info"}) {
    const Outcome help = run({command, "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_HAS(help.out, "ucvt " + command);
    EXPECT_EQ(run({command, "--version"}).out.rfind("ucvt ", 0), 0U);
  }
  EXPECT_HAS(run({"--help"}).out, "uniformize");
  const Outcome version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("ucvt ", 0), 0U);
}

TEST(Options, NumbersAreDecimal) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"remesh", torus_file(folder), "-n", "030", "-o", "-"});
  EXPECT_EQ(outcome.out.rfind("OFF\n30 60 0\n", 0), 0U) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace ucvt::test
