#include "run_program.h"

namespace ucvt::test {
namespace {

using Names = std::vector<std::string>;

void expect_keys(const nlohmann::json& object, const Names& names) {
  ASSERT_TRUE(object.is_object());
  for (const std::string& name : names) {
    EXPECT_TRUE(object.contains(name)) << name;
  }
  EXPECT_EQ(object.size(), names.size()) << object.dump();
}

TEST(RemeshCommand, WritesAClosedTorusInAllFormats) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  for (const std::string extension : {"obj", "off", "ply", "stl"}) {
    const std::string output = folder.file("out." + extension);
    const Outcome outcome =
        run({"remesh", input, "-n", "100", "--tolerance", "0.01", "-o", output});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_HAS(outcome.out, "euclidean");
    const ClosedSurface surface = closed_surface(read_mesh(output));
    EXPECT_EQ(surface.genus, 1);
    EXPECT_EQ(surface.reoriented_faces, 0);
    EXPECT_EQ(surface.mesh.positions.size(), 100U);
    EXPECT_EQ(surface.mesh.faces.size(), 200U);
  }
}

TEST(RemeshCommand, ReportHasAllKeys) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), report_file = folder.file("report.json");
  const Outcome outcome =
      run({"remesh", input, "-n", "100", "--tolerance", "0.01", "-o", folder.file("out.off"),
           "--report", report_file, "--seed", "7", "--threads", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json report = read_json(report_file);
  const Names spread = {"mean", "cv", "min", "max"};
  expect_keys(report, {"input", "uniformization", "cvt", "uniformity", "surface", "remesh",
                       "seconds", "peak_memory_bytes", "version", "seed", "threads"});
  expect_keys(report["input"],
              {"file", "vertices", "faces", "genus", "components", "area", "bbox_diagonal"});
  expect_keys(report["uniformization"],
              {"geometry", "newton_iterations", "euclidean_flips", "ptolemy_flips",
               "refined_vertices", "vertices", "faces", "genus", "max_angle_error", "area",
               "log_scale_min", "log_scale_max", "seconds"});
  expect_keys(report["cvt"], {"method", "sites", "iterations", "converged", "energy", "max_move",
                              "seconds", "seconds_per_iteration", "energy_over_hexagonal"});
  EXPECT_NEAR(report["cvt"]["energy_over_hexagonal"], 1.01, 0.015);
  expect_keys(report["uniformity"], {"radius", "nearest", "area", "degree", "hexagons"});
  for (const char* measure : {"radius", "nearest", "area"}) {
    expect_keys(report["uniformity"][measure], spread);
  }
  expect_keys(report["surface"], {"cell_area"});
  expect_keys(report["surface"]["cell_area"], spread);
  expect_keys(report["remesh"],
              {"vertices", "faces", "genus", "boundary_loops", "simplicial", "sites_added", "q_min",
               "q_avg", "angle_min", "angle_min_avg", "below_30", "regular"});
}

TEST(RemeshCommand, ReportSaysWhatWasDone) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), report_file = folder.file("report.json");
  ASSERT_EQ(run({"remesh", input, "-n", "100", "--tolerance", "0.01", "-o", folder.file("out.off"),
                 "--report", report_file, "--seed", "7", "--threads", "2"})
                .status,
            0);
  const nlohmann::json report = read_json(report_file);
  EXPECT_EQ(report["input"]["file"], input);
  EXPECT_EQ(report["input"]["vertices"], 240);
  EXPECT_EQ(report["input"]["faces"], 480);
  EXPECT_EQ(report["input"]["genus"], 1);
  EXPECT_EQ(report["seed"], 7);
  EXPECT_EQ(report["threads"], 2);
  EXPECT_EQ(report["uniformization"]["geometry"], "euclidean");
  EXPECT_EQ(report["cvt"]["converged"], true);
  EXPECT_GT(report["cvt"]["iterations"], 0);
  EXPECT_LE(report["cvt"]["energy"].size(), report["cvt"]["iterations"].get<std::size_t>() + 1);
  EXPECT_EQ(report["cvt"]["max_move"].size(), report["cvt"]["energy"].size());
  EXPECT_EQ(report["remesh"]["vertices"], 100);
  EXPECT_EQ(report["remesh"]["genus"], 1);
  EXPECT_GT(report["peak_memory_bytes"], 1000000);
  std::int64_t sites = 0;
  for (const auto& [degree, count] : report["uniformity"]["degree"].items()) {
    sites += count.get<std::int64_t>();
  }
  EXPECT_EQ(sites, 100);
}

TEST(RemeshCommand, SameSeedSameBytes) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  const auto bytes = [&](const std::string& seed, const std::string& threads) {
    const Outcome outcome =
        run({"remesh", input, "-n", "100", "-o", folder.file("o.ply"), "--surface",
             folder.file("t.ply"), "--sites", folder.file("s.json"), "--seed", seed, "--threads",
             threads, "--iterations", "30", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
    return slurp(folder.file("o.ply")) + slurp(folder.file("t.ply")) + slurp(folder.file("s.json"));
  };
  const std::string first = bytes("3", "1");
  EXPECT_TRUE(first == bytes("3", "1"));
  EXPECT_TRUE(first == bytes("3", "2"));
  EXPECT_FALSE(first == bytes("4", "2"));
}

TEST(RemeshCommand, InitStartsWhereSitesEnded) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), sites = folder.file("sites.json");
  const std::string first_report = folder.file("1.json"), second_report = folder.file("2.json");
  ASSERT_EQ(run({"remesh", input, "-n", "100", "-o", folder.file("1.off"), "--sites", sites,
                 "--tolerance", "1e-2", "--report", first_report})
                .status,
            0);
  const nlohmann::json first = read_json(first_report);
  ASSERT_EQ(first["remesh"]["sites_added"], 0);
  const Outcome outcome = run({"remesh", input, "-o", folder.file("2.off"), "--init", sites,
                               "--tolerance", "2e-2", "--report", second_report});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const nlohmann::json second = read_json(second_report);
  EXPECT_EQ(second["cvt"]["iterations"], 0);
  EXPECT_EQ(second["remesh"]["vertices"], 100);
  const double before = first["cvt"]["energy"].back(), after = second["cvt"]["energy"][0];
  EXPECT_GT(first["cvt"]["energy"][0], (1 + 1e-6) * before);  // so that near means something
  EXPECT_NEAR(after, before, 1e-9 * before);

  const Outcome other = run({"remesh", input, "-n", "99", "--tolerance", "0.01", "-o",
                             folder.file("3.off"), "--init", sites});
  EXPECT_EQ(other.status, 2);
  EXPECT_HAS(only_line(other.err), sites + ": there are 100 sites, but -n asks for 99");
}

TEST(RemeshCommand, InitThatIsNoSitesFileIsRefused) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder);
  const auto start_from = [&](const std::string& bytes) {
    const std::string sites = folder.write("sites.json", bytes);
    const Outcome outcome = run({"remesh", input, "-o", folder.file("o.off"), "--init", sites});
    EXPECT_EQ(outcome.status, 3) << bytes;
    EXPECT_FALSE(std::filesystem::exists(folder.file("o.off")));
    return only_line(outcome.err);
  };
  EXPECT_HAS(start_from("no json"), "sites.json: ");
  EXPECT_HAS(start_from("{}"), "sites.json: ");
  EXPECT_HAS(start_from(R"({"sites": [{"face": 100000000, "bary": [1, 0, 0]}]})"), "100000000");
  const Outcome missing =
      run({"remesh", input, "-o", folder.file("o.off"), "--init", folder.file("none.json")});
  EXPECT_EQ(missing.status, 1);
  EXPECT_HAS(only_line(missing.err), "none.json: ");
}

TEST(RemeshCommand, StoppingAtTheAskedIterationIsSaid) {
  const TemporaryFolder folder;
  const std::string output = folder.file("o.off");
  const Outcome outcome =
      run({"remesh", torus_file(folder), "-n", "100", "-o", output, "--iterations", "2"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_HAS(only_line(outcome.err), "did not converge in 2 iterations");
  EXPECT_HAS(outcome.out, "not converged");
  EXPECT_TRUE(std::filesystem::exists(output));
  const Outcome none =
      run({"remesh", torus_file(folder), "-n", "100", "-o", output, "--iterations", "0"});
  EXPECT_EQ(none.status, 0) << none.err;
}

TEST(RemeshCommand, StoppingAtTheDefaultLimitIsAFailureWithOutput) {
  const TemporaryFolder folder;
  const std::string output = folder.file("o.off");
  const Outcome outcome = run(
      {"remesh", torus_file(folder), "-n", "30", "-o", output, "--tolerance", "1e-300", "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), "did not converge in 1000 iterations");
  EXPECT_TRUE(std::filesystem::exists(output));
}

TEST(RemeshCommand, FarthestSitesAreAStartToo) {
  const TemporaryFolder folder;
  const std::string output = folder.file("o.off");
  const Outcome outcome = run({"remesh", torus_file(folder), "-n", "100", "--tolerance", "0.01",
                               "-o", output, "--init", "farthest"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(closed_surface(read_mesh(output)).genus, 1);
}

TEST(RemeshCommand, TurnedFacesAreSaid) {
  const TemporaryFolder folder;
  TriangleMesh mesh = grid_surface(20, 12);
  std::swap(mesh.faces[5][0], mesh.faces[5][1]);
  const std::string input = folder.file("turned.obj"), output = folder.file("o.off");
  write_mesh(input, mesh);
  const Outcome outcome = run({"remesh", input, "-n", "40", "--tolerance", "0.01", "-o", output});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(only_line(outcome.err),
            "ucvt: " + input + ": turned 1 of 480 faces round to agree with its neighbours\n");
  EXPECT_EQ(run({"remesh", input, "-n", "40", "--tolerance", "0.01", "-o", output, "--quiet"}).err,
            "");
}

TEST(RemeshCommand, AddedSitesAreSaid) {
  const TemporaryFolder folder;
  const std::string input = torus_file(folder), output = folder.file("o.off");
  const Outcome outcome = run({"remesh", input, "-n", "3", "--tolerance", "0.01", "-o", output});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_HAS(only_line(outcome.err), "so that the mesh is simplicial");
  EXPECT_EQ(closed_surface(read_mesh(output)).genus, 1);
  const Outcome bare = run(
      {"remesh", input, "-n", "3", "--tolerance", "0.01", "-o", output, "--no-ensure-simplicial"});
  EXPECT_EQ(bare.status, 0);
  EXPECT_HAS(only_line(bare.err), "not simplicial");
  EXPECT_EQ(read_mesh(output).positions.size(), 3U);
}

TEST(RemeshCommand, VerboseTellsEveryIteration) {
  const TemporaryFolder folder;
  const Outcome outcome = run({"remesh", torus_file(folder), "-n", "40", "-o", folder.file("o.off"),
                               "--verbose", "--iterations", "3"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_HAS(outcome.err, "uniformize");
  EXPECT_HAS(outcome.err, "optimize    iteration    3");
}

TEST(RemeshCommand, BadInputIsOneLine) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& name, const std::string& bytes) {
    const std::string input = folder.write(name, bytes);
    const Outcome outcome =
        run({"remesh", input, "-n", "9", "--tolerance", "0.01", "-o", folder.file("o.off")});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder.file("o.off")));
    const std::string line = only_line(outcome.err);
    EXPECT_EQ(line.rfind("ucvt: " + input + ": ", 0), 0U) << line;
    EXPECT_HAS(line, "; ");
  };
  refused("empty.off", "");
  refused("words.off", "these are words");
  refused("pinched.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
  refused("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const std::string missing = folder.file("missing.off");
  const Outcome outcome =
      run({"remesh", missing, "-n", "9", "--tolerance", "0.01", "-o", folder.file("o.off")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), missing + ": cannot open the file");
}

TEST(RemeshCommand, TakesSurfacesWithBoundary) {
  const TemporaryFolder folder;
  TriangleMesh mesh = grid_surface(20, 12);
  mesh.faces.pop_back();
  write_mesh(folder.file("open.off"), mesh);
  const std::vector<std::string> asked{
      "remesh", folder.file("open.off"), "-n", "100", "--tolerance", "0.01", "-o"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = asked;
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const Outcome outcome = with({folder.file("out.off"), "--report", folder.file("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_HAS(outcome.out, "1 loop\n");
  const OpenSurface surface = open_surface(read_mesh(folder.file("out.off")));
  EXPECT_EQ(surface.genus, 1);
  EXPECT_EQ(surface.boundary_loops, 1);
  EXPECT_EQ(surface.mesh.positions.size(), 100U);
  const nlohmann::json report = nlohmann::json::parse(slurp(folder.file("r.json")));
  EXPECT_EQ(report["remesh"]["genus"], 1);
  EXPECT_EQ(report["remesh"]["boundary_loops"], 1);

  const Outcome random = with({folder.file("no.off"), "--init", "random"});
  EXPECT_EQ(random.status, 3);
  EXPECT_HAS(only_line(random.err), "the surface is open, where there is no --init random");
  EXPECT_FALSE(std::filesystem::exists(folder.file("no.off")));
}

TEST(RemeshCommand, TooFewSitesAreRefused) {
  const TemporaryFolder folder;
  const std::string input = folder.file("tetrahedron.off");
  write_mesh(input, tetrahedron());
  const Outcome outcome =
      run({"remesh", input, "-n", "3", "--tolerance", "0.01", "-o", folder.file("o.off")});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_HAS(only_line(outcome.err), "too few");
}

}  // namespace
}  // namespace ucvt::test
