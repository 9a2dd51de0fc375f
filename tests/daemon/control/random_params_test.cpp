// Whatever a client sends as params, a method answers: with a result or with one line, and nothing throws.
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "control/protocol.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using nlohmann::json;

constexpr std::array kMethods{"parameter.read", "parameter.write", "parameter.list", "parameter.search",
                              "parameter.diff", "object.read",     "object.write",   "object.list",
                              "fault.list",     "fault.buffer",    "fault.clear",    "input.list",
                              "output.list",    "input.analog",    "load.get",       "plant.get",
                              "plant.set",      "supply.get",      "panel.get",      "panel.take",
                              "panel.set",      "panel.release",   "state.machine",  "identification.get",
                              "encoder.get",    "pdo.list",        "nmt.get",        "store.status",
                              "restore",        "audit.get"};
constexpr std::array kKeys{"axis",
                           "rule",
                           "parameter",
                           "parameters",
                           "value",
                           "filter",
                           "from",
                           "count",
                           "text",
                           "against",
                           "index",
                           "sub_index",
                           "kind",
                           "voltage_V",
                           "direction",
                           "all",
                           "watch",
                           "which",
                           "load_inertia_kgm2",
                           "on",
                           "speed_rpm",
                           "timeout_ms",
                           "ambient_C",
                           "coulomb_friction_Nm"};
const std::vector<json>& scalars() {
  static const std::vector<json> kScalars{nullptr,
                                          true,
                                          false,
                                          0,
                                          1,
                                          2,
                                          -1,
                                          255,
                                          256,
                                          65535,
                                          65536,
                                          1U << 31,
                                          INT64_MIN,
                                          INT64_MAX,
                                          UINT64_MAX,
                                          0.5,
                                          -0.0,
                                          1e308,
                                          -1e308,
                                          1e-308,
                                          "",
                                          "0",
                                          "1",
                                          "infeed",
                                          "p1120",
                                          "r0722.3",
                                          "p1070[1]",
                                          "2/p1120",
                                          "p0840[0].1",
                                          "p99999999",
                                          "6040h",
                                          "1018:04",
                                          "0x",
                                          "h",
                                          ":",
                                          "r0899.2",
                                          "r0722.3 of axis 1",
                                          "nan",
                                          "inf",
                                          "-1e999",
                                          "0xFFFFFFFFFFFFFFFFF",
                                          "p8630[0]",
                                          "r0945[63]",
                                          "p8700[1]",
                                          "1F80h",
                                          "41B6:1",
                                          "2460",
                                          "both",
                                          "stored",
                                          "all",
                                          "\xC3\xA4\xE2\x82\xAC",
                                          std::string(300, 'p'),
                                          "p0731\n",
                                          "[",
                                          "]",
                                          "."};
  return kScalars;
}

class RandomParams : public ControlledUnit {
 protected:
  json value(unsigned depth) {
    const auto choice = random_() % (depth > 2 ? 8U : 10U);
    if (choice < 8) return scalars().at(random_() % scalars().size());
    json made = choice == 8 ? json::array() : json::object();
    for (auto left = random_() % 4; left > 0; --left) {
      if (choice == 8)
        made.push_back(value(depth + 1));
      else
        made[kKeys.at(random_() % kKeys.size())] = value(depth + 1);
    }
    return made;
  }
  json params() {
    if (random_() % 16 == 0) return value(0);
    json made = json::object();
    for (auto left = random_() % 5; left > 0; --left) made[kKeys.at(random_() % kKeys.size())] = value(0);
    return made;
  }

  unsigned seed_ = std::random_device{}();
  std::mt19937 random_{seed_};
};

TEST_F(RandomParams, AreAnswered) {
  constexpr int kRequests = 4000;
  RecordProperty("seed", std::to_string(seed_));
  Configuration configuration = unit_of(2);
  configuration.infeed.emplace();
  switch_on(configuration);

  for (int i = 0; i < kRequests && !HasFailure(); ++i) {
    const char* const method = kMethods.at(random_() % kMethods.size());
    const json params = this->params();
    SCOPED_TRACE("seed " + std::to_string(seed_) + ": " + method + " " +
                 params.dump(-1, ' ', true, json::error_handler_t::replace));
    Outcome outcome;
    ASSERT_NO_THROW(outcome = ask(method, params));
    if (outcome) {
      EXPECT_LE(control::result_line(1, *outcome).size(), control::kMaximumLine);
    } else {
      EXPECT_FALSE(outcome.error().message.empty());
      EXPECT_EQ(outcome.error().message.find('\n'), std::string::npos) << outcome.error().message;
      EXPECT_LE(outcome.error().message.size(), 1000U) << outcome.error().message;
      EXPECT_NO_THROW(static_cast<void>(outcome.error().details.dump()));
    }
    if (i % 50 == 0) run(std::chrono::milliseconds{8});
  }
}

}  // namespace
}  // namespace axisd
