#include <gtest/gtest.h>

#include "injection/language/fault.hpp"
#include "tests/daemon/configuration/bad_file.hpp"

namespace axisd {
namespace {

class BadFaults : public testing::TestWithParam<BadFile> {};

TEST_P(BadFaults, AreRefusedWithFilePlaceAndExpectation) {
  EXPECT_EQ(message_of([] { parse_configuration(GetParam().text, "node.json"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Inject, BadFaults,
    testing::Values(
        BadFile{R"({"inject": {}})", "node.json: /inject: expected an array of 0 to 64, got {}"},
        BadFile{
            R"({"inject": [{"kind": "sdo.late", "delay": 5}]})",
            "node.json: /inject/0/delay: unknown key, expected one of: kind, delay_ms, object, sub_index, server, "
            "step, event, after, every, times, probability, seed, while, until, for_ms"},
        BadFile{R"({"inject": [{"kind": "boot-up.late"}]})",
                "node.json: /inject/0/delay_ms: expected a whole number from 1 to 3600000"},
        BadFile{R"({"inject": [{"kind": "sdo.twice"}, {"kind": "heartbeat.state", "state": "off"}]})",
                "node.json: /inject/1/state: expected stopped, pre-operational or operational, got \"off\""}));

TEST(ConfigurationInject, HasTheFaultsThatTheUnitBeginsWith) {
  const Configuration unit = parse_configuration(
      R"({"inject": [{"kind": "boot-up.late", "delay_ms": 500}, {"kind": "sdo.twice", "after": 3}]})",
      "node.json");

  const auto& faults = unit.inject;
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[0].kind->name, "boot-up.late");
  EXPECT_EQ(faults[0].value(injection::Argument::DelayMs), 500U);
  EXPECT_EQ(faults[1].when.after, 3U);
}

}  // namespace
}  // namespace axisd
