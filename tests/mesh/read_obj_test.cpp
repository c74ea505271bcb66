#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

void expect_tetrahedron(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.positions, tetrahedron().positions);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

TEST(ReadObj, TakesEveryDress) {
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  expect_tetrahedron(read_bytes("a.obj", vertices + faces));
  expect_tetrahedron(read_bytes("no_extension", "# c\nmtllib none.mtl\n" + vertices + faces));
  expect_tetrahedron(read_bytes("a.obj", faces + vertices));
  expect_tetrahedron(
      read_bytes("a.obj", vertices + "vn 0 0 1\nvt 0 0\ng a b\nf 1//1 3//1 2//1\nf 1/1 2/1 4/1\n"
                                     "f 2/1/1 3/1/1 4/1/1\nf 1// 4// 3// # c\n"));
  expect_tetrahedron(
      read_bytes("a.obj", vertices + "f -4 -2 -3\nf -4//-1 -3 -1\nf -3 -2 -1\nf -4 -1 -2"));
  expect_tetrahedron(read_bytes("a.obj",
                                "v 0 0 0 1 .5 .2\r\nv\t1  0 0\r\nv 0 1 0\r\nv 0 0 1e0\r\n"
                                "f 1 3 \\\r\n 2\r\nf 1 2 4\r\nf 2 3\\\r\n4\r\nf 1 4 3\r\n"));
}

TEST(ReadObj, TakesUtf16) {
  const std::string text = vertices + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  std::string big = "\xfe\xff", little = "\xff\xfe";
  for (const char c : text) {
    big += {'\0', c};
    little += {c, '\0'};
  }
  expect_tetrahedron(read_bytes("a.obj", big));
  expect_tetrahedron(read_bytes("a.obj", little));
}

TEST(ReadObj, NumberFormats) {
  const auto mesh = read_bytes("a.obj", "v 3.1+e2 2.e-1 +1E+2\nv 1 0 .5\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], (Position{310, 0.2, 100}));
}

TEST(ReadObj, NamesTheFaultAndTheLine) {
  EXPECT_HAS(read_refusal("a.obj", vertices + "f 1 2\n"), "face 0 has 2 corners (line 5)");
  EXPECT_HAS(read_refusal("a.obj", vertices + "f 1 2 0\n"), "index 0 (line 5)");
  EXPECT_HAS(read_refusal("a.obj", vertices + "f 1 2 5\n"),
             "face 0 has vertex index 5, but there are 4 vertices (line 5)");
  EXPECT_HAS(read_refusal("a.obj", vertices + "f 1 2 -5\n"), "index -5");
  EXPECT_HAS(read_refusal("a.obj", vertices + "f 1 2 x\n"), "'x' (line 5)");
  EXPECT_HAS(read_refusal("a.obj", vertices + "f 1 2 3;4\n"), "'3;4'");
  EXPECT_HAS(read_refusal("a.obj", "v 0 0\n"), "fewer than three coordinates (line 1)");
  EXPECT_HAS(read_refusal("a.obj", "v 0 0 inf\n"), "z = inf (line 1)");
  EXPECT_HAS(read_refusal("a.obj", vertices), "no faces");
  EXPECT_HAS(read_refusal("a.obj", "hello\n"), "OBJ");
  EXPECT_HAS(read_refusal("a.obj", std::string("\x01\x02\0\x03garbage", 11)), "known format");
  EXPECT_HAS(read_refusal("a.obj", "version https://git-lfs.github.com/spec/v1\n"), "git lfs");
  EXPECT_HAS(read_refusal("a.ply", "\x1f\x8b\x08"), "gzip");
  EXPECT_HAS(read_refusal("a.txt", "hello\n"), "known format");
}

TEST(ReadMesh, MissingFileIsAnIoError) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_mesh(folder.file("none.obj")), IoError);
  EXPECT_THROW(read_mesh(folder.file("")), IoError);
}

}  // namespace
}  // namespace ucvt::test
