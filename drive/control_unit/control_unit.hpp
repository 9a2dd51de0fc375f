#pragma once

#include "drive/base/unit_inputs.hpp"
#include "drive/control_unit/terminals.hpp"
#include "drive/external_messages/external_messages.hpp"
#include "drive/object/drive_object.hpp"

namespace drive {

/// Drive object 1: what belongs to the unit as a whole. It has faults without a reaction.
class ControlUnit final : public DriveObject {
 public:
  /// @p context names the axes of the unit.
  explicit ControlUnit(const ObjectContext& context);

  /// Whether p0009 keeps the axes from being switched on.
  bool is_in_commissioning() const noexcept;
  bool acknowledge() noexcept override;
  /// What the interconnections have brought for messages, and for the unit as a whole.
  ExternalMessages& external_messages() noexcept { return external_messages_; }
  const UnitInputs& unit_inputs() const noexcept { return unit_inputs_; }

  /// Its digital inputs and outputs.
  const Terminals& terminals() const noexcept { return terminals_; }
  Terminals& terminals() noexcept { return terminals_; }
  /// The digital outputs follow what they are connected to.
  void lead_outputs() noexcept;

 private:
  void* own_block(BlockId id) noexcept override;
  const void* own_block(BlockId id) const noexcept override;
  WriteState write_state() const noexcept override;

  Terminals terminals_{};
  ExternalMessages external_messages_;
  UnitInputs unit_inputs_{};
  TerminalInputs terminal_inputs_{};
};

}  // namespace drive
