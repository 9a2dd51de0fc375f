#include "drive/operating_mode.hpp"

namespace drive {
namespace {

/// The modes that CiA 402 has a number for.
struct Row {
  std::int8_t code;
  std::int32_t control_mode;
};
constexpr Row kRows[]{
    {mode_code::kProfileVelocity, control_mode::kSpeed},
    {mode_code::kProfileTorque, control_mode::kTorque},
};

constexpr std::int32_t kHighestControlMode = 23;

}  // namespace

std::int8_t mode_of(std::int32_t control_mode) noexcept {
  for (const Row& row : kRows)
    if (row.control_mode == control_mode) return row.code;
  return static_cast<std::int8_t>(-control_mode);
}

std::optional<std::int32_t> control_mode_of(std::int8_t code, bool has_encoder) noexcept {
  if (code == mode_code::kVelocity) return has_encoder ? control_mode::kSpeed : control_mode::kSpeedWithoutEncoder;
  for (std::int32_t control_mode = 0; control_mode <= kHighestControlMode; ++control_mode)
    if (mode_of(control_mode) == code) return control_mode;
  return std::nullopt;
}

void OperatingMode::on_parameter(std::int32_t control_mode) noexcept {
  requested_ = mode_of(control_mode);
  velocity_ = false;
  torque_by_process_data_ = false;
}

void OperatingMode::on_request(std::int8_t code, std::int32_t control_mode, bool possible) noexcept {
  if (possible) {
    on_parameter(control_mode);
    velocity_ = code == mode_code::kVelocity;
  }
  requested_ = code;
}

bool OperatingMode::on_process_data(std::optional<std::int8_t> code, std::int32_t control_mode) noexcept {
  const bool anew = code != process_data_;
  process_data_ = code;
  if (!code) torque_by_process_data_ = false;
  if (!code || !anew || *code == 0) return true;
  requested_ = *code;
  const bool torque = *code == mode_code::kProfileTorque || *code == -control_mode::kTorqueWithoutEncoder;
  if (!is_speed_control(control_mode)) return true;
  if (torque && control_mode == control_mode::kSpeedWithoutEncoder) return false;
  const bool known = torque || *code == mode_code::kVelocity || *code == mode_of(control_mode);
  if (!known) return true;
  torque_by_process_data_ = torque;
  velocity_ = *code == mode_code::kVelocity;
  return true;
}

bool OperatingMode::on_changeover(bool torque, std::int32_t control_mode) noexcept {
  const bool anew = torque && !changeover_;
  changeover_ = torque;
  return !anew || control_mode != control_mode::kSpeedWithoutEncoder;
}

bool OperatingMode::torque_control(std::int32_t control_mode) const noexcept {
  const bool toggled = control_mode == control_mode::kSpeed && (changeover_ || torque_by_process_data_);
  return toggled || is_torque_control(control_mode);
}

std::int8_t OperatingMode::display(std::int32_t control_mode) const noexcept {
  if (velocity_mode(control_mode)) return mode_code::kVelocity;
  return torque_control(control_mode) && control_mode == control_mode::kSpeed ? mode_code::kProfileTorque
                                                                              : mode_of(control_mode);
}

}  // namespace drive
