#include "cover/layout.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "cover_surfaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

using test::of_genus;

/// Distance of the two maps' images of the origin, relative to their size.
double apart(double kappa, const DeckMap& m, const DeckMap& n) {
  return displacement(kappa, product(kappa, inverse(m), n));
}

TEST(Layout, FacesHaveTheirChordsAndTheDomainItsArea) {
  for (int genus = 1; genus <= 4; ++genus) {
    const auto& c = of_genus(genus);
    const UniformSurface& t = c.t->surface;
    const auto at = laid_out(t, c.system);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)};
      const double length = length_of_chord(t.space(), t.chord(h));
      EXPECT_NEAR(apart(c.system.kappa, at[i], at[h.next().index()]), length, 1e-7);
    }
    double area = 0, expected = 0;
    for (std::size_t f = 0; f < at.size() / 3; ++f) {
      const auto corner = [&](std::size_t k) { return image_of_origin(at[3 * f + k]); };
      const double twice = orientation(t.space(), corner(0), corner(1), corner(2));
      EXPECT_NEAR(twice, t.det({static_cast<std::int32_t>(f)}), 1e-6);
      area += twice;
      expected += t.det({static_cast<std::int32_t>(f)});
    }
    EXPECT_NEAR(area, expected, 1e-7 * expected);
  }
}

TEST(Layout, CopiesMatchAcrossTheCut) {
  for (int genus = 1; genus <= 4; ++genus) {
    const auto& c = of_genus(genus);
    const UniformSurface& t = c.t->surface;
    const auto at = laid_out(t, c.system);
    std::size_t cut = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Halfedge h{static_cast<std::int32_t>(i)}, twin = t.connectivity().twin(h);
      const DeckMap across = across_cut(t, c.system, h);
      cut += off_identity(across) > 1e-3 ? 1 : 0;
      for (const auto& [here, there] : {std::pair{h, twin.next()}, std::pair{h.next(), twin}}) {
        const DeckMap moved = product(c.system.kappa, across, at[there.index()]);
        EXPECT_LT(apart(c.system.kappa, at[here.index()], moved), 1e-9);
      }
    }
    EXPECT_GE(cut, 4 * static_cast<std::size_t>(genus));
  }
}

/// The rim cuts the surface into one disk: faces joined across uncut edges are a tree that holds all.
TEST(Layout, IsOneDisk) {
  for (int genus = 1; genus <= 6; ++genus) {
    const auto& c = of_genus(genus);
    const Connectivity& k = c.t->surface.connectivity();
    std::vector<char> is_cut(k.halfedge_count(), 0);
    const auto mark = [&](Halfedge h) { is_cut[h.index()] = is_cut[k.twin(h).index()] = 1; };
    for (const Halfedge h : c.system.cut.towards_base) {
      if (h.id >= 0) {
        mark(h);
      }
    }
    for (const Halfedge h : c.system.cut.edge) {
      mark(h);
    }
    EXPECT_EQ(c.system.cut.edge.size(), 2 * static_cast<std::size_t>(genus));
    EXPECT_EQ(std::accumulate(is_cut.begin(), is_cut.end(), 0) / 2,
              static_cast<int>(k.vertex_count()) - 1 + 2 * genus);
    std::vector<Face> queue{{0}};
    std::vector<char> seen(k.face_count(), 0);
    seen[0] = 1;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const Halfedge h : halfedges(queue[i])) {
        const Face next = k.twin(h).face();
        if (!is_cut[h.index()] && !seen[next.index()]) {
          seen[next.index()] = 1;
          queue.push_back(next);
        }
      }
    }
    EXPECT_EQ(queue.size(), k.face_count());
  }
}

TEST(Coordinates, AreTheModelsOwn) {
  // A point at distance 1.3 in direction 0.7.
  const DeckMap m{{std::cosh(0.65), 0},
                  {std::sinh(0.65) * std::cos(0.7), std::sinh(0.65) * std::sin(0.7)}};
  const auto klein = coordinates_of(-1, m, CoverCoordinates::Klein);
  EXPECT_NEAR(klein[0], std::tanh(1.3) * std::cos(0.7), 1e-15);
  EXPECT_NEAR(klein[1], std::tanh(1.3) * std::sin(0.7), 1e-15);
  const auto w = coordinates_of(-1, m, CoverCoordinates::Poincare);
  EXPECT_NEAR(w[0], std::tanh(0.65) * std::cos(0.7), 1e-15);
  EXPECT_NEAR(w[1], std::tanh(0.65) * std::sin(0.7), 1e-15);
  // i (1 + w)/(1 - w).
  const auto half = coordinates_of(-1, m, CoverCoordinates::HalfPlane);
  const double gap = std::pow(1 - w[0], 2) + w[1] * w[1];
  EXPECT_NEAR(half[0], -2 * w[1] / gap, 1e-14);
  EXPECT_NEAR(half[1], (1 - w[0] * w[0] - w[1] * w[1]) / gap, 1e-14);
  const DeckMap shift{{1, 0}, {1.5, -0.5}};
  EXPECT_EQ(coordinates_of(0, shift, CoverCoordinates::Plane), (std::array<double, 2>{3, -1}));
}

}  // namespace
}  // namespace ucvt
