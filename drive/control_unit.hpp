#pragma once

#include "drive/drive_object.hpp"
#include "drive/terminals.hpp"

namespace drive {

/// Drive object 1: what belongs to the unit as a whole. It has faults without a reaction.
class ControlUnit final : public DriveObject {
 public:
  /// @p context names the axes of the unit.
  explicit ControlUnit(const ObjectContext& context);

  /// Whether p0009 keeps the axes from being switched on.
  bool is_in_commissioning() const noexcept;
  bool acknowledge() noexcept override;

  /// Its digital inputs and outputs.
  const Terminals& terminals() const noexcept { return terminals_; }
  Terminals& terminals() noexcept { return terminals_; }

 private:
  double own_value(const ParameterRow& row, std::size_t index) const noexcept override;
  void set_own_value(const ParameterRow& row, std::size_t index, double value) noexcept override;
  WriteState write_state() const noexcept override;

  Terminals terminals_{};
};

}  // namespace drive
