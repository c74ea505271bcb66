#include "cvt/optimize.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cvt/tessellation.h"
#include "oracle/surfaces.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

class OptimizeTest : public testing::TestWithParam<double> {
 protected:
  const UniformSurface& t = oracle::surface_of(GetParam());
  const SurfaceMass mass{t, density()};

  [[nodiscard]] std::vector<double> density() const {
    std::vector<double> out;
    for (std::size_t v = 0; v < t.connectivity().vertex_count(); ++v) {
      out.push_back(1.5 + std::sin(0.3 * static_cast<double>(v)));
    }
    return out;
  }
  [[nodiscard]] Tessellation sites(std::size_t n) const {
    return {mass, oracle::random_points(t, n, 3)};
  }
};

TEST_P(OptimizeTest, LbfgsNeverRaisesTheEnergyAndConverges) {
  Tessellation s = sites(40);
  const OptimizeResult out = optimize(s, {Method::Lbfgs, 2000, 1e-7}, {});
  EXPECT_TRUE(out.converged);
  EXPECT_LE(out.max_move.back(), 1e-7);
  for (std::size_t i = 1; i < out.energy.size(); ++i) {
    EXPECT_LE(out.energy[i], out.energy[i - 1] * (1 + 1e-12)) << i;
  }
}

TEST_P(OptimizeTest, FiftyEvaluationsOfLbfgsGoBelowTwoHundredOfLloyd) {
  Tessellation a = sites(200), b = sites(200);
  const OptimizeResult lbfgs = optimize(a, {Method::Lbfgs, 50, 0}, {});
  const OptimizeResult lloyd = optimize(b, {Method::Lloyd, 200, 0}, {});
  EXPECT_EQ(lbfgs.evaluations, 50);
  EXPECT_EQ(lloyd.evaluations, 200);
  EXPECT_LT(lbfgs.energy.back(), lloyd.energy.back());
}

/// The same sites, of which nobody knows how they hang together.
class WithoutSprings : public SiteSystem {
 public:
  explicit WithoutSprings(Tessellation sites) : sites_(std::move(sites)) {}
  [[nodiscard]] Space space() const override { return sites_.space(); }
  [[nodiscard]] std::size_t site_count() const override { return sites_.site_count(); }
  void measure(std::vector<CellState>& out) const override { sites_.measure(out); }
  void move(const std::vector<Offset>& target) override { sites_.move(target); }
  void save() override { sites_.save(); }
  void restore() override { sites_.restore(); }

 private:
  Tessellation sites_;
};

TEST_P(OptimizeTest, WithoutSpringsTheFirstStepIsLloyds) {
  WithoutSprings a(sites(60));
  Tessellation b = sites(60);
  const OptimizeResult lbfgs = optimize(a, {Method::Lbfgs, 1, 0}, {});
  const OptimizeResult lloyd = optimize(b, {Method::Lloyd, 1, 0}, {});
  // Unless Lloyd's own step is longer than L-BFGS lets a site go.
  EXPECT_NEAR(lbfgs.energy.back() / lloyd.energy.back(), 1, 0.05);
}

TEST_P(OptimizeTest, SpringsLeadDownFaster) {
  const SurfaceMass uniform(t, std::vector<double>(t.connectivity().vertex_count(), 1.0));
  Tessellation with(uniform, oracle::random_points(t, 400, 3));
  optimize(with, {Method::Lloyd, 100, 0}, {});
  WithoutSprings without(with);
  const OptimizeOptions options{Method::Lbfgs, 15, 0};
  const OptimizeResult a = optimize(with, options, {}), b = optimize(without, options, {});
  EXPECT_LT(a.energy.front() - b.energy.back(), 0.8 * (a.energy.front() - a.energy.back()));
}

TEST_P(OptimizeTest, SitesGoBackToWhereTheyWereSaved) {
  Tessellation s = sites(50);
  const auto before = s.cell_moments();
  s.save();
  optimize(s, {Method::Lloyd, 3, 0}, {});
  s.restore();
  const auto after = s.cell_moments();
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i].m, after[i].m);
    EXPECT_EQ(before[i].h, after[i].h);
  }
}

TEST_P(OptimizeTest, SplittingAllEdgesQuadruplesTheSites) {
  Tessellation s = sites(30);
  optimize(s, {Method::Lbfgs, 50, 1e-3}, {});
  const Connectivity& c = s.delaunay().connectivity();
  std::vector<Halfedge> edges;
  for (std::size_t i = 0; i < c.halfedge_count(); ++i) {
    const Halfedge h{static_cast<std::int32_t>(i)};
    if (c.is_canonical(h)) {
      edges.push_back(h);
    }
  }
  const auto before = s.sites();
  s.split_edges(edges);
  EXPECT_EQ(static_cast<std::int64_t>(s.site_count()), 4 * 30 - 3 * c.euler_number());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(s.sites()[i].face, before[i].face);
  }
  // What the cells were built up to step by step is what they are from the start.
  const Tessellation anew(mass, s.sites());
  const auto got = s.cell_moments(), wanted = anew.cell_moments();
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i].m / wanted[i].m, 1, 1e-7) << i;
    EXPECT_NEAR(got[i].h / wanted[i].h, 1, 1e-6) << i;
  }
}

/// One site, the cell of which pulls it past the rim of the Klein disk, as rounding does far away.
class PulledSite : public SiteSystem {
 public:
  [[nodiscard]] Space space() const override { return {-1}; }
  [[nodiscard]] std::size_t site_count() const override { return 1; }
  void measure(std::vector<CellState>& out) const override { out = {{{1, 1.5, 0, 0.25}, 10}}; }
  void move(const std::vector<Offset>& target) override { reached = target[0]; }
  void save() override {}
  void restore() override {}

  Offset reached;
};

TEST(Optimize, ALongStepStaysInTheHyperbolicPlane) {
  for (const Method method : {Method::Lloyd, Method::Lbfgs}) {
    PulledSite site;
    optimize(site, {method, 1, 0}, {});
    EXPECT_TRUE(std::isfinite(site.reached.h));
    EXPECT_GT(site.reached.x, 10);
    EXPECT_NEAR(site.reached.x * site.reached.x / (site.reached.h * (2 + site.reached.h)), 1, 1e-9);
  }
}

/// One site that can follow so many steps and no more.
class HeldSite : public SiteSystem {
 public:
  explicit HeldSite(int steps) : left_(steps) {}
  [[nodiscard]] Space space() const override { return {0}; }
  [[nodiscard]] std::size_t site_count() const override { return 1; }
  void measure(std::vector<CellState>& out) const override {
    out = {{{1, place, 0, place * place / 2 + 1}, 10}};
  }
  void move(const std::vector<Offset>& target) override {
    place -= target[0].x / 2;
    if (left_-- <= 0) {
      throw NumericalError("no farther");
    }
  }
  void save() override { saved_ = place; }
  void restore() override { place = saved_; }

  double place = 4;

 private:
  int left_;
  double saved_ = 0;
};

TEST(Optimize, WhereNoStepCanBeFollowedIsTheEnd) {
  HeldSite site(1);
  const OptimizeResult out = optimize(site, {Method::Lbfgs, 1000, 1e-9}, {});
  EXPECT_FALSE(out.converged);
  EXPECT_EQ(out.energy.size(), 2);
  EXPECT_EQ(out.evaluations, 1);
  EXPECT_EQ(out.energy.back(), site.place * site.place + 2);
  HeldSite held(0);
  EXPECT_THROW(optimize(held, {Method::Lbfgs, 1000, 1e-9}, {}), NumericalError);
}

/// One site whose cell's mass lies on the far side of the sphere.
class FarSite : public PulledSite {
 public:
  [[nodiscard]] Space space() const override { return {1}; }
  void measure(std::vector<CellState>& out) const override { out = {{{1, 0.6, 0, 1.8}, 1}}; }
};

TEST(Optimize, LloydsStepGoesPastTheHorizon) {
  FarSite site;
  optimize(site, {Method::Lloyd, 1, 0}, {});
  EXPECT_DOUBLE_EQ(site.reached.x, 0.6);
  EXPECT_DOUBLE_EQ(site.reached.h, 1.8);
  optimize(site, {Method::Lbfgs, 1, 0}, {});
  EXPECT_GT(site.reached.x, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Curvatures, OptimizeTest, testing::Values(1.0, 0.0, -1.0));

}  // namespace
}  // namespace ucvt
