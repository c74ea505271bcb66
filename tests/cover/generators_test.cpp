#include "cover/generators.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "cover/layout.h"
#include "cover_surfaces.h"
#include "triangulation/frame.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

using test::Covered;
using test::covered;
using test::of_genus;

/// Algebraic intersection numbers of the curves that cross the rim's letters one each: the inverse, up
/// to sign, of those of the letters themselves.
std::vector<std::vector<int>> intersections(const Word& rim) {
  const std::size_t letters = rim.size() / 2;
  std::vector<std::vector<int>> out(letters, std::vector<int>(letters, 0));
  for (std::size_t i = 0; i < letters; ++i) {
    const auto name = static_cast<std::int32_t>(i + 1);
    std::size_t at = 0;
    while (rim[at] != name) {
      ++at;
    }
    for (std::size_t k = at + 1; rim[k % rim.size()] != -name; ++k) {
      const std::int32_t x = rim[k % rim.size()];
      out[i][static_cast<std::size_t>(std::abs(x) - 1)] += x > 0 ? 1 : -1;
    }
  }
  return out;
}

void expect_canonical(const Covered& c, int genus, double tolerance) {
  ASSERT_EQ(c.group.genus, genus);
  ASSERT_EQ(c.system.cut.rim.size(), static_cast<std::size_t>(4 * genus));
  EXPECT_LT(c.group.certificate.residual, tolerance);
  EXPECT_LT(c.group.certificate.largest_change, 1e-9);
  EXPECT_NEAR(c.group.certificate.angle_sum, 2 * std::numbers::pi, 1e-9);
  // The standard symplectic form of the generators, pulled back to the greedy loops.
  const auto form = intersections(c.system.cut.rim);
  const std::size_t n = form.size();
  std::vector<std::vector<int>> homology(n, std::vector<int>(n, 0));
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::int32_t x : c.group.generators[i].word) {
      homology[i][static_cast<std::size_t>(std::abs(x) - 1)] += x > 0 ? 1 : -1;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      int sum = 0;
      for (std::size_t k = 0; k < n; k += 2) {
        sum += homology[k][i] * homology[k + 1][j] - homology[k + 1][i] * homology[k][j];
      }
      EXPECT_EQ(sum, form[i][j]) << i << " " << j;
    }
  }
}

TEST(Generators, OfToriAreTranslationsThatSpanTheLattice) {
  for (const auto& mesh : {oracle::seven_vertex_torus(), oracle::grid_torus(9, 6)}) {
    const Covered c = covered(mesh);
    expect_canonical(c, 1, 1e-12);
    const ModelMatrix &a = c.group.generators[0].matrix, &b = c.group.generators[1].matrix;
    double area = 0;
    for (std::size_t f = 0; f < c.t->surface.connectivity().face_count(); ++f) {
      area += c.t->surface.area({static_cast<std::int32_t>(f)});
    }
    EXPECT_NEAR(a[0][2] * b[1][2] - a[1][2] * b[0][2], area, 1e-9 * area);
    EXPECT_EQ(a[0][0], 1);
    EXPECT_EQ(a[0][1], 0);
  }
  const UniformSurface t = oracle::flat_torus(6, 5);
  EXPECT_LT(deck_group(deck_system(t)).certificate.residual, 1e-12);
}

TEST(Generators, AreCanonicalForGenusTwoToSix) {
  for (int genus = 2; genus <= 6; ++genus) {
    SCOPED_TRACE(genus);
    expect_canonical(of_genus(genus), genus, 1e-12);
    EXPECT_LT(of_genus(genus).group.certificate.residual_moebius, 1e-5);
  }
  EXPECT_LT(of_genus(2).group.certificate.residual_moebius, 1e-11);
  EXPECT_LT(of_genus(2).group.certificate.residual_matrix, 1e-9);
}

TEST(Generators, ASphereHasNone) {
  EXPECT_THROW(deck_system(oracle::surface_of(1)), InvalidInput);
}

TEST(Generators, OneVertexIsEnough) {
  for (const double kappa : {0.0, -1.0}) {
    const UniformSurface t = oracle::fewest_vertices(oracle::surface_of(kappa));
    ASSERT_EQ(t.connectivity().vertex_count(), 1U);
    EXPECT_LT(deck_group(deck_system(t)).certificate.residual, 1e-12);
  }
}

TEST(Generators, AreTheSameEveryTime) {
  const UniformSurface& t = of_genus(3).t->surface;
  const DeckGroup again = deck_group(deck_system(t));
  for (std::size_t i = 0; i < again.generators.size(); ++i) {
    EXPECT_EQ(again.generators[i].matrix, of_genus(3).group.generators[i].matrix);
  }
}

TEST(Generators, MatricesPreserveTheForm) {
  for (int genus = 2; genus <= 6; ++genus) {
    for (const DeckGenerator& g : of_genus(genus).group.generators) {
      const ModelMatrix& m = g.matrix;
      const double size = std::pow(m[2][2], 2);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const double form = m[0][i] * m[0][j] + m[1][i] * m[1][j] - m[2][i] * m[2][j];
          EXPECT_NEAR(form, i != j ? 0 : i < 2 ? 1 : -1, 1e-14 * size);
        }
      }
      EXPECT_NEAR(g.a[0] * g.a[0] + g.a[1] * g.a[1] - g.b[0] * g.b[0] - g.b[1] * g.b[1], 1,
                  1e-14 * size);
      EXPECT_NEAR(std::acosh(m[2][2]), g.length, 1e-9);
    }
  }
}

/// A second algorithm: frames carried along the loop's edges in doubles, as D does it.
TEST(Generators, AreTheHolonomyOfTheirLoops) {
  for (int genus = 1; genus <= 4; ++genus) {
    const Covered& c = of_genus(genus);
    const Connectivity& k = c.t->surface.connectivity();
    const Space s = c.t->surface.space();
    const auto offset = c.t->surface.vertex_frames();
    for (const DeckGenerator& g : c.group.generators) {
      const auto path = loop_path(c.system.cut, k, g.word);
      ASSERT_FALSE(path.empty());
      EXPECT_EQ(k.origin(path.front()).id, c.group.base);
      EXPECT_EQ(k.head(path.back()).id, c.group.base);
      // The base and a point beside it, carried by the last frame change first.
      Offset p{}, q = from_chord(s, 0.5, 1, 0);
      for (std::size_t i = path.size(); i-- > 0;) {
        if (i > 0) {
          ASSERT_EQ(k.head(path[i - 1]), k.origin(path[i]));
        }
        const Isometry step =
            between_frames(offset[path[i].index()], offset[k.twin(path[i]).index()]);
        p = step.apply(s, p), q = step.apply(s, q);
      }
      const Offset from = from_chord(s, 0.5, 1, 0);
      const ModelPoint there = transformed(g.matrix, {from.x, from.y, model_z(s, from)});
      const double size = g.matrix[2][2] * g.matrix[2][2];
      EXPECT_NEAR(p.x, g.matrix[0][2], 1e-10 * size);
      EXPECT_NEAR(p.y, g.matrix[1][2], 1e-10 * size);
      EXPECT_NEAR(q.x, there[0], 1e-10 * size);
      EXPECT_NEAR(q.y, there[1], 1e-10 * size);
    }
  }
}

TEST(Polygon, SidesArePairedByTheGenerators) {
  for (int genus = 1; genus <= 4; ++genus) {
    const DeckGroup& g = of_genus(genus).group;
    const std::size_t n = g.polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto j = static_cast<std::size_t>(g.paired_side[i]);
      EXPECT_EQ(g.relator[i], -g.relator[j]);
      EXPECT_EQ(static_cast<std::size_t>(g.paired_side[j]), i);
      // Paired sides are equally long.
      const auto chord2 = [&](std::size_t k) {
        const ModelPoint &p = g.polygon[k], &q = g.polygon[(k + 1) % n];
        const double dz = q[2] - p[2];
        return std::pow(q[0] - p[0], 2) + std::pow(q[1] - p[1], 2) + g.kappa * dz * dz;
      };
      const double size = g.polygon[i][2] * g.polygon[(i + 1) % n][2];
      EXPECT_NEAR(chord2(i), chord2(j), 1e-6 * size * size);
    }
    // Counterclockwise, and of the surface's area.
    double area = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto offset = [&](std::size_t k) {
        return offset_in(Frame{g.kappa}, g.polygon[k % n]);
      };
      area += central_triangle_area({g.kappa}, offset(i), offset(i + 1));
    }
    double expected = 0;
    const UniformSurface& t = of_genus(genus).t->surface;
    for (std::size_t f = 0; f < t.connectivity().face_count(); ++f) {
      expected += t.area({static_cast<std::int32_t>(f)});
    }
    EXPECT_NEAR(area, expected, 1e-6 * expected);
  }
}

TEST(Generators, OfSharedMeshes) {
  const char* const meshes = std::getenv("UCVT_SHARED_MESHES");
  if (meshes == nullptr) {
    GTEST_SKIP() << "set UCVT_SHARED_MESHES to the folder of shared meshes";
  }
  for (const char* file :
       {"genus1/bob_small.ply", "genus2/doubletorus_124.obj", "genus3/3torus_coarse.obj",
        "genus4/anchor_cad.off", "genus5/5torus_coarse.obj", "genus_high/9handles_g9.off"}) {
    SCOPED_TRACE(file);
    const TriangleMesh mesh = read_mesh((std::filesystem::path(meshes) / file).string());
    const int genus = closed_surface(mesh).genus;
    expect_canonical(covered(mesh), genus, 1e-12);
  }
}

}  // namespace
}  // namespace ucvt
