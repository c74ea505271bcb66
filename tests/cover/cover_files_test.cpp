#include <cmath>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cover/group_file.h"
#include "cover_surfaces.h"
#include "result/loops_file.h"
#include "result/uv_file.h"

namespace ucvt {
namespace {

using test::of_genus;

TEST(GroupFile, IsJsonWithTheGroup) {
  for (int genus = 1; genus <= 4; ++genus) {
    const auto& c = of_genus(genus);
    const auto json = nlohmann::json::parse(group_json(c.system, c.group));
    EXPECT_EQ(json["genus"], genus);
    EXPECT_EQ(json["geometry"], genus == 1 ? "euclidean" : "hyperbolic");
    ASSERT_EQ(json["generators"].size(), 2U * static_cast<unsigned>(genus));
    ASSERT_EQ(json["polygon"].size(), 4U * static_cast<unsigned>(genus));
    for (std::size_t i = 0; i < json["generators"].size(); ++i) {
      const auto& g = json["generators"][i];
      EXPECT_EQ(g["name"], c.group.generators[i].name);
      EXPECT_EQ(g["matrix"].get<ModelMatrix>(), c.group.generators[i].matrix);
      EXPECT_EQ((g["moebius"]["b"].get<std::array<double, 2>>()), c.group.generators[i].b);
      const auto letter = static_cast<std::int32_t>(i + 1);
      EXPECT_EQ(json["relator"][g["sides"][0].get<std::size_t>()], letter);
      EXPECT_EQ(json["relator"][g["sides"][1].get<std::size_t>()], -letter);
    }
    EXPECT_LT(json["certificate"]["residual"].get<double>(), 1e-12);
  }
}

TEST(LoopsFile, IsClosedPolylinesOnTheInput) {
  const auto& c = of_genus(3);
  std::istringstream in(loops_obj(*c.t, c.system, c.group));
  std::vector<Position> v;
  std::size_t loops = 0, names = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v") {
      Position& p = v.emplace_back();
      words >> p[0] >> p[1] >> p[2];
      ASSERT_FALSE(words.fail());
    } else if (key == "o") {
      ++names;
    } else {
      ASSERT_EQ(key, "l");
      std::vector<std::size_t> index;
      for (std::size_t i; words >> i;) {
        ASSERT_TRUE(i >= 1 && i <= v.size());
        index.push_back(i);
      }
      ASSERT_GE(index.size(), 4U);
      EXPECT_EQ(index.front(), index.back());
      EXPECT_EQ(v[index.front() - 1], v.front());
      ++loops;
    }
  }
  EXPECT_EQ(loops, 6U);
  EXPECT_EQ(names, 6U);
  // Between the bends, steps stay within the voxels' edges.
  for (const auto& loop : loops_on_input(*c.t, c.system)) {
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
      double step = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        step += std::pow(loop[i + 1][k] - loop[i][k], 2);
      }
      EXPECT_LT(step, 2 + 1e-9);
    }
  }
}

TEST(UvFile, IsAnObjOfTCutOpen) {
  for (const auto& [genus, coordinates] :
       {std::pair{1, CoverCoordinates::Plane}, std::pair{2, CoverCoordinates::Klein},
        std::pair{3, CoverCoordinates::Poincare}, std::pair{2, CoverCoordinates::HalfPlane}}) {
    const auto& c = of_genus(genus);
    const Connectivity& k = c.t->surface.connectivity();
    std::istringstream in(uv_obj(*c.t, c.system, coordinates));
    std::vector<std::array<double, 2>> vt;
    std::size_t v = 0, f = 0;
    std::set<std::pair<std::size_t, std::size_t>> edges;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      std::string key;
      words >> key;
      if (key == "v") {
        ++v;
        continue;
      }
      if (key == "vt") {
        words >> vt.emplace_back()[0] >> vt.back()[1];
        ASSERT_FALSE(words.fail());
        continue;
      }
      ASSERT_EQ(key, "f");
      std::array<std::array<double, 2>, 3> uv{};
      std::array<std::size_t, 3> number{};
      for (std::size_t i = 0; i < 3; ++i) {
        std::size_t vertex = 0, texture = 0;
        char slash = 0;
        words >> vertex >> slash >> texture;
        ASSERT_EQ(slash, '/');
        ASSERT_EQ(vertex, k.origin(halfedges({static_cast<std::int32_t>(f)})[i]).index() + 1);
        ASSERT_TRUE(texture >= 1 && texture <= vt.size());
        uv[i] = vt[texture - 1], number[i] = texture;
      }
      EXPECT_GT((uv[1][0] - uv[0][0]) * (uv[2][1] - uv[0][1]) -
                    (uv[1][1] - uv[0][1]) * (uv[2][0] - uv[0][0]),
                0)
          << f;
      for (std::size_t i = 0; i < 3; ++i) {
        edges.insert(std::minmax({number[i], number[(i + 1) % 3]}));
      }
      ++f;
    }
    EXPECT_EQ(v, k.vertex_count());
    EXPECT_EQ(f, k.face_count());
    // A disk: Euler number 1.
    EXPECT_EQ(vt.size() + f, edges.size() + 1);
  }
}

TEST(Cover, IsReachedFromThePublicHeader) {
  const Cover cover(uniformize(oracle::closed(oracle::voxel_frame(2))));
  EXPECT_EQ(cover.group().genus, 2);
  EXPECT_EQ(cover.neighbours().size(), 48U);
}

}  // namespace
}  // namespace ucvt
