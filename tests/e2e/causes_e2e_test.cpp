#include <chrono>
#include <functional>
#include <string>

#include "drive/messages/fault_table.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

using nlohmann::json;

constexpr std::uint16_t kParameter = 0x2000;  // object of parameter 0

/// The default motor with hardly any metal to warm.
const json kSmallMotor{{"winding_capacity_J_per_K", 2.0}, {"frame_capacity_J_per_K", 20.0}};

/// A daemon with one axis, and a master that provokes what it reports.
struct Bench {
  explicit Bench(const json& axis, const json& supply)
      : daemon{{.axis = axis.is_null() ? json{{"name", "X"}} : axis, .supply = supply, .motor = kSmallMotor}} {
    messages.listen_to({0x085});
  }

  /// Shows the parameters of the axis in the object dictionary.
  void open_window() { ASSERT_EQ(sdo.download(0x41B6, 0, 2, 2), 0U); }
  void write(std::uint16_t parameter, float value) {
    ASSERT_EQ(sdo.download(static_cast<std::uint16_t>(kParameter + parameter), 0,
                           std::bit_cast<std::uint32_t>(value), 4),
              0U);
  }
  void load(const std::string& torque) { ASSERT_EQ(daemon.axisctl({"load", "1", torque}).status, 0); }
  /// Whether the EMCY of @p number comes from the axis.
  testing::AssertionResult reports(std::uint16_t number) {
    const std::string what = drive::fault_text(*drive::find_fault(number));
    return messages.wait_until("EMCY of " + what, [=](const canopen::Frame& frame) {
      return frame.id == 0x085 && canopen::load<std::uint16_t>(&frame.data[3]) == number && frame.data[5] == 2;
    });
  }
  /// Whether alarm @p number comes; it has no EMCY, and may be gone again.
  testing::AssertionResult warns(std::uint16_t number) {
    json buffer;
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < end) {
      buffer = json::parse(daemon.axisctl({"--json", "fault", "buffer", "1"}).output);
      for (const json& alarm : buffer.at("alarms"))
        if (alarm.at("number") == number) return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << "no alarm " << number << ": " << buffer.dump(2);
  }

  /// Waits until the motor turns at 3000 rpm.
  void turn_at_rated_speed() {
    constexpr std::int32_t kAlmost = 0x0C600000;  // increments/s
    ASSERT_NO_FATAL_FAILURE(make_motor_turn(can));
    ASSERT_TRUE(
        wait_for_drive(can, "rated speed", [](const StatusAndSpeed& drive) { return drive.speed > kAlmost; }));
  }

  CanClient can{kTestInterface};
  CanClient messages{kTestInterface};
  BusSdoClient sdo;
  DaemonProcess daemon;
};

/// A physical cause, how it comes about and the messages that it ends in.
struct Cause {
  const char* name;
  json axis;
  json supply;
  void (*provoke)(Bench& bench);
  std::uint16_t warning;  ///< before the fault, 0 = none
  std::uint16_t fault;
};

void PrintTo(const Cause& cause, std::ostream* out) {
  *out << cause.name;
}

/// The default axis with @p more keys.
json axis_with(const json& more) {
  json axis{{"name", "X"}};
  axis.update(more);
  return axis;
}

const std::vector<Cause> kCauses{
    {"InductionMotorSwitchedStraightToItsFrequency",
     axis_with({{"type", "vector"},
                {"motor", "1le1003-2k2"},
                {"power_unit", {{"rated_current_A", 5}, {"trip_current_A", 15}}},
                {"parameters", {{"p1300", 0}, {"p1120", 0.0}}}}),
     nullptr,
     [](Bench& bench) {
       enable_operation(bench.can);
       bench.can.send("305#0F000000800C");  // it trips before it turns
     },
     0, 30001},
    {"OvervoltageWithoutChopper",
     axis_with({{"load", {{"inertia", 0.05}}}, {"parameters", {{"p1120", 0.5}, {"p1135", 0.1}}}}),
     {{"chopper_ohm", 0}},
     [](Bench& bench) {
       ASSERT_NO_FATAL_FAILURE(bench.turn_at_rated_speed());
       bench.can.send("205#0B00");  // OFF3
     },
     0,
     30002},
    {"UndervoltageAfterAMainsFailure", nullptr, nullptr,
     [](Bench& bench) {
       make_motor_turn(bench.can);
       bench.load("5");
       ASSERT_EQ(bench.daemon.axisctl({"supply", "0"}).status, 0);
     },
     0, 30003},
    {"PowerUnitOverload",
     axis_with(
         {{"power_unit", {{"rated_current_A", 2}, {"maximum_current_A", 10}, {"overload_time_constant_s", 1}}}}),
     nullptr,
     [](Bench& bench) {
       make_motor_turn(bench.can);
       bench.load("6");
     },
     7805, 30005},
    {"MotorTooHot", axis_with({{"parameters", {{"p0604", 60.0}, {"p0605", 70.0}}}, {"motor", "./motor.json"}}),
     nullptr,
     [](Bench& bench) {
       make_motor_turn(bench.can);
       bench.load("25");
     },
     7910, 7011},
    {"Jammed", axis_with({{"load", {{"friction", {{"coulomb", 60}}}}}, {"parameters", {{"p2177", 0.1}}}}), nullptr,
     [](Bench& bench) {
       enable_operation(bench.can);
       bench.can.send("305#0F000000800C");
     },
     0, 7900},
    {"RunningAwayUnderItsLoad", nullptr, nullptr,
     [](Bench& bench) {
       enable_operation(bench.can);
       bench.load("-60");
     },
     0, 7901},
    {"PulsesOfTheEncoderLost", nullptr, nullptr,
     [](Bench& bench) {
       make_motor_turn(bench.can);
       ASSERT_EQ(bench.daemon.axisctl({"encoder", "1", "lost_pulses"}).status, 0);
     },
     0, 31100},
    {"EncoderWithoutSignals", nullptr, nullptr,
     [](Bench& bench) {
       make_motor_turn(bench.can);
       ASSERT_EQ(bench.daemon.axisctl({"encoder", "1", "loss"}).status, 0);
     },
     0, 31116},
    {"ImpossibleMotorData", nullptr, nullptr,
     [](Bench& bench) {
       bench.open_window();
       ASSERT_EQ(bench.sdo.download(kParameter + 10, 0, 3, 2), 0U);  // p0010
       bench.write(341, 0.0F);
       ASSERT_EQ(bench.sdo.download(kParameter + 10, 0, 0, 2), 0U);
     },
     0, 7950},
};

struct Causes : testing::TestWithParam<Cause> {};

TEST_P(Causes, EndInTheirMessage) {
  const Cause& cause = GetParam();
  Bench bench{cause.axis, cause.supply};
  ASSERT_TRUE(bench.daemon.is_ready());

  ASSERT_NO_FATAL_FAILURE(cause.provoke(bench));

  if (cause.warning != 0) {
    EXPECT_TRUE(bench.warns(cause.warning));
  }
  EXPECT_TRUE(bench.reports(cause.fault));
}

INSTANTIATE_TEST_SUITE_P(Physics, Causes, testing::ValuesIn(kCauses),
                         [](const auto& test) { return std::string{test.param.name}; });

}  // namespace
}  // namespace e2e
