#pragma once

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "device/device.hpp"
#include "tests/device/recording_listener.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/vector_bus.hpp"
#include "tests/sdo/sdo_client.hpp"

namespace device {

using namespace std::chrono_literals;

/// Frames in the notation of candump, in the order of their transmission.
using Lines = std::vector<std::string>;

/// A line of a dialogue: what a master sends and what the unit answers at once, "" for silence.
struct Exchange {
  std::string_view request, answer;
};

using sdo_test::Upload;

/// One revolution per second in the increments of the default encoder (60FFh, 606Ch).
inline constexpr std::int32_t kRevolution = 4194304;
/// A speed as 60FFh and 606Ch show it (increments/s).
constexpr double bus_speed(double rpm) {
  return rpm / 60.0 * kRevolution;
}

/// The configuration of node 5 with @p presets over its parameters.
Configuration unit_with(std::vector<ParameterPreset> presets);

/// Node 5 on a bus of its own, with a clock that the test moves.
class TestUnit : public sdo_test::SdoClient {
 public:
  explicit TestUnit(const Configuration& configuration = unit_with({})) : device{configuration, bus, listener} {}

  /// Power-on; what the unit sent.
  Lines start();
  /// Power-on, a moment of rest and the command to Operational; what the unit sent last.
  Lines start_operational();
  /// Operational and through the states to Operation enabled.
  void enable();
  /// Operation enabled and turning at @p rpm, after @p time.
  void turn_at(double rpm, canopen::Duration time);

  /// A frame comes from the bus; what the unit sends at once.
  Lines says(std::string_view frame);
  /// Time passes; what the unit sends.
  Lines passes(canopen::Duration time);
  /// A frame comes from the bus; what the unit sends at once and in the cycle that follows.
  Lines cycles_with(std::string_view frame);
  /// Cycles pass until a statusword has @p value under @p mask; false if that takes longer than @p limit.
  bool reaches(std::uint16_t mask, std::uint16_t value, canopen::Duration limit);

  /// Plays @p exchanges in order and compares every answer.
  void expect_dialogue(std::initializer_list<Exchange> exchanges);

  /// 6041h as read over SDO.
  std::uint16_t statusword() { return static_cast<std::uint16_t>(upload(0x6041).number()); }
  /// 606Ch as read over SDO (increments/s).
  std::int32_t velocity() {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(upload(0x606C).number()));
  }

  static constexpr canopen::TimePoint kStart{1h};
  canopen::TimePoint now = kStart;
  fakes::VectorBus bus;
  RecordingListener listener;
  Device device;

 private:
  Lines sent();
  std::optional<canopen::Frame> ask(const canopen::Frame& request) override;
};

/// Those of @p lines that come from @p identifier, such as "185#".
Lines from(std::string_view identifier, const Lines& lines);

/// The four TPDOs of a unit that stands still at position 0 with @p statusword.
Lines at_rest(std::uint16_t statusword);

}  // namespace device
