#include <set>
#include <string>

#include <gtest/gtest.h>

#include "sim/plan/fault_kinds.hpp"
#include "sim/plan/world_plan.hpp"

namespace sim {
namespace {

TEST(WorldPlan, OfASeedIsAlwaysTheSame) {
  EXPECT_EQ(json_of(draw_plan(7)), json_of(draw_plan(7)));
  EXPECT_NE(json_of(draw_plan(7)), json_of(draw_plan(8)));
}

TEST(WorldPlan, IsReadAsItIsWritten) {
  for (std::uint64_t seed = 1; seed < 100; ++seed) {
    const auto said = json_of(draw_plan(seed));
    const auto plan = read_plan(said.dump());
    ASSERT_TRUE(plan) << plan.error();
    EXPECT_EQ(json_of(*plan), said);
  }
}

TEST(WorldPlan, HasFromOneUnitToTwentyAndEveryKindOfFault) {
  std::set<std::size_t> units;
  std::set<std::size_t> axes;
  std::set<std::string> kinds;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const WorldPlan plan = draw_plan(seed);
    units.insert(plan.units.size());
    for (const UnitPlan& unit : plan.units) axes.insert(unit.configuration["axes"].size());
    for (const FaultPlan& fault : plan.faults) kinds.insert(fault.kind);
    EXPECT_FALSE(plan.faults.empty()) << "seed " << seed;
  }
  EXPECT_EQ(*units.begin(), 1U);
  EXPECT_EQ(*units.rbegin(), 20U);
  EXPECT_EQ(axes, (std::set<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(kinds.size(), fault_kinds().size());
}

TEST(WorldPlan, IsRefusedWithAReason) {
  EXPECT_EQ(read_plan(R"({"units": []})").error(), "units: expected one at least");
  EXPECT_EQ(
      read_plan(R"({"units": [{"configuration": {}}], "faults": [{"kind": "power.cut", "at_ms": 1, "unit": 1}]})")
          .error(),
      "faults: there is no unit 1");
  const auto with_fault = [](const std::string& fault) {
    return read_plan(R"({"units": [{"configuration": {}}], "faults": [{"at_ms": 1, )" + fault + "}]}").error();
  };
  EXPECT_EQ(with_fault(R"("kind": "power.gone")"), "faults: there is no kind \"power.gone\"");
  EXPECT_EQ(with_fault(R"("kind": "pow\rer.off")"), R"(faults: there is no kind "pow\rer.off")")
      << "no control character";
  EXPECT_EQ(with_fault(R"("kind": "drive.load", "number": 13)"),
            "faults: number of drive.load: expected -12 to 12, got 13");
  EXPECT_EQ(with_fault(R"("kind": "bus", "words": "bus.drop times=x")").rfind("faults: words \"bus.drop", 0), 0U);
  EXPECT_NE(with_fault(R"("kind": "unit", "words": "bus.drop")"), "");
  EXPECT_FALSE(read_plan("{"));
  EXPECT_FALSE(read_plan("[]"));
}

}  // namespace
}  // namespace sim
