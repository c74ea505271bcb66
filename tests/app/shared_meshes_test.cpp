// Runs over the shared collection of broken meshes, where there is one: the folder named by the
// environment variable UCVT_SHARED_MESHES.
#include <cstdlib>

#include "run_program.h"
#include "ucvt/components.h"

namespace ucvt::test {
namespace {

bool is_refused(const std::string& path) {
  try {
    const TriangleMesh mesh = read_mesh(path);
    if (has_boundary(mesh)) {
      open_surface(mesh);
    } else {
      closed_components(mesh);
    }
  } catch (const InvalidInput&) {
    return true;
  }
  return false;
}

TEST(SharedMeshes, RefusedOnesAreStatusThreeAndOneLine) {
  const char* const meshes = std::getenv("UCVT_SHARED_MESHES");
  if (meshes == nullptr) {
    GTEST_SKIP() << "set UCVT_SHARED_MESHES to the folder of shared meshes";
  }
  const TemporaryFolder folder;
  int tried = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(meshes) / "bad")) {
    const std::string path = entry.path().string();
    if (!is_refused(path)) {
      continue;
    }
    SCOPED_TRACE(path);
    const Outcome outcome = run({"remesh", path, "-n", "50", "-o", folder.file("o.off")});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_HAS(only_line(outcome.err), path + ": ");
    EXPECT_EQ(folder.entries(), 0U);
    ++tried;
  }
  EXPECT_GT(tried, 20);
}

/// Needles between fine and coarse parts: refinement ends only if the longest edge is split first.
TEST(SharedMeshes, RefinementOfNeedlesEnds) {
  const char* const meshes = std::getenv("UCVT_SHARED_MESHES");
  if (meshes == nullptr) {
    GTEST_SKIP() << "set UCVT_SHARED_MESHES to the folder of shared meshes";
  }
  const TemporaryFolder folder;
  const std::string femur = (std::filesystem::path(meshes) / "genus2" / "femur.off").string();
  const Outcome outcome = run({"remesh", femur, "-n", "1000", "--iterations", "0", "--time-limit",
                               "100", "-o", folder.file("o.off")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

}  // namespace
}  // namespace ucvt::test
