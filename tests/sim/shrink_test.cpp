#include "sim/plan/shrink.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace sim {
namespace {

TEST(Shrink, LeavesWhatIsNeededToFail) {
  WorldPlan plan = draw_plan(1);
  for (std::uint64_t seed = 2; plan.units.size() < 4; ++seed) plan = draw_plan(seed);
  plan.faults.push_back({.kind = "power.cut", .at = std::chrono::seconds{1}, .lasting = {}, .unit = 2});
  const auto fails = [](const WorldPlan& tried) {
    return std::ranges::any_of(tried.faults, [](const FaultPlan& each) { return each.kind == "power.cut"; });
  };

  const WorldPlan small = shrink(plan, fails);
  ASSERT_EQ(small.units.size(), 1U);
  EXPECT_EQ(small.units[0].configuration["axes"].size(), 1U);
  ASSERT_EQ(small.faults.size(), 1U);
  EXPECT_EQ(small.faults[0].kind, "power.cut");
  EXPECT_EQ(small.faults[0].unit, 0U);
  EXPECT_FALSE(small.units[0].stores || small.units[0].restarts || small.units[0].is_intruded);
}

}  // namespace
}  // namespace sim
