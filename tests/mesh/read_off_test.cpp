#include <cstring>

#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

const std::string body = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

void expect_tetrahedron(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.positions, tetrahedron().positions);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

TEST(ReadOff, TakesEveryDress) {
  const std::string plain = "OFF\n4 4 6\n" + body;
  expect_tetrahedron(read_bytes("a.off", plain));
  expect_tetrahedron(read_bytes("no_extension", plain));
  expect_tetrahedron(read_bytes("wrong.obj", plain));
  expect_tetrahedron(read_bytes("a.off", "4 4 6\n" + body));
  expect_tetrahedron(read_bytes("a.off", "OFF 4 4 6\n" + body));
  expect_tetrahedron(read_bytes("a.off", "\t OFF4 4 6 # or nah\n" + body));
  expect_tetrahedron(read_bytes("a.off", "OFF\n4 4\n" + body));
  expect_tetrahedron(read_bytes("a.off", "\xef\xbb\xbf" + plain));
  expect_tetrahedron(read_bytes("a.off", "# c\n\nOFF # c\n#\n4 4 6\n\n# d\n" + body));
  expect_tetrahedron(read_bytes("a.off", replaced(plain, "\n", "\r\n")));
  expect_tetrahedron(read_bytes("a.off", replaced(plain, "\n", "\r")));
  expect_tetrahedron(read_bytes("a.off", replaced(plain, "\n", " ")));
  expect_tetrahedron(read_bytes("a.off", replaced(plain, " ", "\t  ")));
  expect_tetrahedron(read_bytes("a.off", plain.substr(0, plain.size() - 1)));
}

TEST(ReadOff, SkipsColoursNormalsAndTextures) {
  const std::string colours = "0 0 0 255 0 0 255\n1 0 0 9 9 9 9\n0 1 0 1 1 1 1\n0 0 1 0 0 0 0\n";
  const std::string faces = "3 0 2 1 0.5 0.5 0.5\n3 0 1 3 7\n3 1 2 3\n3 0 3 2 1 1 1 1\n";
  expect_tetrahedron(read_bytes("a.off", "COFF\n4 4 6\n" + colours + faces));
  expect_tetrahedron(read_bytes("a.off", "OFF\n4 4 6\n" + colours + faces));
  const std::string all =
      "0 0 0  0 0 1 1 1 1 1 .5 .5\n1 0 0  0 0 1 1 1 1 1 .5 .5\n"
      "0 1 0  0 0 1 1 1 1 1 .5 .5\n0 0 1  0 0 1 1 1 1 1 .5 .5\n";
  expect_tetrahedron(read_bytes("a.off", "STCNOFF\n4 4 6\n" + all + faces));
  const std::string stream = replaced(
      "NOFF 4 4 6 0 0 0 1 2 3 1 0 0 1 2 3 0 1 0 1 2 3 0 0 1 1 2 3 "
      "3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2",
      "\n", " ");
  expect_tetrahedron(read_bytes("a.off", stream));
}

std::string binary_tetrahedron(bool big, bool colours) {
  std::string bytes = "OFF BINARY\n";
  const auto put = [&](auto value) {
    char raw[4];
    std::memcpy(raw, &value, 4);
    if (big) {
      std::swap(raw[0], raw[3]), std::swap(raw[1], raw[2]);
    }
    bytes.append(raw, 4);
  };
  for (const std::int32_t count : {4, 4, 6}) {
    put(count);
  }
  for (const Position& p : tetrahedron().positions) {
    for (const double c : p) {
      put(static_cast<float>(c));
    }
  }
  for (const Corners& f : tetrahedron().faces) {
    put(std::int32_t{3});
    for (const std::int32_t v : f) {
      put(v);
    }
    if (colours) {
      put(std::int32_t{0});
    }
  }
  return bytes;
}

TEST(ReadOff, TakesBinaryInEitherByteOrder) {
  for (const bool big : {true, false}) {
    for (const bool colours : {true, false}) {
      expect_tetrahedron(read_bytes("a.off", binary_tetrahedron(big, colours)));
    }
  }
  const std::string bytes = binary_tetrahedron(true, true);
  EXPECT_HAS(read_refusal("a.off", bytes.substr(0, bytes.size() - 3)), "binary OFF");
}

TEST(ReadOff, NamesTheFaultAndTheLine) {
  EXPECT_HAS(read_refusal("a.off", ""), "empty");
  EXPECT_HAS(read_refusal("a.off", "OFF\n"), "ends before the number of vertices");
  EXPECT_HAS(read_refusal("a.off", "OFF\nthis is not a mesh\n"), "'this' (line 2)");
  EXPECT_HAS(read_refusal("a.off", "OFF\n0 0 0\n"), "no faces");
  EXPECT_HAS(read_refusal("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"), "4000000000 vertices");
  EXPECT_HAS(read_refusal("a.off", "OFF\n9223372036854775807 99999999999999999999 0\n0 0 0\n"),
             "only 7 bytes");
  EXPECT_HAS(read_refusal("a.off", "OFF\n4 4 6\n" + body.substr(0, 40)), "ends in face 2 of 4");
  EXPECT_HAS(read_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
             "vertex 1 has coordinate y = nan (line 4)");
  EXPECT_HAS(read_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 1e400 0\n0 1 0\n3 0 1 2\n"), "y = inf");
  EXPECT_HAS(read_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n"), "'1,5'");
  EXPECT_HAS(read_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
             "face 0 has vertex index 3, but there are 3 vertices (line 6)");
  EXPECT_HAS(read_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "index -1");
  EXPECT_HAS(read_refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
             "face 0 has 2 corners (line 6)");
  EXPECT_HAS(read_refusal("a.off", "4OFF\n3 1 0\n0 0 0 0\n"), "'4OFF'");
  EXPECT_HAS(read_refusal("a.off", "nOFF\n4\n3 1 0\n0 0 0 0\n"), "'nOFF'");
}

TEST(ReadOff, TooSmallNumbersAreZero) {
  const auto mesh = read_bytes("a.off", "OFF\n3 1 0\n1e-400 -0 +5\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(mesh.positions[0], (Position{0, 0, 5}));
  EXPECT_TRUE(std::signbit(mesh.positions[0][1]));
}

}  // namespace
}  // namespace ucvt::test
