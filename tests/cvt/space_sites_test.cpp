#include "cvt/space_sites.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cvt/domain.h"
#include "space/polygon_moments.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

ModelMatrix product(const ModelMatrix& a, const ModelMatrix& b) {
  ModelMatrix out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        out[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return out;
}

/// All deck transformations that take the origin no farther than `reach` times the distance of the
/// fundamental polygon's farthest corner. On the way to one of them all polygons are nearer.
std::vector<ModelMatrix> deck_transformations(const Domain& domain, double reach) {
  const Space s{domain.kappa};
  const Frame origin{domain.kappa};
  const auto far = [&](const ModelPoint& p) {
    return length_of_chord(s, std::sqrt(2 * offset_in(origin, p).h));
  };
  double corner = 0;
  for (const ModelPoint& p : model_corners(domain)) {
    corner = std::max(corner, far(p));
  }
  std::vector<ModelMatrix> out{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (const ModelMatrix& side : domain.across) {
      const ModelMatrix m = product(out[i], side);
      const auto is_m = [&](const ModelMatrix& other) {
        return std::hypot(other[0][2] - m[0][2], other[1][2] - m[1][2]) < 1e-6 * (1 + m[2][2]);
      };
      if (far(on_model(domain.kappa, transformed(m, {0, 0, 1}))) < reach * corner &&
          std::ranges::none_of(out, is_m)) {
        out.push_back(m);
      }
    }
  }
  return out;
}

struct NamedDomain {
  std::string name;
  Domain domain;
  std::vector<ModelMatrix> deck;
};

const std::vector<NamedDomain>& domains() {
  static const auto made = [] {
    std::vector<NamedDomain> out{
        {"sphere", sphere_domain(), {}},
        {"square torus", torus_domain({1, 0}, {0, 1}), {}},
        {"skew torus", torus_domain({2, 0.3}, {0.9, 1}), {}},
        {"surface 2", surface_domain(2, SidePairing::Opposite), {}},
        {"surface 2 canonical", surface_domain(2, SidePairing::Canonical), {}},
        {"rectangle", polygon_domain(0, {{3, 1}, {5, 1}, {5, 2}, {3, 2}}), {}},
        {"triangle", polygon_domain(-1, {{-0.9, -0.3}, {0.9, -0.3}, {0.1, 0.8}}), {}},
    };
    for (NamedDomain& d : out) {
      d.deck = deck_transformations(d.domain, 3.2);
    }
    return out;
  }();
  return made;
}

/// On the sphere not all of them in one hemisphere.
std::unique_ptr<SpaceSites> random_sites(const Domain& domain, std::size_t n, std::uint64_t seed) {
  for (;; ++seed) {
    try {
      return make_sites(domain, random_points(domain, n, seed));
    } catch (const NumericalError&) {
      if (domain.kind != DomainKind::Sphere) {
        throw;
      }
    }
  }
}

/// What a corner of a cell sees: the distances to all lifts of all sites, ascending.
std::vector<double> distances(const std::vector<ModelPoint>& lifts, double kappa,
                              const ModelPoint& corner) {
  std::vector<double> out;
  const Frame frame = frame_at(kappa, corner);
  for (const ModelPoint& p : lifts) {
    out.push_back(length_of_chord({kappa}, std::sqrt(2 * offset_in(frame, p).h)));
  }
  std::ranges::sort(out);
  return out;
}

/// Cells are Voronoi cells: no lift of a site is nearer to a corner than the cell's own site, and
/// the cells, which are convex, fill the domain.
void expect_voronoi(const NamedDomain& named, const SpaceSites& sites, double tolerance) {
  SCOPED_TRACE(named.name + " " + std::to_string(sites.count()));
  const Domain& domain = named.domain;
  const Space s{domain.kappa};
  std::vector<ModelPoint> lifts;
  for (const ModelMatrix& m : named.deck) {
    for (const ModelPoint& p : sites.points()) {
      lifts.push_back(on_model(domain.kappa, transformed(m, p)));
    }
  }
  const bool closed =
      domain.kind == DomainKind::Sphere ? sites.count() > 3 : !domain.across.empty();
  double area = 0;
  SiteCell cell;
  for (std::size_t i = 0; i < sites.count(); ++i) {
    sites.cell(i, cell);
    const Frame& frame = sites.frame(i);
    EXPECT_TRUE(contains(domain, frame.P));
    area += uniform_moments(s, cell.corner).m;
    for (const Offset& corner : cell.corner) {
      const double own = length_of_chord(s, std::sqrt(2 * corner.h));
      const auto d = distances(lifts, domain.kappa, model_point(frame, corner));
      EXPECT_NEAR(d[0], own, tolerance);
      // Three cells meet at a corner, but on the sides of a polygon and in the middle of lunes.
      if (closed) {
        EXPECT_NEAR(d[2], own, tolerance);
      }
    }
    const auto seen = distances(lifts, domain.kappa, frame.P);
    if (seen.size() > 1) {
      EXPECT_NEAR(cell.nearest, seen[1], tolerance);
    } else {
      EXPECT_EQ(cell.nearest, 0);
    }
  }
  EXPECT_NEAR(area / domain.area, 1, 1e-10);
}

/// An iteration of Lloyd's method, without any part of the code that users call.
void move_to_centroids(const Domain& domain, SpaceSites& sites) {
  std::vector<Offset> target;
  SiteCell cell;
  for (std::size_t i = 0; i < sites.count(); ++i) {
    sites.cell(i, cell);
    target.push_back(
        centroid_anywhere({domain.kappa}, uniform_moments({domain.kappa}, cell.corner)));
  }
  sites.move(target);
}

TEST(SpaceSites, CellsAgreeWithAllLifts) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    for (const std::size_t n : {5, 12, 50}) {
      expect_voronoi(named, *random_sites(domain, n, n + 1), 1e-8);
    }
  }
}

TEST(SpaceSites, VeryFewSites) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    const bool sphere = domain.kind == DomainKind::Sphere;
    for (std::size_t n = sphere ? 2 : 1; n <= (sphere ? 3 : 4); ++n) {
      for (const std::uint64_t seed : {1, 2}) {
        expect_voronoi(named, *random_sites(domain, n, seed), 1e-7);
      }
    }
  }
}

TEST(SpaceSites, OffsetsAndFramesStayTogether) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    for (const std::size_t n : {7, 40}) {
      const auto sites = random_sites(domain, n, 2);
      for (int i = 0; i < 300; ++i) {
        move_to_centroids(domain, *sites);
      }
      expect_voronoi(named, *sites, 1e-8);
    }
  }
}

TEST(SpaceSites, StayInTheDomainWhereverTheyGo) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    const auto sites = random_sites(domain, 30, 3);
    for (int k = 0; k < 100; ++k) {
      if (domain.across.empty()) {
        move_to_centroids(domain, *sites);
      } else {
        // All drift the same way, across the sides again and again.
        sites->move(std::vector<Offset>(30, from_chord({domain.kappa}, 0.02, 0.6, 0.8)));
      }
      for (const ModelPoint& p : sites->points()) {
        ASSERT_TRUE(contains(domain, p)) << k;
      }
    }
    expect_voronoi(named, *sites, 1e-8);
  }
}

TEST(SpaceSites, StayInPolygonsHoweverFarTheyAreSent) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    if (is_closed(domain)) {
      continue;
    }
    const auto sites = random_sites(domain, 30, 3);
    const std::vector<ModelPoint> before = sites->points();
    sites->move(std::vector<Offset>(30, from_chord({domain.kappa}, 5, 0.6, 0.8)));
    const std::vector<ModelPoint> after = sites->points();
    for (std::size_t i = 0; i < 30; ++i) {
      EXPECT_TRUE(contains(domain, after[i]));
      EXPECT_NE(before[i], after[i]);
    }
    expect_voronoi(named, *sites, 1e-8);
  }
}

TEST(SpaceSites, GoBackToWhereTheyWereSaved) {
  std::vector<NamedDomain> all = domains();
  all.push_back({"two on the sphere", sphere_domain(), {}});
  for (const NamedDomain& named : all) {
    const auto sites = random_sites(named.domain, named.deck.empty() ? 2 : 40, 2);
    const auto points = sites->points();
    const auto triangles = sites->triangles();
    sites->save();
    for (int i = 0; i < 20; ++i) {
      move_to_centroids(named.domain, *sites);
    }
    EXPECT_NE(sites->points(), points);
    sites->restore();
    EXPECT_EQ(sites->points(), points);
    EXPECT_EQ(sites->triangles(), triangles);
    if (!named.deck.empty()) {
      expect_voronoi(named, *sites, 1e-8);
    }
  }
}

TEST(SpaceSites, MiddlesLieHalfwayBetweenTwoSites) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    const auto sites = random_sites(domain, 30, 4);
    const std::vector<ModelPoint> all = sites->middles(1000);
    if (!is_closed(domain)) {
      EXPECT_TRUE(all.empty());
      continue;
    }
    EXPECT_EQ(static_cast<int>(all.size()), 3 * (30 - 2 + 2 * domain.genus)) << named.name;
    EXPECT_EQ(sites->middles(7), std::vector<ModelPoint>(all.begin(), all.begin() + 7));
    std::vector<ModelPoint> lifts;
    for (const ModelMatrix& m : named.deck) {
      for (const ModelPoint& p : sites->points()) {
        lifts.push_back(on_model(domain.kappa, transformed(m, p)));
      }
    }
    for (const ModelPoint& p : all) {
      EXPECT_TRUE(contains(domain, p));
      // The middle of an edge may lie nearer to a third site, but its ends are equally far.
      const auto d = distances(lifts, domain.kappa, p);
      bool halves = false;
      for (std::size_t i = 1; i < std::min<std::size_t>(d.size(), 8); ++i) {
        halves = halves || d[i] - d[i - 1] < 1e-8;
      }
      EXPECT_TRUE(halves) << named.name;
    }
  }
}

TEST(SpaceSites, TrianglesAreTheDualOfTheCorners) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    const auto sites = random_sites(domain, 50, 5);
    std::vector<int> corners(50), in_triangles(50);
    SiteCell cell;
    for (std::size_t i = 0; i < 50; ++i) {
      sites->cell(i, cell);
      corners[i] = static_cast<int>(cell.corner.size());
      EXPECT_LE(cell.degree, corners[i]);
    }
    for (const auto& t : sites->triangles()) {
      for (const std::int32_t v : t) {
        ++in_triangles[static_cast<std::size_t>(v)];
      }
    }
    if (domain.across.empty() && domain.kind != DomainKind::Sphere) {
      for (std::size_t i = 0; i < 50; ++i) {
        EXPECT_LE(in_triangles[i], corners[i]) << named.name;
      }
      continue;
    }
    EXPECT_EQ(in_triangles, corners) << named.name;
    EXPECT_EQ(sites->triangles().size(), 2 * (50 + 2 * static_cast<std::size_t>(domain.genus)) - 4)
        << named.name;
  }
}

TEST(SpaceSites, TrianglesRunCounterclockwise) {
  const Domain sphere = sphere_domain();
  const auto sites = make_sites(sphere, random_points(sphere, 40, 2));
  const auto p = sites->points();
  for (const auto& t : sites->triangles()) {
    const auto &a = p[static_cast<std::size_t>(t[0])], &b = p[static_cast<std::size_t>(t[1])],
               &c = p[static_cast<std::size_t>(t[2])];
    EXPECT_GT(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0]),
              0);
  }
}

TEST(SpaceSites, WhatCannotBeConnectedIsRefused) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    auto points = random_points(domain, 10, 4);
    points.push_back(points[3]);
    EXPECT_THROW(make_sites(domain, points), InvalidInput) << named.name;
  }
  const Domain sphere = sphere_domain();
  EXPECT_THROW(make_sites(sphere, {{0, 0, 1}, {0, 0, 1}}), InvalidInput);
  std::vector<ModelPoint> cap;
  for (int i = 0; i < 20; ++i) {
    cap.push_back(model_point(Frame{1}, from_chord({1}, 0.02 * (i + 1), std::cos(i), std::sin(i))));
  }
  EXPECT_THROW(make_sites(sphere, cap), NumericalError);
}

TEST(SpaceSites, SitesOnSidesAndAtCornersOfTheFundamentalPolygon) {
  for (const NamedDomain& named : domains()) {
    const Domain& domain = named.domain;
    if (domain.across.empty()) {
      continue;
    }
    auto points = random_points(domain, 20, 6);
    const auto corners = model_corners(domain);
    const Frame at = frame_at(domain.kappa, corners[0]);
    points.push_back(
        model_point(domain.kappa, {domain.polygon[0][0] * 0.6 + domain.polygon[1][0] * 0.4,
                                   domain.polygon[0][1] * 0.6 + domain.polygon[1][1] * 0.4}));
    points.push_back(into_polygon(domain, model_point(at, from_chord({domain.kappa}, 1e-7, 1, 0))));
    expect_voronoi(named, *make_sites(domain, points), 1e-7);
  }
}

}  // namespace
}  // namespace ucvt
