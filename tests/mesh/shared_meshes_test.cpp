// Runs over the shared collection of real and broken meshes, where there is one: the folder named
// by the environment variable UCVT_SHARED_MESHES.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "mesh_test_support.h"
#include "ucvt/components.h"
#include "ucvt/repair.h"

namespace ucvt::test {
namespace {

class SharedMeshes : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("UCVT_SHARED_MESHES");
    if (folder == nullptr) {
      GTEST_SKIP() << "set UCVT_SHARED_MESHES to the folder of shared meshes";
    }
    folder_ = folder;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(SharedMeshes, GoodOnesHaveTheGenusOfTheManifest) {
  std::ifstream manifest(path("manifest.tsv"));
  std::string line, column;
  std::getline(manifest, line);
  int tried = 0;
  while (std::getline(manifest, line)) {
    std::vector<std::string> columns;
    std::istringstream cells(line);
    while (std::getline(cells, column, '\t')) {
      columns.push_back(column);
    }
    const std::string folder = columns.at(0).substr(0, columns.at(0).find('/'));
    if (folder != "paper" && folder.substr(0, 5) != "genus") {
      continue;
    }
    SCOPED_TRACE(columns[0]);
    const ClosedSurface surface = closed_surface(read_mesh(path(columns[0])));
    EXPECT_EQ(surface.genus, std::stoi(columns.at(9)));
    EXPECT_EQ(surface.mesh.faces.size(), std::stoul(columns.at(4)));
    EXPECT_EQ(surface.reoriented_faces, 0);
    ++tried;
  }
  EXPECT_GT(tried, 50);
}

TEST_F(SharedMeshes, EveryDressOfTheTorusIsTaken) {
  int tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "bad")) {
    const std::string name = entry.path().filename().string();
    if (name.substr(0, 4) != "fmt_") {
      continue;
    }
    SCOPED_TRACE(name);
    const ClosedSurface surface = closed_surface(read_mesh(entry.path().string()));
    EXPECT_EQ(surface.genus, 1);
    EXPECT_EQ(surface.mesh.positions.size(), 160U);
    EXPECT_EQ(surface.mesh.faces.size(), 320U);
    ++tried;
  }
  EXPECT_GE(tried, 19);
}

TEST_F(SharedMeshes, OddButValidOnesAreTaken) {
  const std::pair<const char*, int> genera[] = {
      {"found_comments.off", 0},
      {"found_whitespace.off", 0},
      {"found_cube_compressed.obj", 0},
      {"found_cube_shuffled.off", 0},
      {"found_blobby_shuffled.off", 0},
      {"found_mpi_polygons.off", 1},
      {"found_torus_quad.off", 1},
      {"found_hole_mixed.off", 1},
      {"found_prim_unused.off", 0},
      {"found_box_utf16be.obj", 0},
      {"found_zero_area.stl", 0},
      {"found_issue945f.stl", 0},
      {"found_binary_off_polylaplace.off", 4},
      {"mixed_orientation.off", 1},
      {"inside_out.off", 1},
      {"unused_vertices.off", 1},
      {"soup_ascii.stl", 1},
      {"soup_binary_solid_header.stl", 1},
      {"flat_double_square.off", 0},
      {"flattened.off", 1},
      {"collapsed_to_point.off", 1},
      {"collapsed_to_line.off", 1},
      {"zero_area_faces.off", 1},
      {"needles_1e-6.off", 1},
      {"needles_1e-13.off", 1},
      {"zero_length_edge.off", 1},
      {"tiny_1e-12.off", 1},
      {"huge_1e30.off", 1},
      {"far_offset_1e8.off", 1},
      {"squashed_1e-5.off", 1},
      {"random_coordinates.off", 1},
      {"spindle_torus_selfintersecting.off", 1},
      {"bipyramid_valence_3000.off", 0},
      {"torus_7_vertices.off", 1},
      {"frame_g2.off", 2},
      {"frame_g4.off", 4},
      {"frame_quads.obj", 2},
  };
  for (const auto& [name, genus] : genera) {
    SCOPED_TRACE(name);
    EXPECT_EQ(closed_surface(read_mesh(path(std::string("bad/") + name))).genus, genus);
  }
}

constexpr std::pair<const char*, const char*> faults[] = {
    {"empty.off", "empty"},
    {"zero_counts.off", "no faces"},
    {"garbage.obj", "known format"},
    {"text_not_mesh.off", "line 2"},
    {"lfs_pointer.obj", "git lfs"},
    {"truncated.off", "ends in face 160 of 320"},
    {"truncated_binary.ply", "byte"},
    {"huge_counts.off", "4000000000"},
    {"nan_vertex.obj", "nan"},
    {"inf_vertex.off", "inf"},
    {"index_out_of_range.off", "index 163"},
    {"negative_index.off", "index -2"},
    {"face_of_two.off", "2 corners (line 483)"},
    {"repeated_index_face.off", "repeated corner"},
    {"duplicate_face.off", "duplicate"},
    {"opposite_face_pair.off", "duplicate"},
    {"missing_face.off", "1 boundary loop of 3 edges"},
    {"klein_bottle.off", "Klein bottle"},
    {"projective_plane_6.off", "projective plane"},
    {"two_tets_sharing_vertex.off", "1 non-manifold vertex (first 0, of 2 fans)"},
    {"two_tets_sharing_edge.off", "(first 0-1, of 4 faces)"},
    {"voxels_touching_edge.off", "(first 1-2, of 4 faces)"},
    {"voxels_touching_corner.off", "1 non-manifold vertex (first 2, of 2 fans)"},
    {"three_fins.off", "1 non-manifold edge (first 0-1, of 3 faces)"},
    {"two_components.off", "2 components"},
    {"unwelded.obj", "800 vertices repeat the place of another one"},
    {"soup_jittered.stl", "boundary"},
    {"lens_two_triangles.off", "duplicate"},
    {"one_triangle.off", "boundary"},
    {"found_joined_tetrahedra.obj", "duplicate"},
    {"found_shared.STL", "not manifold"},
    {"found_soup.stl", "100 boundary loops"},
    {"found_not_convex.obj", "244 vertices repeat the place of another one"},
    {"found_polygonfaces.obj", "boundary"},
    {"found_wallhole.obj", "boundary"},
    {"found_multibody.stl", "2 components"},
    {"found_featuretype.ply", "3374 vertices repeat the place of another one"},
    {"found_angle_block.STL", "boundary"},
    {"found_empty_header.ply", "no vertex element"},
    {"found_stl_empty_bin.stl", "no faces"},
    {"found_degenerate_sliding.off", "boundary"},
    {"found_bones.off", "26 components"},
    {"found_invalid.off", "0 corners"},
    {"found_malformed.obj", "line 28"},
    {"found_number_formats.obj", "boundary"},
    {"found_sphere_with_hole.stl", "boundary"},
    {"found_4voxel.obj", "boundary"},
};

TEST_F(SharedMeshes, EveryFaultIsNamed) {
  for (const auto& [name, word] : faults) {
    SCOPED_TRACE(name);
    const std::string file = path(std::string("bad/") + name);
    const std::string message = refusal([&] { closed_surface(read_mesh(file)); });
    EXPECT_HAS(message, word);
  }
}

struct Mended {
  const char* name;
  std::size_t components;
  int genus;  ///< summed
};

constexpr Mended mended[] = {
    {"repeated_index_face.off", 1, 1},
    {"duplicate_face.off", 1, 1},
    {"opposite_face_pair.off", 1, 1},
    {"missing_face.off", 1, 1},
    {"mixed_orientation.off", 1, 1},
    {"two_tets_sharing_vertex.off", 2, 0},
    {"two_tets_sharing_edge.off", 2, 0},
    {"voxels_touching_edge.off", 2, 0},
    {"voxels_touching_corner.off", 2, 0},
    {"two_components.off", 2, 2},
    {"unwelded.obj", 1, 1},
    {"found_joined_tetrahedra.obj", 1, 0},
    {"found_shared.STL", 2, 0},
    {"found_multibody.stl", 2, 0},
    {"found_featuretype.ply", 1, 9},
    {"found_bones.off", 26, 0},
    {"found_sphere_with_hole.stl", 1, 0},
    {"found_wallhole.obj", 1, 0},
};

TEST_F(SharedMeshes, RepairMends) {
  for (const auto& [name, components, genus] : mended) {
    SCOPED_TRACE(name);
    const Repaired r = repair(read_mesh(path(std::string("bad/") + name)));
    const std::vector<Component> parts = closed_components(r.mesh);
    EXPECT_EQ(parts.size(), components);
    int sum = 0;
    for (const Component& part : parts) {
      sum += part.surface.genus;
      EXPECT_EQ(part.surface.reoriented_faces, 0);
    }
    EXPECT_EQ(sum, genus);
  }
}

TEST_F(SharedMeshes, RepairLeavesTheRestNamed) {
  for (const char* name :
       {"klein_bottle.off", "projective_plane_6.off", "three_fins.off", "lens_two_triangles.off",
        "one_triangle.off", "soup_jittered.stl", "found_soup.stl", "found_polygonfaces.obj",
        "found_degenerate_sliding.off", "found_number_formats.obj", "found_4voxel.obj"}) {
    SCOPED_TRACE(name);
    const Repaired r = repair(read_mesh(path(std::string("bad/") + name)));
    EXPECT_HAS(faults_of(r.mesh), "the surface is ");
  }
  const Repaired coarse = repair(read_mesh(path("bad/soup_jittered.stl")), {.weld = 1e-6});
  EXPECT_EQ(faults_of(coarse.mesh), "");
}

TEST_F(SharedMeshes, OpenOnesAreRefused) {
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "open")) {
    SCOPED_TRACE(entry.path().string());
    const TriangleMesh mesh = read_mesh(entry.path().string());
    EXPECT_HAS(closed_refusal(mesh), "the surface is open");
    EXPECT_GT(survey(mesh).boundary_loops, 0);
  }
}

}  // namespace
}  // namespace ucvt::test
