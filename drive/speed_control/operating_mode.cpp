#include "drive/speed_control/operating_mode.hpp"

#include <algorithm>

namespace drive {
namespace {

constexpr std::int32_t kHighestControlMode = 23;

const OperatingModeRow* find_mode(std::int8_t code) noexcept {
  const auto* const row = std::ranges::find(kOperatingModes, code, &OperatingModeRow::code);
  return row != kOperatingModes.end() ? row : nullptr;
}

/// The mode @p code if speed leads in it and it is not the one that its p1300 is by itself.
const OperatingModeRow* find_choice(std::int8_t code) noexcept {
  const OperatingModeRow* const row = find_mode(code);
  return row != nullptr && row->lead == Lead::Speed && mode_of(row->control_mode) != code ? row : nullptr;
}

bool is_of(const OperatingModeRow& row, std::int32_t control_mode) noexcept {
  return control_mode == row.control_mode || control_mode == row.without_encoder;
}

/// Whether the torque leads in the mode @p code.
bool is_torque(std::int8_t code) noexcept {
  const OperatingModeRow* const row = find_mode(code);
  return row != nullptr ? row->lead == Lead::Torque : code == -control_mode::kTorqueWithoutEncoder;
}

}  // namespace

std::int8_t mode_of(std::int32_t control_mode) noexcept {
  const auto* const row = std::ranges::find(kOperatingModes, control_mode, &OperatingModeRow::control_mode);
  return row != kOperatingModes.end() ? row->code : static_cast<std::int8_t>(-control_mode);
}

std::optional<std::int32_t> control_mode_of(std::int8_t code, bool has_encoder) noexcept {
  if (const OperatingModeRow* const row = find_mode(code))
    return has_encoder ? row->control_mode : row->without_encoder.value_or(row->control_mode);
  for (std::int32_t control_mode = 0; control_mode <= kHighestControlMode; ++control_mode)
    if (mode_of(control_mode) == code) return control_mode;
  return std::nullopt;
}

void OperatingMode::on_parameter(std::int32_t control_mode) noexcept {
  requested_ = mode_of(control_mode);
  chosen_ = nullptr;
  torque_by_process_data_ = false;
}

void OperatingMode::on_request(std::int8_t code, std::int32_t control_mode, bool possible) noexcept {
  if (possible) {
    on_parameter(control_mode);
    chosen_ = find_choice(code);
  }
  requested_ = code;
}

bool OperatingMode::on_process_data(std::optional<std::int8_t> code, std::int32_t control_mode) noexcept {
  const bool anew = code != process_data_;
  process_data_ = code;
  if (!code) torque_by_process_data_ = false;
  if (!code || !anew || *code == 0) return true;
  requested_ = *code;
  if (!is_speed_control(control_mode)) return true;
  const bool torque = is_torque(*code);
  if (torque && control_mode == control_mode::kSpeedWithoutEncoder) return false;
  const OperatingModeRow* const choice = find_choice(*code);
  const bool known =
      torque || (choice != nullptr && is_of(*choice, control_mode)) || *code == mode_of(control_mode);
  if (!known) return true;
  torque_by_process_data_ = torque;
  chosen_ = choice;
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
  if (const OperatingModeRow* const row = chosen(control_mode)) return row->code;
  return torque_control(control_mode) && control_mode == control_mode::kSpeed ? mode_code::kProfileTorque
                                                                              : mode_of(control_mode);
}

}  // namespace drive
