#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

// Objects of CiA 402-2 of the first axis that checks name.
inline constexpr std::uint16_t kControlword = 0x6040, kStatusword = 0x6041, kMode = 0x6060, kModeDisplay = 0x6061,
                               kPosition = 0x6064, kVelocity = 0x606C, kTargetPosition = 0x607A,
                               kProfileVelocity = 0x6081, kAcceleration = 0x6083, kDeceleration = 0x6084,
                               kTargetVelocity = 0x60FF, kSupportedModes = 0x6502;

/// A state of the state machine (CiA 402-2): the statusword masked.
struct DriveState {
  std::uint16_t mask = 0, bits = 0;
  const char* name = "";
  [[nodiscard]] constexpr bool is(std::uint64_t statusword) const noexcept { return (statusword & mask) == bits; }
};
inline constexpr DriveState kSwitchOnDisabled{0x4F, 0x40, "Switch on disabled"},
    kReadyToSwitchOn{0x6F, 0x21, "Ready to switch on"}, kSwitchedOn{0x6F, 0x23, "Switched on"},
    kOperationEnabled{0x6F, 0x27, "Operation enabled"}, kQuickStopActive{0x6F, 0x07, "Quick stop active"},
    kFault{0x4F, 0x08, "Fault"};
/// The state that @p statusword tells, in words.
[[nodiscard]] std::string state_in(std::uint64_t statusword);

// Commands of the controlword.
inline constexpr std::uint16_t kDisableVoltage = 0x0000, kQuickStop = 0x0002, kShutdown = 0x0006,
                               kSwitchOn = 0x0007, kEnableOperation = 0x000F, kFaultReset = 0x0080, kHalt = 0x0100;
// Bits of the statusword.
inline constexpr std::uint16_t kFaultBit = 0x0008, kTargetReached = 0x0400, kBit12 = 0x1000, kBit13 = 0x2000;

/// Modes of operation, as 6060h has them.
enum class DriveMode : std::uint8_t { None = 0, ProfilePosition = 1, ProfileVelocity = 3, Homing = 6 };

/// How long a drive may take from a command to the state that it leads to, brakes and ramps included.
inline constexpr canopen::Duration kStatePatience = std::chrono::seconds{3};
/// How long a bit of the statusword may take that follows from a write.
inline constexpr canopen::Duration kBitPatience = std::chrono::milliseconds{500};
/// How often a value is read that must not be missed.
inline constexpr canopen::Duration kSample = std::chrono::milliseconds{5};
/// For how long a drive is watched that must not do anything.
inline constexpr canopen::Duration kWatch = std::chrono::milliseconds{200};

/// One axis of a drive, moved over SDO. Set-points and modes are restored behind the check as all values are;
/// controlwords are not: they are commands.
class Axis {
 public:
  /// The axis whose objects lie @p offset above those of the first.
  Axis(Context& context, std::uint16_t offset) : context_{&context}, offset_{offset} {}

  [[nodiscard]] Context& context() noexcept { return *context_; }
  /// Index of @p object of this axis.
  [[nodiscard]] std::uint16_t at(std::uint16_t object) const noexcept {
    return static_cast<std::uint16_t>(object + offset_);
  }

  /// The check does not apply to this axis, for @p reason; false.
  bool skip(std::string reason);
  [[nodiscard]] const std::optional<std::string>& skipped() const noexcept { return skipped_; }
  /// A finding about @p object of this axis; false.
  bool fail(std::uint16_t object, std::string expected, std::string found);

  /// True if the EDS, or without one the node, has the entry.
  [[nodiscard]] bool has(std::uint16_t object, std::uint8_t sub_index = 0);
  /// False, and the axis is skipped, unless all are there.
  bool needs(std::initializer_list<std::uint16_t> objects);
  /// The number in an entry; 0 where it cannot be read.
  [[nodiscard]] std::uint64_t number(std::uint16_t object, std::uint8_t sub_index = 0);
  /// The same of a signed type.
  [[nodiscard]] std::int64_t value(std::uint16_t object, std::uint8_t sub_index = 0);
  SdoAnswer write(std::uint16_t object, std::int64_t value, std::uint8_t sub_index = 0);
  /// Writes what a check needs; false, and the axis is skipped, where it is refused.
  bool set(std::uint16_t object, std::int64_t value, std::uint8_t sub_index = 0);
  /// The same, or nothing where there is no such object: true.
  bool set_if_there(std::uint16_t object, std::int64_t value, std::uint8_t sub_index = 0);

  /// Writes the controlword.
  void command(std::uint16_t word);
  [[nodiscard]] std::uint16_t status();
  /// Asks until @p condition holds, less and less often down to every @p pause; false if it does not within
  /// @p patience.
  bool await(canopen::Duration patience, std::predicate auto condition,
             canopen::Duration pause = std::chrono::milliseconds{50}) {
    Session& session = context_->session();
    const canopen::TimePoint begin = session.now();
    while (!session.ended()) {
      if (condition()) return true;
      const canopen::Duration waited = session.now() - begin;
      if (waited >= patience) return false;
      session.pass(std::min(pause, kSample + waited / 10));
    }
    return false;
  }
  /// Waits for a state.
  bool reaches(const DriveState& state, canopen::Duration patience = kStatePatience);
  /// Waits until the statusword has @p bits, of those in @p mask.
  bool shows(std::uint16_t mask, std::uint16_t bits, canopen::Duration patience = kBitPatience);

  /// True if 6502h has it.
  [[nodiscard]] bool supports(DriveMode mode);
  /// Writes 6060h and waits for 6061h; false, and the axis is skipped, if that does not follow.
  bool enter(DriveMode mode);
  /// To Switch on disabled from wherever it is, faults included; false, and the axis is skipped, if it does not.
  bool disable();
  /// To Operation enabled; false, and the axis is skipped, if it does not get there.
  bool enable();
  /// Brakes with a quick stop and disables the drive, even after an interruption.
  void rest();

 private:
  bool switch_off();

  Context* context_;
  std::uint16_t offset_;
  std::optional<std::string> skipped_;
};

/// Offsets of the axes that have @p object; without any the check is skipped.
[[nodiscard]] std::vector<std::uint16_t> axes_with(Context& context, std::uint16_t object);

/// Runs @p check on each axis with a controlword, one after the other, in Operational; each begins in Switch on
/// disabled and is left there. The check is skipped if it does not apply to any of them.
void on_each_axis(Context& context, void (*check)(Axis&));

/// The row of a check that moves: @p Each runs on each axis.
template <void (*Each)(Axis&)>
constexpr Check moving_check(std::string_view id, std::string_view name, std::string_view clause) {
  return {.id = id,
          .name = name,
          .clause = clause,
          .group = Group::Drive,
          .mode = Mode::Full,
          .moves = true,
          .run = [](Context& context) { on_each_axis(context, Each); }};
}

}  // namespace conformance
