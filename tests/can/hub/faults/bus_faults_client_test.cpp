#include <gtest/gtest.h>

#include "can/bus_faults/bus_faults.hpp"
#include "injection/kinds/bus_kinds.hpp"
#include "tests/can/hub/old_hub.hpp"
#include "tests/can/hub/running_hub.hpp"

namespace hub_test {
namespace {

using nlohmann::json;

TEST(BusFaultsClient, InjectsListsAndTakesBack) {
  RunningHub hub;
  const userbus::Path path = path_of(hub.path());

  EXPECT_EQ(bus_faults::inject(path, "bus.drop id=185").value(), 1u);
  EXPECT_EQ(bus_faults::inject(path, json{{"kind", "bus.delay"}, {"delay_ms", 5}}).value(), 2u);
  const json faults = bus_faults::list(path).value();
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[1]["fault"], (json{{"kind", "bus.delay"}, {"delay_ms", 5}}));
  EXPECT_EQ(bus_faults::take_back(path, 1).value(), 1u);
  EXPECT_EQ(bus_faults::take_back(path, std::nullopt).value(), 1u);
  EXPECT_EQ(bus_faults::list(path).value(), json::array());
}

TEST(BusFaultsClient, GetsListsThatNoMessageHolds) {
  RunningHub hub;
  const userbus::Path path = path_of(hub.path());
  for (int i = 0; i < 60; ++i)
    ASSERT_TRUE(bus_faults::inject(path, "bus.cut members=unix:" + std::string(180, 'x')));

  EXPECT_EQ(bus_faults::list(path).value().size(), 60u);
  EXPECT_EQ(bus_faults::kinds(path).value().size(), injection::bus_kinds().size());
}

TEST(BusFaultsClient, SaysWhatIsWrong) {
  RunningHub hub;
  const auto wrong = bus_faults::inject(path_of(hub.path()), "bus.delay");
  const auto nobody = bus_faults::list(path_of(hub.path() + "-none"));

  ASSERT_FALSE(wrong);
  EXPECT_TRUE(wrong.error().by_hub);
  EXPECT_EQ(wrong.error().text, "delay_ms: expected a whole number from 1 to 3600000, got nothing");
  ASSERT_FALSE(nobody);
  EXPECT_FALSE(nobody.error().by_hub);
  EXPECT_EQ(nobody.error().text, hub.path() + "-none: is not served");
}

TEST(BusFaultsClient, TellsAHubThatHasNoFaultsYet) {
  const OldHub hub;
  const auto answer = bus_faults::inject(path_of(hub.path()), "bus.drop");

  ASSERT_FALSE(answer);
  EXPECT_FALSE(answer.error().by_hub);
  EXPECT_EQ(answer.error().text, hub.path() + ": its hub is of an older version, which has no faults");
}

}  // namespace
}  // namespace hub_test
