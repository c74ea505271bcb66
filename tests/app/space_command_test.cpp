#include <algorithm>
#include <sstream>

#include "run_program.h"

namespace ucvt::test {
namespace {

using Names = std::vector<std::string>;

Names joined(Names first, const Names& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

const std::vector<Names>& commands() {
  static const std::vector<Names> all = {
      {"sphere"},
      {"plane"},
      {"plane", "--domain", "regular:5:3"},
      {"torus"},
      {"torus", "--lattice", "hexagonal"},
      {"torus", "--lattice", "1,0.2:-0.3,2"},
      {"hyperbolic"},
      {"hyperbolic", "--domain", "surface:2"},
      {"hyperbolic", "--domain", "surface:2:canonical", "--coordinates", "poincare"}};
  return all;
}

TEST(SpaceCommand, WritesEverything) {
  for (const Names& command : commands()) {
    SCOPED_TRACE(command.back());
    const TemporaryFolder folder;
    const Outcome outcome = run(joined(command, {"-n",
                                                 "40",
                                                 "--iterations",
                                                 "10",
                                                 "-o",
                                                 folder.file("m.ply"),
                                                 "--cells",
                                                 folder.file("c.vtu"),
                                                 "--csv",
                                                 folder.file("c.csv"),
                                                 "--sites",
                                                 folder.file("s.json"),
                                                 "--figure",
                                                 folder.file("f.svg"),
                                                 "--centroids",
                                                 "--figure-cells",
                                                 "area",
                                                 "--plot-energy",
                                                 folder.file("e.svg"),
                                                 "--plot-uniformity",
                                                 folder.file("u.svg"),
                                                 "--report",
                                                 folder.file("r.json")}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_HAS(only_line(outcome.err), "did not converge in 10 iterations");
    EXPECT_HAS(outcome.out, "hexagons");
    EXPECT_EQ(folder.entries(), 8U);
    const TriangleMesh mesh = read_mesh(folder.file("m.ply"));
    EXPECT_GE(mesh.positions.size(), 40U);
    EXPECT_EQ(read_json(folder.file("s.json"))["sites"].size(), 40U);
    for (const char* name : {"f.svg", "e.svg", "u.svg"}) {
      EXPECT_HAS(slurp(folder.file(name)), "</svg>");
    }
    std::istringstream table(slurp(folder.file("c.csv")));
    std::string line;
    std::int64_t lines = 0;
    while (std::getline(table, line)) {
      ++lines;
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), 10) << line;
    }
    EXPECT_EQ(lines, 41);
  }
}

TEST(SpaceCommand, ReportSaysWhatWasDone) {
  for (const auto& [command, kappa, energies] :
       std::vector<std::tuple<Names, int, Names>>{{{"sphere"}, 1, {"F_S_max", "F_S_min"}},
                                                  {{"torus"}, 0, {"F_E"}},
                                                  {{"hyperbolic"}, -1, {"F_H"}}}) {
    const TemporaryFolder folder;
    const std::string file = folder.file("r.json");
    ASSERT_EQ(run(joined(command, {"-n", "50", "--tolerance", "1e-2", "--report", file, "--seed",
                                   "7", "--threads", "2"}))
                  .status,
              0);
    const nlohmann::json report = read_json(file);
    for (const char* key : {"space", "cvt", "initial_uniformity", "uniformity", "quadrature_error",
                            "seconds", "peak_memory_bytes", "version", "seed", "threads"}) {
      EXPECT_TRUE(report.contains(key)) << key;
    }
    EXPECT_EQ(report.size(), 10U) << report.dump();
    EXPECT_EQ(report["space"]["kappa"], kappa);
    EXPECT_EQ(report["space"]["genus"].is_null(), kappa < 0);
    const nlohmann::json& cvt = report["cvt"];
    EXPECT_EQ(cvt["method"], "lbfgs");
    EXPECT_EQ(cvt["sites"], 50);
    EXPECT_EQ(cvt["converged"], true);
    const std::size_t states = cvt["energy"].size();
    EXPECT_EQ(cvt["max_move"].size(), states);
    EXPECT_LE(states, cvt["iterations"].get<std::size_t>() + 1);
    EXPECT_EQ(cvt["paper_energy"].size(), energies.size());
    const double energy = cvt["energy"].back(), area = report["space"]["area"];
    for (const std::string& name : energies) {
      ASSERT_EQ(cvt["paper_energy"][name].size(), states) << name;
      const double sign = name == "F_S_max" ? -1 : 1;
      const double expected = kappa == 0 ? energy : sign * (energy / 2 - kappa * area);
      EXPECT_NEAR(cvt["paper_energy"][name].back(), expected, 1e-9 * area) << name;
    }
    EXPECT_NEAR(cvt["energy_over_hexagonal"].get<double>(), 1.02, 0.1);
    EXPECT_LT(report["uniformity"]["area"]["cv"], report["initial_uniformity"]["area"]["cv"]);
    EXPECT_EQ(report["seed"], 7);
    EXPECT_EQ(report["threads"], 2);
  }
}

TEST(SpaceCommand, MethodAndStartAreChosen) {
  const TemporaryFolder folder;
  const auto report = [&](const Names& options) {
    const Outcome outcome = run(joined(
        {"sphere", "-n", "300", "--iterations", "5", "--quiet", "--report", folder.file("r.json")},
        options));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_json(folder.file("r.json"));
  };
  const auto usual = report({}), chosen = report({"--method", "lbfgs", "--init", "multilevel"}),
             lloyd = report({"--method", "lloyd", "--init", "random"});
  EXPECT_EQ(usual["cvt"]["energy"], chosen["cvt"]["energy"]);
  EXPECT_EQ(lloyd["cvt"]["method"], "lloyd");
  EXPECT_EQ(lloyd["cvt"]["energy"].size(), 6U);
  EXPECT_GT(usual["initial_uniformity"]["hexagons"], 0.8);
  EXPECT_LT(lloyd["initial_uniformity"]["hexagons"], 0.5);
}

TEST(SpaceCommand, SameSeedSameBytes) {
  for (const Names& command : commands()) {
    SCOPED_TRACE(command.back());
    const TemporaryFolder folder;
    const auto bytes = [&](const std::string& seed, const std::string& threads) {
      const Outcome outcome = run(joined(command, {"-n",
                                                   "60",
                                                   "--iterations",
                                                   "8",
                                                   "--quiet",
                                                   "--density",
                                                   "1+x^2",
                                                   "--quadrature",
                                                   "1e-3",
                                                   "-o",
                                                   folder.file("m.ply"),
                                                   "--cells",
                                                   folder.file("c.vtu"),
                                                   "--csv",
                                                   folder.file("c.csv"),
                                                   "--sites",
                                                   folder.file("s.json"),
                                                   "--figure",
                                                   folder.file("f.svg"),
                                                   "--seed",
                                                   seed,
                                                   "--threads",
                                                   threads}));
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.out + outcome.err, "");
      std::string all;
      for (const char* name : {"m.ply", "c.vtu", "c.csv", "s.json", "f.svg"}) {
        all += slurp(folder.file(name));
      }
      return all;
    };
    const std::string first = bytes("3", "1");
    EXPECT_TRUE(first == bytes("3", "2"));
    EXPECT_FALSE(first == bytes("4", "2"));
  }
}

TEST(SpaceCommand, InitContinues) {
  for (const Names& command : commands()) {
    SCOPED_TRACE(command.back());
    const TemporaryFolder folder;
    const std::string sites = folder.file("s.json"), report = folder.file("r.json");
    ASSERT_EQ(run(joined(command, {"-n", "40", "--iterations", "5", "--sites", sites, "--report",
                                   report, "--quiet"}))
                  .status,
              0);
    const double before = read_json(report)["cvt"]["energy"].back();
    const Outcome outcome =
        run(joined(command, {"--init", sites, "--iterations", "5", "--report", report, "--quiet"}));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const nlohmann::json energy = read_json(report)["cvt"]["energy"];
    EXPECT_NEAR(energy[0].get<double>(), before, 1e-9 * before);
    EXPECT_LT(energy.back().get<double>(), before);
    const Outcome other = run(joined(command, {"--init", sites, "-n", "39"}));
    EXPECT_EQ(other.status, 2);
    EXPECT_HAS(only_line(other.err), "there are 40 sites, but -n asks for 39");
  }
}

TEST(SpaceCommand, InitThatDoesNotFitIsRefused) {
  const TemporaryFolder folder;
  const auto start_from = [&](const std::string& bytes) {
    const Outcome outcome =
        run({"torus", "--init", folder.write("sites.json", bytes), "--csv", folder.file("c.csv")});
    EXPECT_EQ(outcome.status, 3) << bytes;
    EXPECT_EQ(folder.entries(), 1U);
    return only_line(outcome.err);
  };
  EXPECT_HAS(start_from("no json"), "sites.json: is not JSON");
  EXPECT_HAS(start_from("[]"), "no list \"sites\"");
  EXPECT_HAS(start_from(R"({"sites": [[0, 0, 1]]})"), "no \"space\"");
  EXPECT_HAS(start_from(R"({"space": "sphere", "sites": [[0, 0, 1]]})"), "\"sphere\"");
  EXPECT_HAS(start_from(R"({"space": "torus", "sites": [[0, 0, 1], [0, 0]]})"), "site 1 ");
  EXPECT_HAS(start_from(R"({"space": "torus", "sites": []})"), "empty list");
  EXPECT_HAS(start_from(R"({"space": "torus", "sites": [[7, 0, 1]]})"), "initial site 0");
}

TEST(SpaceCommand, TheMeshOfTheSphereIsClosed) {
  const TemporaryFolder folder;
  for (const std::string extension : {"obj", "off", "ply", "stl"}) {
    const std::string mesh = folder.file("m." + extension);
    ASSERT_EQ(run({"sphere", "-n", "60", "--iterations", "5", "--quiet", "-o", mesh}).status, 0);
    const Outcome info = run({"info", mesh, "--report", folder.file("r.json")});
    ASSERT_EQ(info.status, 0) << info.err;
    const nlohmann::json report = read_json(folder.file("r.json"));
    EXPECT_EQ(report["input"]["genus"], 0);
    EXPECT_EQ(report["input"]["faces"], 116);
    EXPECT_EQ(report["faults"]["reoriented_faces"], 0);
    EXPECT_TRUE(report["acceptable"]);
  }
}

TEST(SpaceCommand, ACommandWithoutOutputsPrintsTheSummary) {
  const Outcome outcome = run({"torus", "-n", "30", "--tolerance", "0.01"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_HAS(outcome.out, "torus square");
  EXPECT_HAS(outcome.out, "of regular hexagons");
  const Outcome piped = run({"sphere", "-n", "30", "--iterations", "2", "-o", "-", "--quiet"});
  EXPECT_EQ(piped.out.rfind("OFF\n30 56 0\n", 0), 0U) << piped.out;
}

TEST(SpaceCommand, WhatCannotBeComputedIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const Names& arguments) {
    const Outcome outcome = run(
        joined(arguments, {"--sites", folder.file("s.json"), "--report", folder.file("r.json")}));
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_EQ(folder.entries(), 0U);
    return only_line(outcome.err);
  };
  EXPECT_HAS(refused({"sphere", "-n", "1"}), "too few");
  EXPECT_HAS(refused({"sphere", "-n", "9", "--density", "x"}), "at (x, y, z) = (-");
  EXPECT_HAS(refused({"sphere", "-n", "3", "-o", folder.file("m.obj")}), "no Delaunay triangle");
  EXPECT_HAS(refused({"plane", "-n", "2", "-o", folder.file("m.obj")}), "no Delaunay triangle");
}

TEST(SpaceCommand, StoppingAtTheDefaultLimitIsAFailureWithOutput) {
  const TemporaryFolder folder;
  const Outcome outcome = run(
      {"plane", "-n", "5", "--tolerance", "1e-300", "--sites", folder.file("s.json"), "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_HAS(only_line(outcome.err), "did not converge in 1000 iterations");
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(SpaceCommand, OutputsThatCannotBeWrittenLeaveNothing) {
  const TemporaryFolder folder;
  for (const char* option : {"-o", "--cells", "--csv", "--sites", "--figure", "--report"}) {
    const std::string extension = option == std::string("-o")         ? ".obj"
                                  : option == std::string("--cells")  ? ".vtu"
                                  : option == std::string("--csv")    ? ".csv"
                                  : option == std::string("--figure") ? ".svg"
                                                                      : ".json";
    const std::string missing = folder.file("none/file" + extension);
    const Outcome outcome = run({"sphere", "-n", "20", "--iterations", "2", option, missing,
                                 "--plot-energy", folder.file("e.svg")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_HAS(only_line(outcome.err), "ucvt: " + missing + ": ");
    EXPECT_EQ(folder.entries(), 0U);
  }
}

TEST(SpaceCommand, AnInterruptedRunLeavesNoFile) {
  const TemporaryFolder folder;
  Program program({"sphere", "-n", "500", "-o", folder.file("m.obj"), "--report",
                   folder.file("r.json"), "--tolerance", "1e-15", "--iterations", "1000000",
                   "--verbose"});
  ASSERT_TRUE(program.says("optimize"));
  program.send(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.err.ends_with("\nucvt: interrupted; no output was written\n"));
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(SpaceCommand, AJumpOfTheDensityIsSaid) {
  const Outcome outcome = run({"plane", "-n", "4", "--density", "x > 0.1", "--iterations", "0"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_HAS(outcome.err, "ucvt: plane: integrals of the density have relative errors up to ");
}

}  // namespace
}  // namespace ucvt::test
