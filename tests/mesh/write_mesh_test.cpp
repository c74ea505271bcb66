#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

TEST(WriteMesh, RoundTripsExactly) {
  TriangleMesh mesh = grid_surface(5, 4);
  mesh.positions[0] = {0.1, -1.0 / 3, 5e-324};
  mesh.positions[1] = {1.7976931348623157e308, -1e-300, 123456789.123456789};
  for (const char* name : {"a.obj", "a.off", "a.ply", "A.PLY"}) {
    const TemporaryFolder folder;
    write_mesh(folder.file(name), mesh);
    const TriangleMesh back = read_mesh(folder.file(name));
    EXPECT_EQ(back.positions, mesh.positions) << name;
    EXPECT_EQ(back.faces, mesh.faces) << name;
    EXPECT_EQ(folder.entries(), 1U);
  }
}

TEST(WriteMesh, StlKeepsFloats) {
  TriangleMesh mesh = grid_surface(5, 4);
  for (Position& p : mesh.positions) {
    for (double& c : p) {
      c = static_cast<double>(static_cast<float>(c));
    }
  }
  const TemporaryFolder folder;
  write_mesh(folder.file("a.stl"), mesh);
  EXPECT_EQ(slurp(folder.file("a.stl")).size(), 84 + 50 * mesh.faces.size());
  const TriangleMesh back = read_mesh(folder.file("a.stl"));
  ASSERT_EQ(back.faces.size(), mesh.faces.size());
  ASSERT_EQ(back.positions.size(), mesh.positions.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(back.positions[static_cast<std::size_t>(back.faces[f][i])],
                mesh.positions[static_cast<std::size_t>(mesh.faces[f][i])]);
    }
  }
}

TEST(WriteMesh, RefusesWhatItCannotWriteAndLeavesNothing) {
  const TemporaryFolder folder;
  TriangleMesh mesh = tetrahedron();
  EXPECT_HAS(refusal([&] { write_mesh(folder.file("a.xyz"), mesh); }), "'.xyz'");
  EXPECT_HAS(refusal([&] { write_mesh(folder.file("a"), mesh); }), ".obj");
  mesh.positions[2][0] = 1e39;
  EXPECT_HAS(refusal([&] { write_mesh(folder.file("a.stl"), mesh); }), "vertex 2");
  EXPECT_THROW(write_mesh(folder.file("none/a.off"), mesh), IoError);
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace ucvt::test
