#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace drive {

/// Codes of modes of operation in 6060h and 6061h; all others are -(p1300).
namespace mode_code {
inline constexpr std::int8_t kVelocity = 2;
inline constexpr std::int8_t kProfileVelocity = 3;
inline constexpr std::int8_t kProfileTorque = 4;
}  // namespace mode_code

/// p1300 as far as it is asked for by name.
namespace control_mode {
inline constexpr std::int32_t kSpeedWithoutEncoder = 20;
inline constexpr std::int32_t kSpeed = 21;
inline constexpr std::int32_t kTorqueWithoutEncoder = 22;
inline constexpr std::int32_t kTorque = 23;
}  // namespace control_mode

/// What leads the motor in a mode.
enum class Lead : std::uint8_t { Speed, Torque };

/// A mode that CiA 402 has a number for.
struct OperatingModeRow {
  std::int8_t code = 0;                         ///< 6060h, 6061h
  std::int32_t control_mode = 0;                ///< p1300
  std::optional<std::int32_t> without_encoder;  ///< p1300 in its place on an axis without encoder
  Lead lead = Lead::Speed;
  bool has_ramp_bits = false;  ///< bits 4 to 6 of the controlword are enables of the ramp
  std::uint16_t setpoint = 0;  ///< object of the setpoint
  std::uint16_t written = 0;   ///< parameter that shows what was written to that
};

/// The first row with a p1300 is the mode that p1300 is by itself; the others have to be asked for by 6060h.
inline constexpr std::array kOperatingModes{
    OperatingModeRow{mode_code::kProfileVelocity, control_mode::kSpeed, {}, Lead::Speed, false, 0x60FF, 8796},
    OperatingModeRow{mode_code::kProfileTorque, control_mode::kTorque, {}, Lead::Torque, false, 0x6071, 8797},
    OperatingModeRow{mode_code::kVelocity, control_mode::kSpeed, control_mode::kSpeedWithoutEncoder, Lead::Speed,
                     true, 0x6042, 8792},
};

static_assert(kOperatingModes.front().lead == Lead::Speed, "what leads where no other mode is asked for");

/// 6502h: a bit for each mode that an axis with or without encoder can have, that of mode 1 the lowest.
constexpr std::uint32_t supported_modes(bool has_encoder) noexcept {
  std::uint32_t modes = 0;
  for (const OperatingModeRow& row : kOperatingModes)
    if (has_encoder || row.without_encoder) modes |= std::uint32_t{1} << (row.code - 1);
  return modes;
}

/// p1300 for the mode @p code, with or without encoder. Nothing if no p1300 has it.
std::optional<std::int32_t> control_mode_of(std::int8_t code, bool has_encoder) noexcept;

/// The mode that p1300 = @p control_mode is by itself.
std::int8_t mode_of(std::int32_t control_mode) noexcept;

/// Whether @p control_mode is one of the four with closed loops, not V/f control.
constexpr bool is_field_oriented(std::int32_t control_mode) noexcept {
  return control_mode >= control_mode::kSpeedWithoutEncoder;
}
/// Whether @p control_mode is one of the two that need the encoder.
constexpr bool is_with_encoder(std::int32_t control_mode) noexcept {
  return control_mode == control_mode::kSpeed || control_mode == control_mode::kTorque;
}
/// Whether @p control_mode is one of the two with torque control.
constexpr bool is_torque_control(std::int32_t control_mode) noexcept {
  return control_mode == control_mode::kTorqueWithoutEncoder || control_mode == control_mode::kTorque;
}
/// Whether @p control_mode is one of the two with speed control.
constexpr bool is_speed_control(std::int32_t control_mode) noexcept {
  return control_mode == control_mode::kSpeedWithoutEncoder || control_mode == control_mode::kSpeed;
}

/// What was asked for over the bus and which mode follows from it and from p1300.
class OperatingMode {
 public:
  /// p1300 has been written: it is the mode that was asked for.
  void on_parameter(std::int32_t control_mode) noexcept;
  /// 6060h has been written as a parameter and p1300 is @p control_mode now, or could not follow.
  void on_request(std::int8_t code, std::int32_t control_mode, bool possible) noexcept;
  /// 6060h as process data, nothing while it is not mapped; p1300 is @p control_mode. It toggles between speed and
  /// torque control and between modes of the same p1300. False if torque was asked for anew without an encoder.
  bool on_process_data(std::optional<std::int8_t> code, std::int32_t control_mode) noexcept;
  /// p1501. False if it asks for torque anew without an encoder.
  bool on_changeover(bool torque, std::int32_t control_mode) noexcept;

  /// 6060h: what was last asked for.
  std::int8_t requested() const noexcept { return requested_; }
  /// Whether the torque setpoint leads (r1407.2).
  bool torque_control(std::int32_t control_mode) const noexcept;
  /// The row of a mode that was asked for beside the one that p1300 is by itself, if it is in force.
  const OperatingModeRow* chosen(std::int32_t control_mode) const noexcept {
    const bool speed_leads = is_speed_control(control_mode) && !torque_control(control_mode);
    return speed_leads ? chosen_ : nullptr;
  }
  /// The row whose setpoint leads while the speed does.
  const OperatingModeRow& speed_setpoint(std::int32_t control_mode) const noexcept {
    const OperatingModeRow* const row = chosen(control_mode);
    return row != nullptr ? *row : kOperatingModes.front();
  }
  /// Whether bits 4 to 6 of the controlword act.
  bool has_ramp_bits(std::int32_t control_mode) const noexcept {
    const OperatingModeRow* const row = chosen(control_mode);
    return row != nullptr && row->has_ramp_bits;
  }
  /// 6061h: what is in force.
  std::int8_t display(std::int32_t control_mode) const noexcept;

 private:
  std::int8_t requested_ = mode_code::kProfileVelocity;
  std::optional<std::int8_t> process_data_{};  // in the last cycle
  const OperatingModeRow* chosen_ = nullptr;   // not the one that p1300 is by itself
  bool torque_by_process_data_ = false;
  bool changeover_ = false;  // p1501
};

}  // namespace drive
