// Faults and alarms over the control socket: what is active, what was, and how the buffers are cleared.
#include <gtest/gtest.h>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

struct MessageMethods : ControlledUnit {
  void inject(int axis, int number, unsigned value = 0) {
    result_of("fault.inject", {{"axis", axis}, {"number", number}, {"value", value}});
  }
  json list(const json& axis = nullptr) { return result_of("fault.list", {{"axis", axis}}).at("messages"); }
  json buffer(const json& axis) { return result_of("fault.buffer", {{"axis", axis}}); }
};

TEST_F(MessageMethods, AreSilentWhereNothingIs) {
  EXPECT_EQ(list(), json::array());
  const json empty = buffer(1);
  EXPECT_EQ(empty.at("faults"), json::array());
  EXPECT_EQ(empty.at("alarms"), json::array());
  EXPECT_EQ(empty.at("fault_cases"), 0);
}

TEST_F(MessageMethods, TellWhatIsActiveWhereAndSinceWhen) {
  switch_on(unit_of(2));
  run(std::chrono::seconds{2});
  inject(2, 7900, 3);
  inject(0, 1002, 7);
  inject(1, 7012);

  const json all = list();
  ASSERT_EQ(all.size(), 3U);
  const json fault = list(2).at(0);
  EXPECT_EQ(fault.at("axis"), 2);
  EXPECT_EQ(fault.at("drive_object"), 3);
  EXPECT_EQ(fault.at("kind"), "fault");
  EXPECT_EQ(fault.at("code"), "F07900");
  EXPECT_EQ(fault.at("value"), 3);
  EXPECT_NEAR(fault.at("t").get<double>(), 2.0, 0.1);
  EXPECT_EQ(fault.at("reaction"), "OFF2");
  EXPECT_EQ(fault.at("acknowledge"), "immediately");
  EXPECT_EQ(list(0).at(0).at("value"), 7);
  EXPECT_EQ(list(1).at(0).at("kind"), "alarm");
}

TEST_F(MessageMethods, ShowTheCasesThatWere) {
  inject(1, 7900, 3);
  run(std::chrono::milliseconds{100});
  result_of("fault.ack", {{"axis", 1}});
  inject(1, 7860);
  inject(1, 7012);

  const json buffers = buffer(1);
  ASSERT_EQ(buffers.at("faults").size(), 2U);
  EXPECT_EQ(buffers.at("faults").at(0).at("code"), "F07860");
  EXPECT_EQ(buffers.at("faults").at(0).at("is_active"), true);
  EXPECT_EQ(buffers.at("faults").at(1).at("code"), "F07900");
  EXPECT_EQ(buffers.at("faults").at(1).at("case"), 1);
  EXPECT_EQ(buffers.at("faults").at(1).at("value"), 3);
  EXPECT_GT(buffers.at("faults").at(1).at("removed_s"), buffers.at("faults").at(1).at("received_s"));
  EXPECT_EQ(buffers.at("fault_cases"), 2);
  EXPECT_EQ(buffers.at("alarms").at(0).at("code"), "A07012");
  EXPECT_FALSE(result_of("fault.buffer", {{"axis", 1}, {"kind", "faults"}}).contains("alarms"));
}

TEST_F(MessageMethods, TellTheirTimesInUtcOnceTheUnitHasOne) {
  inject(1, 7900);
  EXPECT_FALSE(list().at(0).contains("utc"));
  EXPECT_FALSE(result_of("status").contains("utc"));
  const auto write = [&](std::uint16_t number, std::size_t index, double value) {
    EXPECT_TRUE(unit().device().write_parameter(1, number, index, value, now()));
  };
  write(3100, 0, 1.0);
  EXPECT_EQ(result_of("status").at("utc"),
            (json{{"time", "1970-01-01T00:00:00.000Z"}, {"synchronised", false}, {"method", "ping-snap"}}));
  write(3103, 0, 2.0);
  write(3101, 1, 20779.0);
  write(3101, 0, 86'399'750.0);
  run(std::chrono::milliseconds{500});

  result_of("fault.ack", {{"axis", 1}});
  inject(1, 7860);

  const std::string after_midnight = "2026-11-23T00:00:00.250Z";
  EXPECT_EQ(result_of("status").at("utc"),
            (json{{"time", after_midnight}, {"synchronised", true}, {"method", "simple"}}));
  EXPECT_EQ(list().at(0).at("utc"), after_midnight);
  const json faults = buffer(1).at("faults");
  EXPECT_EQ(faults.at(0).at("received_utc"), after_midnight);
  EXPECT_FALSE(faults.at(0).contains("removed_utc"));
  EXPECT_FALSE(faults.at(1).contains("received_utc")) << "there was none then";
  EXPECT_EQ(faults.at(1).at("removed_utc"), after_midnight);
}

TEST_F(MessageMethods, TakeTheTimeOfTheHostOnRequest) {
  const auto wall = [] { return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()); };
  EXPECT_TRUE(unit().device().write_parameter(1, 3103, 0, 4.0, now()));
  EXPECT_TRUE(unit().device().write_parameter(1, 3100, 0, 1.0, now()));

  const auto before = wall().time_since_epoch().count();
  const json clock = result_of("status").at("utc");
  const auto after = wall().time_since_epoch().count();

  EXPECT_EQ(clock.at("synchronised"), true);
  EXPECT_EQ(clock.at("method"), "host");
  const auto told = unit().device().unit().control_unit().clock().line().utc().value_or(0);
  EXPECT_LE(before, static_cast<std::int64_t>(told));
  EXPECT_LE(static_cast<std::int64_t>(told), after);
}

TEST_F(MessageMethods, ClearTheBuffersButNotWhatIsActive) {
  inject(1, 7900);
  result_of("fault.ack", {{"axis", 1}});
  inject(1, 7860);

  result_of("fault.clear", {{"axis", 1}});

  const json buffers = buffer(1);
  ASSERT_EQ(buffers.at("faults").size(), 1U);
  EXPECT_EQ(buffers.at("faults").at(0).at("code"), "F07860");
}

TEST_F(MessageMethods, RefuseWhatThereIsNot) {
  EXPECT_EQ(error_of("fault.buffer").code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("fault.buffer", {{"axis", 9}}).code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("fault.clear", {{"axis", 1}, {"kind", "some"}}).code, ErrorCode::BadParameter);
}

}  // namespace
}  // namespace axisd
