// Repair and several components, as the commands have them.
#include <algorithm>

#include "run_program.h"

namespace ucvt::test {
namespace {

/// Two tori, the second one apart.
TriangleMesh two_tori() {
  TriangleMesh mesh = grid_surface(20, 12);
  const auto shift = static_cast<std::int32_t>(mesh.positions.size());
  const TriangleMesh second = grid_surface(12, 10);
  for (const Position& p : second.positions) {
    mesh.positions.push_back({p[0] + 10, p[1], p[2]});
  }
  for (const auto& [a, b, c] : second.faces) {
    mesh.faces.push_back({a + shift, b + shift, c + shift});
  }
  return mesh;
}

/// A torus without its last face, the first one listed twice.
TriangleMesh damaged() {
  TriangleMesh mesh = grid_surface(20, 12);
  mesh.faces.pop_back();
  mesh.faces.push_back(mesh.faces.front());
  return mesh;
}

std::string write(const TemporaryFolder& folder, const TriangleMesh& mesh) {
  write_mesh(folder.file("in.off"), mesh);
  return folder.file("in.off");
}

TEST(RepairCommand, MakesADamagedTorusATorus) {
  const TemporaryFolder folder;
  const std::string input = write(folder, damaged()), output = folder.file("o.off");
  const std::vector<std::string> arguments = {
      "remesh", input, "-n",   "60",       "--tolerance",
      "0.01",   "-o",  output, "--report", folder.file("r.json")};
  const Outcome refused = run(arguments);
  EXPECT_EQ(refused.status, 3);
  EXPECT_HAS(only_line(refused.err),
             "the surface is open and not manifold: 1 boundary loop of 3 edges (first ");
  EXPECT_HAS(refused.err, "1 duplicate face (first face 479, of face 0), 3 non-manifold edges");
  EXPECT_HAS(refused.err, "; try --repair");
  std::vector<std::string> with = arguments;
  with.emplace_back("--repair");
  const Outcome taken = run(with);
  ASSERT_EQ(taken.status, 0) << taken.err;
  EXPECT_HAS(only_line(taken.err), "repair: dropped 1 duplicate face, closed 1 hole with 1 face");
  EXPECT_EQ(closed_surface(read_mesh(output)).genus, 1);
  const nlohmann::json repair = read_json(folder.file("r.json"))["repair"];
  EXPECT_EQ(repair["duplicate_faces"], 1);
  EXPECT_EQ(repair["closed_holes"], 1);
  EXPECT_EQ(repair["added_faces"], 1);
  EXPECT_EQ(repair["left_holes"], 0);
  EXPECT_EQ(repair.size(), 10U);
}

TEST(RepairCommand, UniformizeAndInfoKnowIt) {
  const TemporaryFolder folder;
  const std::string input = write(folder, damaged());
  const Outcome made =
      run({"uniformize", input, "-o", folder.file("t.ply"), "--repair", "--quiet"});
  EXPECT_EQ(made.status, 0);
  EXPECT_EQ(made.err, "");
  const Outcome info = run({"info", input, "--repair", "--report", folder.file("r.json")});
  EXPECT_HAS(info.out, "remesh --repair        takes it");
  const nlohmann::json report = read_json(folder.file("r.json"));
  EXPECT_EQ(report["acceptable"], false);
  EXPECT_EQ(report["repair"]["acceptable"], true);
  EXPECT_EQ(report["repair"]["refusal"], nullptr);
}

TEST(RepairCommand, WhatIsLeftIsNamed) {
  const TemporaryFolder folder;
  TriangleMesh half = grid_surface(20, 12);
  half.faces.resize(240);
  const Outcome open =
      run({"remesh", write(folder, half), "-n", "60", "-o", folder.file("o.off"), "--repair"});
  EXPECT_EQ(open.status, 3);
  EXPECT_HAS(only_line(open.err),
             "after repair (nothing to repair) the surface is open: 2 boundary "
             "loops of 24 edges");
  EXPECT_HAS(open.err, "; mend it by hand, or allow more with --weld and --holes");
  EXPECT_EQ(run({"remesh", folder.file("in.off"), "-n", "60", "--tolerance", "0.01", "-o",
                 folder.file("o.off"), "--repair", "--holes", "12"})
                .status,
            0);
  EXPECT_EQ(closed_surface(read_mesh(folder.file("o.off"))).genus, 0);
  const Outcome klein = run({"remesh", write(folder, grid_surface(20, 12, true)), "-n", "60", "-o",
                             folder.file("o.off"), "--repair"});
  EXPECT_EQ(klein.status, 3);
  EXPECT_HAS(only_line(klein.err), "a Klein bottle, Euler number 0; give a surface with two sides");
}

TEST(RepairCommand, LabelsAreOfTheFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(run({"partition", write(folder, damaged()), "-n", "60", "--tolerance", "0.01", "-o",
                 folder.file("p.ply"), "--labels", folder.file("l.csv"), "--repair"})
                .status,
            0);
  const std::string labels = slurp(folder.file("l.csv"));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), '\n'), 1 + 240 + 479);
  EXPECT_HAS(labels, "\nface,478,");
  EXPECT_EQ(labels.find("face,479,"), std::string::npos);
}

TEST(RepairCommand, OptionsNeedRepair) {
  for (const char* option : {"--weld", "--holes"}) {
    const Outcome outcome = run({"remesh", "in.off", "-n", "60", "-o", "o.off", option, "1"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_HAS(only_line(outcome.err), "--repair");
  }
}

TEST(ComponentsCommand, RemeshTakesAll) {
  const TemporaryFolder folder;
  const std::string input = write(folder, two_tori());
  const auto bytes = [&](const std::string& threads) {
    const Outcome outcome = run({"remesh", input, "-n", "150", "--iterations", "20", "--threads",
                                 threads, "--quiet", "-o", folder.file("o.off"), "--report",
                                 folder.file("r.json"), "--no-ensure-simplicial"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return slurp(folder.file("o.off"));
  };
  EXPECT_TRUE(bytes("1") == bytes("2"));
  const MeshSurvey made = survey(read_mesh(folder.file("o.off")));
  EXPECT_EQ(made.components, 2);
  EXPECT_EQ(made.vertices, 150);
  EXPECT_EQ(made.euler_number, 0);
  const nlohmann::json report = read_json(folder.file("r.json"));
  EXPECT_FALSE(report.contains("uniformization"));
  EXPECT_EQ(report["cvt"]["sites"], 150);
  EXPECT_EQ(report["remesh"]["genus"], 2);
  ASSERT_EQ(report["components"].size(), 2U);
  EXPECT_EQ(report["components"][1]["first_face"], 480);
  EXPECT_EQ(report["components"][1]["uniformization"]["geometry"], "euclidean");
  EXPECT_EQ(report["components"][0]["cvt"]["sites"].get<int>() +
                report["components"][1]["cvt"]["sites"].get<int>(),
            150);
}

TEST(ComponentsCommand, PartitionNumbersThrough) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"partition", write(folder, two_tori()), "-n", "80", "--iterations",
                               "5", "-o", folder.file("p.ply"), "--labels", folder.file("l.csv"),
                               "--cells", folder.file("c.csv"), "--no-ensure-simplicial"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_HAS(outcome.out, "euclidean (2 components)");
  EXPECT_EQ(survey(read_mesh(folder.file("p.ply"))).components, 2);
  const std::string labels = slurp(folder.file("l.csv")), cells = slurp(folder.file("c.csv"));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), '\n'), 1 + 360 + 720);
  EXPECT_HAS(cells, "\n79,");
  EXPECT_EQ(cells.find("\n80,"), std::string::npos);
}

TEST(ComponentsCommand, WhatTakesOneSaysSo) {
  const TemporaryFolder folder;
  const std::string input = write(folder, two_tori());
  const std::string sites =
      folder.write("s.json", R"({"sites": [{"face": 0, "bary": [1, 0, 0]}]})");
  const std::vector<std::vector<std::string>> extras = {{"--surface", folder.file("t.ply")},
                                                        {"--sites", folder.file("t.json")},
                                                        {"--init", sites},
                                                        {"--cover", folder.file("c.svg")}};
  for (const std::vector<std::string>& extra : extras) {
    std::vector<std::string> arguments = {"remesh", input, "-o", folder.file("o.off")};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    if (extra[0] != "--init") {
      arguments.insert(arguments.end(), {"-n", "50"});
    }
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_HAS(only_line(outcome.err), "the surface has 2 components, but " + extra[0]);
    EXPECT_HAS(outcome.err, "; choose it with --component K");
  }
  EXPECT_EQ(run({"uniformize", input, "-o", folder.file("t.ply")}).status, 2);
  EXPECT_EQ(run({"uniformize", input, "-o", folder.file("t.ply"), "--component", "1"}).status, 0);
  const Outcome beyond = run({"uniformize", input, "-o", folder.file("t.ply"), "--component", "2"});
  EXPECT_EQ(beyond.status, 2);
  EXPECT_HAS(only_line(beyond.err), "--component asks for 2, but the last one is 1");
  const Outcome few = run({"remesh", input, "-n", "1", "-o", folder.file("o.off")});
  EXPECT_EQ(few.status, 3);
  EXPECT_HAS(only_line(few.err), "1 sites are too few for 2 components; ask for at least 2");
}

}  // namespace
}  // namespace ucvt::test
