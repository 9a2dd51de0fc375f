#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "can/port/socketcan/socket_can.hpp"
#include "libcanopen/base/frame.hpp"
#include "tests/e2e/test_bus.hpp"

namespace e2e {

/// A raw socket on a CAN interface that speaks in candump's notation: "605#4000100000000000".
class CanClient {
 public:
  /// Opens @p interface (test_bus.hpp); throws std::runtime_error that says how to get one.
  explicit CanClient(const std::string& interface);

  /// Sends the frame that @p text describes, as soon as there is room; throws std::runtime_error if the interface
  /// refuses it.
  void send(std::string_view text) { send(frame(text)); }
  void send(const canopen::Frame& frame);
  /// The next frame under the identifier of @p text is @p text; frames under others are passed over.
  testing::AssertionResult expect(std::string_view text);
  /// Some later frame is @p text.
  testing::AssertionResult wait_for(std::string_view text);
  /// Some later frame satisfies @p wanted, which @p what describes.
  testing::AssertionResult wait_until(const std::string& what,
                                      const std::function<bool(const canopen::Frame&)>& wanted);
  /// Sends @p request, and the next frame under the identifier of @p answer is @p answer.
  testing::AssertionResult ask(std::string_view request, std::string_view answer);

  /// The next frame of any identifier, nothing if none comes in time.
  std::optional<canopen::Frame> next();
  /// The next frame, if it is there already.
  std::optional<canopen::Frame> next_waiting();
  /// Forgets all frames that are there already.
  void forget();
  /// Delivers from now on only data frames of these identifiers.
  void listen_to(const std::vector<std::uint32_t>& identifiers);

 private:
  static canopen::Frame frame(std::string_view text);
  std::optional<canopen::Frame> note(const canopen::Frame& frame);
  testing::AssertionResult failure(const std::string& what) const;

  bus::SocketCan port_;
  std::vector<std::string> seen_;  // since the last frame that was waited for
};

/// Bits of the statusword 6041h that make a state (CiA 402).
struct DriveState {
  const char* name;
  std::uint16_t mask;
  std::uint16_t value;
};
inline constexpr DriveState kSwitchOnDisabled{"Switch on disabled", 0x4F, 0x40};
inline constexpr DriveState kReadyToSwitchOn{"Ready to switch on", 0x6F, 0x21};
inline constexpr DriveState kSwitchedOn{"Switched on", 0x6F, 0x23};
inline constexpr DriveState kOperationEnabled{"Operation enabled", 0x6F, 0x27};
inline constexpr DriveState kQuickStopActive{"Quick stop active", 0x6F, 0x07};
inline constexpr DriveState kFaultReactionActive{"Fault reaction active", 0x4F, 0x0F};
inline constexpr DriveState kFault{"Fault", 0x4F, 0x08};

/// Statusword bits of their own.
inline constexpr std::uint16_t kTargetReached = 0x0400;
inline constexpr std::uint16_t kStandstill = 0x1000;

/// What TPDO 2 of a new unit carries: 6041h and 606Ch.
struct StatusAndSpeed {
  std::uint16_t statusword;
  std::int32_t speed;  ///< increments/s, 2048 x 2048 a turn

  bool is(const DriveState& state) const noexcept { return (statusword & state.mask) == state.value; }
  bool has(std::uint16_t bit) const noexcept { return (statusword & bit) != 0; }
};
/// Waits until TPDO 2 of node 5 (285h) shows @p wanted, which @p what describes.
testing::AssertionResult wait_for_drive(CanClient& can, const std::string& what,
                                        const std::function<bool(const StatusAndSpeed&)>& wanted);
/// Waits until the drive is in @p state.
testing::AssertionResult wait_for_state(CanClient& can, const DriveState& state);
/// Takes a new unit of node 5 to Operational and to Operation enabled at standstill; a test fails where it does
/// not get on.
void enable_operation(CanClient& can);
/// Takes a new unit of node 5 to Operational and through the states until its motor turns; a test fails where it
/// does not get on.
void make_motor_turn(CanClient& can);

}  // namespace e2e
