#include <sstream>

#include "run_program.h"

namespace ucvt::test {
namespace {

/// The value of a line "name  value".
std::string value_of(const std::string& lines, const std::string& name) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(name + "  ", 0) == 0) {
      return line.substr(line.find_first_not_of(' ', name.size()));
    }
  }
  ADD_FAILURE() << "no line " << name << " in\n" << lines;
  return "";
}

TEST(InfoCommand, PrintsTopologyAndQuality) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"info", torus_file(folder), "--report", folder.file("report.json")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(value_of(outcome.out, "vertices"), "240");
  EXPECT_EQ(value_of(outcome.out, "faces"), "480");
  EXPECT_EQ(value_of(outcome.out, "genus"), "1");
  EXPECT_EQ(value_of(outcome.out, "Euler number"), "0");
  EXPECT_EQ(value_of(outcome.out, "orientable"), "yes");
  EXPECT_EQ(value_of(outcome.out, "remesh"), "takes it");
  const nlohmann::json report = read_json(folder.file("report.json"));
  EXPECT_EQ(report["acceptable"], true);
  EXPECT_EQ(report["refusal"], nullptr);
  EXPECT_EQ(report["input"]["genus"], 1);
  EXPECT_EQ(report["topology"]["edges"], 720);
  EXPECT_EQ(report["quality"]["regular"], 1.0);
}

TEST(InfoCommand, SaysWhatRemeshTakesAndRefuses) {
  const TemporaryFolder folder;
  TriangleMesh mesh = grid_surface(20, 12);
  mesh.faces.pop_back();
  write_mesh(folder.file("open.off"), mesh);
  const Outcome open = run({"info", folder.file("open.off"), "--report", "-"});
  EXPECT_EQ(open.status, 0);
  const nlohmann::json report = nlohmann::json::parse(open.out);
  EXPECT_EQ(report["acceptable"], true);
  EXPECT_TRUE(report["refusal"].is_null());
  EXPECT_HAS(value_of(run({"info", folder.file("open.off")}).out, "remesh"),
             "takes it, with its boundary");
  EXPECT_EQ(report["topology"]["boundary_edges"], 3);
  EXPECT_EQ(report["input"]["genus"], 1);

  write_mesh(folder.file("klein.off"), grid_surface(20, 12, true));
  const Outcome klein = run({"info", folder.file("klein.off")});
  EXPECT_EQ(klein.status, 0);
  EXPECT_EQ(value_of(klein.out, "orientable"), "no");
  EXPECT_HAS(value_of(klein.out, "genus"), "none");
  EXPECT_HAS(value_of(klein.out, "remesh"), "refuses it: the surface is not orientable");
}

TEST(InfoCommand, AFileThatIsNoMeshIsRefused) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"info", folder.write("words.off", "these are words")});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.out, "");
  only_line(outcome.err);
}

}  // namespace
}  // namespace ucvt::test
