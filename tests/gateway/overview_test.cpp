#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "gateway/api/api.hpp"
#include "gateway/security/access.hpp"
#include "tests/gateway/gateway_fixture.hpp"

namespace gateway {
namespace {

using nlohmann::json;

TEST(Overview, TakesOverWhatItTells) {
  const json status{{"node_id", 5},
                    {"profile", "cia402"},
                    {"version", "1.0"},
                    {"uptime_s", 7.5},
                    {"leds", {{"run", "on"}, {"error", "off"}}},
                    {"bus", {{"link", "up"}, {"queued", 3}}},
                    {"axes",
                     {{{"axis", 1},
                       {"mode", "homing"},
                       {"homed", true},
                       {"speed_rpm", 100},
                       {"statusword", "0x0000"},
                       {"faults", json::array()}}}}};
  EXPECT_EQ(overview_of("vcan0/5", status),
            json::parse(R"({"unit": "vcan0/5", "on": true, "node_id": 5, "profile": "cia402", "uptime_s": 7.5,
                            "leds": {"run": "on", "error": "off"}, "bus": {"link": "up"},
                            "axes": [{"axis": 1, "mode": "homing", "homed": true, "speed_rpm": 100, "faults": []}]})"));
}

TEST(Overview, TellsWhyNothingIsKnownOfAUnit) {
  const Answer off = tl::unexpected{refused_by_daemon(control::ErrorCode::Off, "it is switched off", nullptr)};
  EXPECT_EQ(overview_of("vcan0/5", off), json::parse(R"({"unit": "vcan0/5", "on": false})"));
  const Answer gone = tl::unexpected{refuse(Refused::SilentDaemon, "no answer")};
  EXPECT_EQ(overview_of("vcan0/5", gone),
            json::parse(R"({"unit": "vcan0/5", "on": false, "error": "no answer"})"));
}

class OverviewTest : public testing::Test {
 protected:
  void SetUp() override {
    wait_until(events, [this] { return !daemons.units().empty(); });
  }
  std::size_t asked() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        unit.lines, [](const std::string& line) { return line.find("\"status\"") != std::string::npos; }));
  }

  fakes::TemporaryDirectory folder;
  axisd::ServiceEvents events{[] {}};
  axisd::Log log{axisd::LogLevel::Error};
  FakeDaemon unit{events, folder.path("axisd.sock"), answer_of_unit};
  Daemons daemons{events, std::make_unique<SocketReach>(std::vector{folder.path("axisd.sock")}), log};
};

TEST_F(OverviewTest, IsAskedForOnceForAllWhoAskAtATime) {
  AllUnits all{daemons};
  std::vector<std::shared_ptr<Exchange>> exchanges;
  for (int n = 0; n < 50; ++n) all.answer(exchanges.emplace_back(std::make_shared<Exchange>(Request{})));
  wait_until(events, [this] { return asked() > 0; });
  EXPECT_EQ(asked(), 1U);
}

TEST(TokenState, IsWhatAWriteWouldFind) {
  AccessRules rules{.token = "0123456789abcdef0123456789abcdef"};
  EXPECT_EQ(name_of(token_state(rules, {})), "missing");
  EXPECT_EQ(name_of(token_state(rules, {"Basic 0123456789abcdef0123456789abcdef"})), "missing");
  EXPECT_EQ(name_of(token_state(rules, {"Bearer 0123456789abcdef0123456789abcdee"})), "wrong");
  EXPECT_EQ(name_of(token_state(rules, {"bearer 0123456789abcdef0123456789abcdef"})), "right");
  rules.read_only = true;
  EXPECT_EQ(name_of(token_state(rules, {"Bearer 0123456789abcdef0123456789abcdef"})), "none");
}

}  // namespace
}  // namespace gateway
