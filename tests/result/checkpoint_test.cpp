#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/limbs.h"
#include "oracle/meshes.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

/// A run and its states at all its restart points.
struct Recorded {
  RemeshResult result;
  std::vector<SavedSites> states;
};

Recorded record(const ClosedSurface& surface, RemeshOptions options) {
  std::vector<SavedSites> states;
  options.checkpoint = [&](const SavedSites& state) { states.push_back(state); };
  RemeshResult result = remesh(surface, options);
  return {std::move(result), std::move(states)};
}

void expect_same(const RemeshResult& a, const RemeshResult& b) {
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.faces, b.mesh.faces);
  ASSERT_EQ(a.sites.size(), b.sites.size());
  for (std::size_t i = 0; i < a.sites.size(); ++i) {
    EXPECT_EQ(a.sites[i].face, b.sites[i].face);
    EXPECT_EQ(a.sites[i].bary, b.sites[i].bary);
  }
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.cvt.energy, b.cvt.energy);
  EXPECT_EQ(a.cvt.max_move, b.cvt.max_move);
  EXPECT_EQ(a.cvt.iterations, b.cvt.iterations);
  EXPECT_EQ(a.cvt.converged, b.cvt.converged);
  EXPECT_EQ(a.report.sites_added, b.report.sites_added);
}

/// Goes on from every state, through a file, and expects what the whole run gave.
void expect_resumable(const ClosedSurface& surface, const RemeshOptions& options,
                      std::size_t least_states) {
  const Recorded whole = record(surface, options);
  EXPECT_GE(whole.states.size(), least_states);
  const std::string path =
      (std::filesystem::temp_directory_path() /
       ("ucvt-checkpoint-test-" +
        std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
        ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".json"))
          .string();
  for (const SavedSites& state : whole.states) {
    SCOPED_TRACE(state.progress->evenings_left);
    SCOPED_TRACE(state.progress->iterations);
    write_sites(path, state);
    RemeshOptions resumed = options;
    start_from(resumed, read_sites(path));
    expect_same(remesh(surface, resumed), whole.result);
  }
  std::filesystem::remove(path);
}

TEST(Checkpoint, LevelsAndLegsGoOnToTheSameBits) {
  RemeshOptions options;
  options.sites = 700, options.tolerance = 1e-300, options.iterations = 250;
  expect_resumable(oracle::closed(oracle::bumpy(oracle::icosphere(2), 0.05, 3)), options, 3);
}

TEST(Checkpoint, EvenedSizesGoOnToTheSameBits) {
  RemeshOptions options;
  options.sites = 100, options.iterations = 40;
  expect_resumable(oracle::closed(oracle::capped_cylinder(4, 8)), options, 8);
}

TEST(Checkpoint, LloydGoesOnToTheSameBits) {
  RemeshOptions options;
  options.sites = 60, options.tolerance = 1e-9, options.iterations = 250;
  options.method = Method::Lloyd;
  expect_resumable(oracle::closed(oracle::grid_torus(12, 8)), options, 2);
}

TEST(Checkpoint, RoundsOfMakingRoomGoOnToTheSameBits) {
  RemeshOptions options;
  const ClosedSurface frame = oracle::closed(oracle::voxel_frame(3));
  options.sites = 20, options.tolerance = 1e-3;
  expect_resumable(frame, options, 2);
  // Slow enough for restart points within the optimisations before and after the rounds.
  options.sites = 10, options.tolerance = 1e-9, options.iterations = 250;
  options.method = Method::Lloyd;
  expect_resumable(frame, options, 5);
}

TEST(Checkpoint, ProgressThatDoesNotFitIsRefused) {
  const ClosedSurface surface = oracle::closed(oracle::grid_torus(12, 8));
  RemeshOptions options;
  options.sites = 200, options.iterations = 120, options.tolerance = 1e-9;
  const Recorded whole = record(surface, options);
  ASSERT_FALSE(whole.states.empty());
  const auto refuse = [&](auto change) {
    SavedSites state = whole.states.front();
    change(state);
    RemeshOptions resumed = options;
    start_from(resumed, std::move(state));
    EXPECT_THROW(remesh(surface, resumed), InvalidInput);
  };
  refuse([](SavedSites& s) { s.progress->moved = -1; });
  refuse([](SavedSites& s) { s.progress->moved = 1'000'000; });
  refuse([](SavedSites& s) { s.progress->evenings_left = 1, s.progress->sites = 10; });
  refuse([](SavedSites& s) { s.progress->evaluations = -1; });
  refuse([](SavedSites& s) { s.size.pop_back(); });
  refuse([](SavedSites& s) { s.sites.clear(); });
}

}  // namespace
}  // namespace ucvt
