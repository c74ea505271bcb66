// --figure and --cover of uniformize and remesh.
#include "run_program.h"
#include "ucvt/figure.h"

namespace ucvt::test {
namespace {

TEST(FigureCommand, UniformizeDrawsSurfaceAndCover) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  for (const std::string show : {"plain", "loops", "area", "angle"}) {
    const Outcome outcome =
        run({"uniformize", input, "-o", folder.file("t.ply"), "--figure", folder.file("f.svg"),
             "--show", show, "--camera", "-90,90,10", "--width", "150", "--cover",
             folder.file("c.svg"), "--mesh-edges"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_HAS(slurp(folder.file("f.svg")), "data:image/png;base64,");
    EXPECT_HAS(slurp(folder.file("c.svg")), "class=\"mesh\"");
    EXPECT_HAS(slurp(folder.file("c.svg")), "width=\"150\"");
  }
}

TEST(FigureCommand, RemeshDrawsMeshCellsAndCover) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  for (const std::string show : {"mesh", "wireframe", "cells"}) {
    const Outcome outcome =
        run({"remesh", input, "-n", "30", "-o", folder.file("o.off"), "--figure",
             folder.file("f.svg"), "--show", show, "--cover", folder.file("c.svg")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_HAS(slurp(folder.file("f.svg")), "data:image/png;base64,");
    EXPECT_HAS(slurp(folder.file("c.svg")), "class=\"copy-sites\"");
  }
}

TEST(FigureCommand, PngIsWrittenOrRefused) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), png = folder.file("f.png");
  const Outcome outcome =
      run({"uniformize", input, "-o", folder.file("t.ply"), "--figure", png, "--width", "100"});
  if (can_write_png()) {
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(slurp(png).substr(1, 3), "PNG");
  } else {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_HAS(only_line(outcome.err), "librsvg");
  }
}

TEST(FigureCommand, WrongOptionsAreOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--figure", "f.gif"}, "'.gif'"},
      {{"--cover", "f.pdf"}, "'.pdf'"},
      {{"--figure", "f.svg", "--show", "cells"}, "'cells'"},
      {{"--show", "loops"}, "--figure"},
      {{"--figure", "f.svg", "--camera", "1"}, "'1'"},
      {{"--figure", "f.svg", "--camera", "1,91"}, "'1,91'"},
      {{"--figure", "f.svg", "--camera", "1,2,3,4"}, "'1,2,3,4'"},
      {{"--figure", "f.svg", "--camera", "1,nan"}, "'1,nan'"},
      {{"--figure", "f.svg", "--width", "99"}, "'99'"},
      {{"--figure", "f.svg", "--cover", "./f.svg"}, "f.svg"},
      {{"--cover", "f.svg", "--coordinates", "polar"}, "'polar'"}};
  for (const auto& [options, says] : cases) {
    std::vector<std::string> arguments{"uniformize", "in.off", "-o", "t.ply"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2) << says;
    EXPECT_HAS(only_line(outcome.err), says);
  }
}

TEST(FigureCommand, CoordinatesOfAnotherGeometryWriteNothing) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  const Outcome outcome = run({"uniformize", input, "-o", folder.file("t.ply"), "--cover",
                               folder.file("c.svg"), "--coordinates", "poincare"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_HAS(only_line(outcome.err), "a torus is laid out in the plane");
  EXPECT_EQ(folder.entries(), 1U);
}

}  // namespace
}  // namespace ucvt::test
