#include "run_program.h"

namespace ucvt::test {
namespace {

using Names = std::vector<std::string>;

TEST(SpaceOptions, PolygonsAreReadFromFiles) {
  const TemporaryFolder folder;
  const auto tessellate = [&](const std::string& bytes) {
    return run({"plane", "-n", "20", "--tolerance", "0.01", "--domain",
                folder.write("corners.txt", bytes), "--report", folder.file("r.json")});
  };
  const Outcome outcome = tessellate("# a triangle\n0 0\n4 0\n\n0 3\n");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_DOUBLE_EQ(read_json(folder.file("r.json"))["space"]["area"], 6);
  const auto refused = [&](const std::string& bytes) {
    const Outcome wrong = tessellate(bytes);
    EXPECT_EQ(wrong.status, 3) << bytes;
    EXPECT_HAS(wrong.err, "corners.txt: ");
    return only_line(wrong.err);
  };
  EXPECT_HAS(refused("0 0\n1 x\n"), "line 2 ");
  EXPECT_HAS(refused("0 0\n1\n0 1\n"), "line 2 ");
  EXPECT_HAS(refused("0 0\n1 1 1\n"), "line 2 ");
  EXPECT_HAS(refused("0 0\n1 0\n"), "2 corners");
  EXPECT_HAS(refused("0 0\n2 0\n1 0.1\n1 2\n"), "not convex");
  const Outcome missing = run({"hyperbolic", "-n", "3", "--domain", folder.file("none")});
  EXPECT_EQ(missing.status, 1);
  EXPECT_HAS(only_line(missing.err), "none: cannot open the file");
}

TEST(SpaceOptions, WrongUsageIsOneLineWithAHint) {
  struct Wrong {
    Names arguments;
    std::string says;
  };
  for (const auto& [arguments, says] : std::vector<Wrong>{
           {{"sphere"}, "-n N, the number of sites, is missing"},
           {{"sphere", "-n", "0"}, "'0'"},
           {{"sphere", "-n", "9", "in.off"}, "in.off"},
           {{"sphere", "-n", "9", "--density", "1+foo"},
            "--density: unknown name 'foo' at position 3"},
           {{"plane", "-n", "9", "--density", "-1"}, "--density: the constant is -1"},
           {{"sphere", "-n", "9", "--quadrature", "0"}, "'0' is not a number between 0 and 1"},
           {{"sphere", "-n", "9", "--method", "newton"}, "'newton' is none of lbfgs|lloyd"},
           {{"sphere", "-n", "9", "--centroids"}, "--centroids requires --figure"},
           {{"sphere", "-n", "9", "--figure", "f.gif"}, "'.gif'"},
           {{"sphere", "-n", "9", "--cells", "c.vtk"}, "'.vtk'"},
           {{"sphere", "-n", "9", "-o", "c.vtu"}, "'.vtu'"},
           {{"sphere", "-n", "9", "--figure", "f.svg", "--figure-cells", "red"}, "'red'"},
           {{"sphere", "-n", "9", "--figure", "f.svg", "--projection", "klein"}, "'klein'"},
           {{"sphere", "-n", "9", "--figure", "f.svg", "--view", "0,91"}, "'0,91'"},
           {{"sphere", "-n", "9", "--figure", "f.svg", "--plot-energy", "./f.svg"}, "f.svg"},
           {{"plane", "-n", "9", "--figure", "f.svg", "--view", "0,0"}, "--view"},
           {{"plane", "-n", "9", "--domain", "regular:2"}, "'regular:2'"},
           {{"plane", "-n", "9", "--domain", "regular:5:-1"}, "'regular:5:-1'"},
           {{"plane", "-n", "9", "--domain", "rectangle:1"}, "'rectangle:1'"},
           {{"plane", "-n", "9", "--domain", "surface:2"}, "surfaces are hyperbolic"},
           {{"torus", "-n", "9", "--lattice", "round"}, "'round'"},
           {{"torus", "-n", "9", "--lattice", "1,0:2,0"}, "does not span the plane"},
           {{"hyperbolic", "-n", "9", "--domain", "regular:6:1"}, "below 1"},
           {{"hyperbolic", "-n", "9", "--domain", "rectangle:1x1"}, "no rectangles"},
           {{"hyperbolic", "-n", "9", "--domain", "surface:1"}, "'surface:1'"},
           {{"hyperbolic", "-n", "9", "--domain", "surface:2:twisted"}, "'surface:2:twisted'"},
           {{"hyperbolic", "-n", "9", "--coordinates", "polar"}, "'polar'"},
           {{"plane", "--domain", "-", "--init", "-"}, "standard input"}}) {
    const Outcome outcome = run(arguments);
    const std::string line = only_line(outcome.err);
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_EQ(outcome.out, "");
    EXPECT_HAS(line, says);
    EXPECT_TRUE(line.ends_with("; try 'ucvt " + arguments[0] + " --help'\n")) << line;
  }
}

}  // namespace
}  // namespace ucvt::test
