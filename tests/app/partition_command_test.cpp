#include <set>
#include <sstream>

#include "run_program.h"

namespace ucvt::test {
namespace {

/// The fields of every line but the heading.
std::vector<std::vector<std::string>> table(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) {
      rows.back().push_back(field);
    }
  }
  return rows;
}

TEST(PartitionCommand, CutsASurfaceWithBoundary) {
  const TemporaryFolder folder;
  TriangleMesh mesh = grid_surface(20, 12);
  mesh.faces.resize(mesh.faces.size() - 6);
  const std::string input = folder.file("open.off"), output = folder.file("p.ply");
  write_mesh(input, mesh);
  const Outcome outcome =
      run({"partition", input, "-n", "40", "-o", output, "--labels", folder.file("l.csv"),
           "--cells", folder.file("c.csv"), "--figure", folder.file("f.svg")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const MeshSurvey in = survey(mesh), out = survey(read_mesh(output));
  EXPECT_EQ(out.boundary_loops, 1);
  EXPECT_EQ(out.euler_number, in.euler_number);
  EXPECT_NEAR(out.area / in.area, 1, 1e-12);
  EXPECT_EQ(table(slurp(folder.file("c.csv"))).size(), 40U);
  EXPECT_EQ(table(slurp(folder.file("l.csv"))).size(), 240U + 474U);
}

TEST(PartitionCommand, CutsTheInput) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), output = folder.file("p.ply");
  const Outcome outcome =
      run({"partition", input, "-n", "40", "-o", output, "--labels", folder.file("l.csv"),
           "--cells", folder.file("c.csv"), "--report", folder.file("r.json"), "--surface",
           folder.file("t.ply"), "--sites", folder.file("s.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_HAS(outcome.out, "cells        40\n");
  const TriangleMesh cut = read_mesh(output);
  const MeshSurvey in = survey(read_mesh(input)), out = survey(cut);
  EXPECT_EQ(out.boundary_edges + out.nonmanifold_edges + out.nonmanifold_vertices, 0);
  EXPECT_EQ(out.euler_number, 0);
  EXPECT_EQ(out.components, 1);
  EXPECT_NEAR(out.area / in.area, 1, 1e-12);

  double area = 0;
  const auto cells = table(slurp(folder.file("c.csv")));
  ASSERT_EQ(cells.size(), 40U);
  for (const auto& row : cells) {
    area += std::stod(row[4]);
  }
  EXPECT_NEAR(area / in.area, 1, 1e-12);

  std::set<std::string> used;
  const auto labels = table(slurp(folder.file("l.csv")));
  ASSERT_EQ(labels.size(), 240U + 480U);
  for (const auto& row : labels) {
    used.insert(row[2]);
  }
  EXPECT_EQ(used.size(), 40U);

  const nlohmann::json report = read_json(folder.file("r.json"));
  EXPECT_EQ(report["partition"]["cells"], 40);
  EXPECT_EQ(report["partition"]["faces"], cut.faces.size());
  EXPECT_EQ(report["cvt"]["sites"], 40);
  EXPECT_EQ(read_json(folder.file("s.json"))["sites"].size(), 40U);
}

TEST(PartitionCommand, LabelsNumberTheVerticesOfTheFile) {
  const TemporaryFolder folder;
  TriangleMesh mesh = grid_surface(20, 12);
  mesh.positions.insert(mesh.positions.begin(), {9, 9, 9});  // used by no face
  for (Corners& face : mesh.faces) {
    face = {face[0] + 1, face[1] + 1, face[2] + 1};
  }
  write_mesh(folder.file("in.off"), mesh);
  ASSERT_EQ(run({"partition", folder.file("in.off"), "-n", "30", "-o", folder.file("p.ply"),
                 "--labels", folder.file("l.csv")})
                .status,
            0);
  const auto labels = table(slurp(folder.file("l.csv")));
  EXPECT_EQ(labels[0][1], "1");
  EXPECT_EQ(labels[239][1], "240");
  EXPECT_EQ(labels[240][1], "0");  // of the faces
}

TEST(PartitionCommand, SameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  const auto bytes = [&](const std::string& threads) {
    const Outcome outcome = run({"partition", input, "-n", "50", "-o", "-", "--threads", threads});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  const std::string first = bytes("1");
  EXPECT_HAS(first, "property int cell\n");
  EXPECT_TRUE(first == bytes("2"));
}

TEST(PartitionCommand, WritesPlyOnly) {
  const Outcome outcome = run({"partition", "in.off", "-n", "40", "-o", "p.obj"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_HAS(only_line(outcome.err), "the extension '.obj' is none of .ply");
}

}  // namespace
}  // namespace ucvt::test
