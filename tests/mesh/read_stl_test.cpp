#include <cstring>

#include "mesh_test_support.h"

namespace ucvt::test {
namespace {

std::string text_stl(const TriangleMesh& mesh) {
  std::string text = "solid a vertex facet\n";
  for (const Corners& f : mesh.faces) {
    text += "facet normal 0 0 nan\nouter loop\n";
    for (const std::int32_t v : f) {
      const Position& p = mesh.positions[static_cast<std::size_t>(v)];
      text += "vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " +
              std::to_string(p[2]) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid a\n";
}

std::string binary_stl(const TriangleMesh& mesh, std::string header) {
  header.resize(80, ' ');
  const auto put = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    header.append(raw, sizeof value);
  };
  put(static_cast<std::uint32_t>(mesh.faces.size()));
  for (const Corners& f : mesh.faces) {
    for (int i = 0; i < 3; ++i) {
      put(0.0F);
    }
    for (const std::int32_t v : f) {
      for (const double c : mesh.positions[static_cast<std::size_t>(v)]) {
        put(static_cast<float>(c));
      }
    }
    put(std::uint16_t{0});
  }
  return header;
}

TEST(ReadStl, WeldsTextAndBinary) {
  for (const std::string& bytes : {text_stl(tetrahedron()), binary_stl(tetrahedron(), "made"),
                                   binary_stl(tetrahedron(), "solid facet normal")}) {
    for (const char* name : {"a.stl", "no_extension"}) {
      const TriangleMesh mesh = read_bytes(name, bytes);
      EXPECT_EQ(mesh.positions.size(), 4U);
      EXPECT_EQ(mesh.faces.size(), 4U);
      EXPECT_EQ(closed_surface(mesh).genus, 0);
    }
  }
}

TEST(ReadStl, MinusZeroIsZero) {
  TriangleMesh mesh = tetrahedron();
  mesh.positions.push_back({-0.0, -0.0, -0.0});
  mesh.faces[0][0] = 4;
  EXPECT_EQ(read_bytes("a.stl", binary_stl(mesh, "")).positions.size(), 4U);
}

TEST(ReadStl, KeepsFacesThatWeldToARepeatedCorner) {
  TriangleMesh mesh = tetrahedron();
  mesh.faces.push_back({1, 2, 1});
  const TriangleMesh read = read_bytes("a.stl", binary_stl(mesh, ""));
  EXPECT_EQ(survey(read).repeated_corner_faces, 1);
  EXPECT_HAS(closed_refusal(read), "1 face has a repeated corner (first face 4: ");
}

TEST(ReadStl, NamesTheFault) {
  EXPECT_HAS(read_refusal("a.stl", binary_stl({}, "")), "no faces");
  const std::string binary = binary_stl(tetrahedron(), "x");
  EXPECT_HAS(read_refusal("a.stl", binary.substr(0, 250)), "declares 4 facets");
  EXPECT_HAS(read_refusal("a.stl", binary + std::string(100, '\0')), "room for 6");
  TriangleMesh infinite = tetrahedron();
  infinite.positions[3][1] = INFINITY;
  EXPECT_HAS(read_refusal("a.stl", binary_stl(infinite, "x")), "facet 1 has coordinate y = inf");
  const std::string text = text_stl(tetrahedron());
  EXPECT_HAS(read_refusal("a.stl", text.substr(0, text.find("endloop"))), "ends in facet 0");
  EXPECT_HAS(read_refusal("a.stl", text.substr(0, text.find("endsolid"))), "without endsolid");
  EXPECT_HAS(read_refusal("a.stl",
                          "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 "
                          "0 0\nendloop\nendfacet\nendsolid\n"),
             "facet 0 has 2 vertices (line 7)");
  EXPECT_HAS(read_refusal("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0\n"),
             "'x' (line 4)");
}

}  // namespace
}  // namespace ucvt::test
