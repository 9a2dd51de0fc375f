#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cia402/face.hpp"
#include "device/device.hpp"
#include "tests/device/recording_listener.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/vector_bus.hpp"
#include "tests/sdo/sdo_client.hpp"

namespace cia402 {

using namespace std::chrono_literals;

/// Frames in the notation of candump, in the order of their transmission.
using Lines = std::vector<std::string>;

/// Increments, and with the factory settings position units, of a revolution of the motor.
inline constexpr std::int32_t kRevolution = 65536;

/// A CiA 402 device, node 5, on a bus of its own, with a clock that the test moves. Objects of axis n have their
/// indices 800h·(n-1) higher.
class TestDevice : public sdo_test::SdoClient {
 public:
  explicit TestDevice(const Configuration& configuration = {.node_id = 5});

  /// Power-on; what the device sent.
  Lines start();
  /// Power-on and the command to Operational; what the device sent last.
  Lines start_operational();
  /// Operational, Operation enabled in @p mode (6060h).
  void enable(Mode mode);

  /// A frame comes from the bus; what the device sends at once.
  Lines says(std::string_view frame);
  /// Time passes; what the device sends.
  Lines passes(canopen::Duration time);
  /// Cycles pass until the statusword has @p value under @p mask; false if that takes longer than @p limit.
  bool reaches(std::uint16_t mask, std::uint16_t value, canopen::Duration limit);

  /// Writes an object over SDO with the size that it has; 0 or the abort code.
  std::uint32_t write(std::uint16_t index, std::uint8_t sub_index, std::int64_t value);
  std::uint32_t write(std::uint16_t index, std::int64_t value) { return write(index, 0, value); }
  /// Reads a number over SDO, with its sign if its type has one; a test fails on an abort.
  std::int64_t read(std::uint16_t index, std::uint8_t sub_index = 0);
  std::uint16_t statusword() { return static_cast<std::uint16_t>(read(0x6041)); }
  std::int64_t position() { return read(0x6064); }
  std::int64_t velocity() { return read(0x606C); }

  static constexpr canopen::TimePoint kStart{1h};
  canopen::TimePoint now = kStart;
  fakes::VectorBus bus;
  device::RecordingListener listener;
  device::Device device;

 private:
  Lines sent();
  std::optional<canopen::Frame> ask(const canopen::Frame& request) override;
};

/// Those of @p lines that come from @p identifier, such as "185#".
Lines from(std::string_view identifier, const Lines& lines);

}  // namespace cia402
