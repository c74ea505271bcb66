#include <algorithm>
#include <cstring>

#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

const std::string vertex_element =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face_element = "element face 4\nproperty list uchar int vertex_indices\n";
const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

void expect_tetrahedron(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.positions, tetrahedron().positions);
  EXPECT_EQ(mesh.faces, tetrahedron().faces);
}

std::string ascii(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\ncomment made by a test\n" + header + "end_header\n" + body;
}

template <typename T>
void put(std::string& bytes, bool big, double value) {
  const T number = static_cast<T>(value);
  char raw[sizeof(T)];
  std::memcpy(raw, &number, sizeof(T));
  if (big) {
    std::reverse(raw, raw + sizeof(T));
  }
  bytes.append(raw, sizeof(T));
}

std::string binary(bool big) {
  std::string bytes = std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\r\nelement camera 1\r\nproperty list short uchar name\r\n"
                      "element vertex 4\r\nproperty uchar red\r\nproperty double z\r\n"
                      "property short x\r\nproperty float y\r\nelement face 4\r\n"
                      "property int flags\r\nproperty list uint ushort vertex_index\r\n"
                      "property list uchar double texcoord\r\nend_header\r\n";
  put<std::int16_t>(bytes, big, 3);
  bytes += "abc";
  for (const Position& p : tetrahedron().positions) {
    put<std::uint8_t>(bytes, big, 200);
    put<double>(bytes, big, p[2]);
    put<std::int16_t>(bytes, big, p[0]);
    put<float>(bytes, big, p[1]);
  }
  for (const Corners& f : tetrahedron().faces) {
    put<std::int32_t>(bytes, big, -7);
    put<std::uint32_t>(bytes, big, 3);
    for (const std::int32_t v : f) {
      put<std::uint16_t>(bytes, big, v);
    }
    put<std::uint8_t>(bytes, big, 2);
    for (int i = 0; i < 2; ++i) {
      put<double>(bytes, big, 0.5);
    }
  }
  return bytes;
}

TEST(ReadPly, TakesAscii) {
  expect_tetrahedron(read_bytes("a.ply", ascii(vertex_element + face_element, vertices + faces)));
  expect_tetrahedron(read_bytes("a", ascii(face_element + vertex_element, faces + vertices)));
  expect_tetrahedron(read_bytes(
      "a.ply", ascii(vertex_element + "property uchar red\nelement edge 1\nproperty int a\n" +
                         face_element + "property float quality\n",
                     "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n77\n3 0 2 1 .5\n3 0 1 3 .5\n3 1 2 3 "
                     ".5\n3 0 3 2 .5\n")));
}

TEST(ReadPly, TakesBothByteOrdersAnyTypesAndExtraProperties) {
  expect_tetrahedron(read_bytes("a.ply", binary(false)));
  expect_tetrahedron(read_bytes("a.ply", binary(true)));
}

TEST(ReadPly, TakesTriangleStrips) {
  const auto mesh = read_bytes(
      "a.ply", ascii(vertex_element + "element tristrips 1\nproperty list int int vertex_indices\n",
                     vertices + "8 0 1 2 3 -1 1 0 3\n"));
  EXPECT_EQ(mesh.faces, (std::vector<Corners>{{0, 1, 2}, {2, 1, 3}, {1, 0, 3}}));
}

TEST(ReadPly, EveryTruncationIsRefused) {
  for (const std::string& whole :
       {binary(true), ascii(vertex_element + face_element, vertices + faces)}) {
    for (std::size_t size = 4; size + 4 < whole.size(); ++size) {
      EXPECT_THROW(read_bytes("a.ply", whole.substr(0, size)), InvalidInput) << size;
    }
  }
}

TEST(ReadPly, NamesTheFaultAndThePlace) {
  EXPECT_HAS(read_refusal("a.ply", ascii("", "")), "no vertex element");
  EXPECT_HAS(read_refusal("a.ply", ascii(vertex_element, vertices)), "no faces");
  EXPECT_HAS(
      read_refusal("a.ply", ascii(vertex_element + face_element, vertices + "3 0 2 4\n" + faces)),
      "face 0 has vertex index 4, but there are 4 vertices (line 15)");
  EXPECT_HAS(read_refusal("a.ply", ascii(vertex_element + face_element,
                                         "0 0 0\n1 nan 0\n0 1 0\n0 0 1\n" + faces)),
             "vertex 1 has coordinate y = nan (line 12)");
  EXPECT_HAS(
      read_refusal("a.ply", ascii(vertex_element + face_element, vertices + "2 0 2\n" + faces)),
      "face 0 has 2 corners (line 15)");
  EXPECT_HAS(read_refusal("a.ply", ascii("element vertex 4000000000\nproperty float x\n", "")),
             "declares 4000000000");
  EXPECT_HAS(read_refusal("a.ply", ascii("element vertex 1\nproperty quad x\n", "1")), "'quad'");
  EXPECT_HAS(read_refusal("a.ply", ascii("element vertex 1\nproperty float x\n", "12")),
             "no property y");
  EXPECT_HAS(read_refusal("a.ply", "ply\nformat binary 1.0\nend_header\n"), "'binary'");
  const std::string whole = binary(false);
  EXPECT_HAS(read_refusal("a.ply", whole.substr(0, whole.size() - 30)), "(byte ");
}

}  // namespace
}  // namespace ucvt::test
