#pragma once

#include <array>
#include <cstdint>

#include "drive/machine/machine_model.hpp"
#include "drive/messages/cause.hpp"

namespace drive {

/// The machine as its parameters describe it to the control.
class MotorModel {
 public:
  using Settings = MotorData;

  /// Of a machine with @p data_sheet.
  explicit MotorModel(const motor::MachineData& data_sheet) noexcept : data_sheet_{data_sheet} {}

  /// After a write; F07950 waits for the end of commissioning.
  void configure(bool commissioning) noexcept {
    const std::uint16_t implausible = implausible_motor_parameter(settings, data_sheet_);
    is_plausible_ = implausible == 0;
    implausible_parameter_ = commissioning ? std::uint16_t{0} : implausible;
  }
  /// The machine as the control sees it.
  motor::MachineData believed() const noexcept { return believed_machine(settings, data_sheet_); }
  const motor::MachineData& data_sheet() const noexcept { return data_sheet_; }
  /// Whether a machine can be as it is described.
  bool is_plausible() const noexcept { return is_plausible_; }
  /// Number of a motor parameter that cannot be, 0 = none.
  double implausible_parameter() const noexcept { return implausible_parameter_; }
  /// Inertia of all that turns (kg·m²).
  double total_inertia() const noexcept { return settings.motor_inertia * settings.inertia_ratio; }
  /// r0313.
  std::int32_t pole_pairs() const noexcept {
    return settings.pole_pairs > 0 ? settings.pole_pairs : data_sheet_.pole_pairs;
  }

  Settings settings{};

 private:
  motor::MachineData data_sheet_;
  std::uint16_t implausible_parameter_ = 0;
  bool is_plausible_ = true;
};

template <>
inline constexpr auto causes_of<MotorModel> = std::array{
    CauseRow<MotorModel>{7950, &MotorModel::implausible_parameter, Side::Above, cause::kYes, cause::kNone,
                         cause::kAtOnce, Pulses::Any, &MotorModel::implausible_parameter, 1.0, "motor data"},
};

}  // namespace drive
