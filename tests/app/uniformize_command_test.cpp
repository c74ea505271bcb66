#include "run_program.h"

namespace ucvt::test {
namespace {

TEST(UniformizeCommand, WritesTheSurfaceAndAReport) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), output = folder.file("t.ply");
  const Outcome outcome =
      run({"uniformize", input, "-o", output, "--report", folder.file("r.json"), "--threads", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_HAS(outcome.out, "euclidean");
  const std::string ply = slurp(output);
  EXPECT_HAS(ply, "comment geometry euclidean\ncomment genus 1\nelement vertex 240\n");
  const nlohmann::json report = read_json(folder.file("r.json"));
  EXPECT_EQ(report["input"]["faces"], 480);
  EXPECT_EQ(report["threads"], 1);
  EXPECT_LT(report["uniformization"]["max_angle_error"], 6e-9);  // degrees; 1e-10 rad
  EXPECT_EQ(report["uniformization"]["refined_vertices"], 0);
  for (const char* key : {"seconds", "peak_memory_bytes", "version"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  const Outcome piped = run({"uniformize", "-", "-o", "-"}, slurp(input));
  EXPECT_TRUE(piped.out == ply);
  EXPECT_EQ(piped.err, "");
}

TEST(UniformizeCommand, WritesTheDeckGroup) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  const Outcome outcome =
      run({"uniformize", input, "-o", folder.file("t.ply"), "--group", folder.file("g.json"),
           "--loops", folder.file("l.obj"), "--uv", folder.file("uv.obj"), "--coordinates", "plane",
           "--report", folder.file("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json group = read_json(folder.file("g.json"));
  EXPECT_EQ(group["generators"].size(), 2U);
  const nlohmann::json report = read_json(folder.file("r.json"));
  EXPECT_LT(report["group"]["residual"], 1e-9);
  EXPECT_HAS(slurp(folder.file("l.obj")), "o a1\nl ");
  const TriangleMesh uv = read_mesh(folder.file("uv.obj"));
  EXPECT_EQ(uv.faces.size(), 480U);
  EXPECT_HAS(slurp(folder.file("uv.obj")), "\nvt ");
}

TEST(UniformizeCommand, SaysBeforeItComputesThatThereIsNoSuchLayout) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  const Outcome torus = run({"uniformize", input, "-o", folder.file("t.ply"), "--uv",
                             folder.file("uv.obj"), "--coordinates", "poincare"});
  EXPECT_EQ(torus.status, 3);
  EXPECT_HAS(only_line(torus.err), "a torus is laid out in the plane");
  write_mesh(
      folder.file("ball.off"),
      {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}});
  const Outcome sphere = run({"uniformize", folder.file("ball.off"), "-o", folder.file("t.ply"),
                              "--group", folder.file("g.json")});
  EXPECT_EQ(sphere.status, 3);
  EXPECT_HAS(only_line(sphere.err), "a sphere is its own universal cover");
  EXPECT_EQ(folder.entries(), 2U);
}

TEST(UniformizeCommand, DoublesAnOpenSurface) {
  const TemporaryFolder folder;
  TriangleMesh mesh = grid_surface(20, 12);
  mesh.faces.pop_back();
  write_mesh(folder.file("open.off"), mesh);
  const Outcome outcome =
      run({"uniformize", folder.file("open.off"), "-o", folder.file("t.ply"), "--group",
           folder.file("g.json"), "--report", folder.file("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string ply = slurp(folder.file("t.ply"));
  EXPECT_HAS(ply, "comment genus 2\nelement vertex 477\n");
  EXPECT_HAS(ply, "property double log_scale\nproperty int mirror\nelement face 958\n");
  EXPECT_EQ(read_mesh(folder.file("t.ply")).faces.size(), 958U);
  EXPECT_EQ(read_json(folder.file("g.json"))["generators"].size(), 4U);
  EXPECT_EQ(read_json(folder.file("r.json"))["uniformization"]["genus"], 2);
}

}  // namespace
}  // namespace ucvt::test
