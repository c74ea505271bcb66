#include "cvt/multilevel.h"

#include <gtest/gtest.h>

namespace ucvt {
namespace {

TEST(Multilevel, LevelsLeadToTheNumberAskedFor) {
  for (const std::int64_t euler_number : {2, 0, -2, -10}) {
    for (int sites = 4; sites < 3000; sites += 7) {
      const LevelPlan plan = plan_levels(sites, euler_number);
      EXPECT_EQ(sites_on_level(sites, euler_number, plan.levels), plan.coarsest);
      EXPECT_EQ(sites_on_level(sites, euler_number, 0), sites);
      for (int left = plan.levels; left > 0; --left) {
        const int coarse = sites_on_level(sites, euler_number, left);
        const int fine = sites_on_level(sites, euler_number, left - 1);
        // Splitting all edges would give the number of the next level, or up to three more.
        const std::int64_t all = 4 * coarse - 3 * euler_number;
        EXPECT_LE(fine, all);
        EXPECT_GE(fine, all - 3);
      }
    }
  }
}

TEST(Multilevel, TheFirstLevelIsSmall) {
  for (const int sites : {500, 1000, 2000, 10000, 123456}) {
    const LevelPlan plan = plan_levels(sites, 2);
    EXPECT_GE(plan.coarsest, 32);
    EXPECT_LE(plan.coarsest, 160);
  }
  EXPECT_EQ(plan_levels(20, 2).levels, 0);
}

}  // namespace
}  // namespace ucvt
