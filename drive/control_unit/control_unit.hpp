#pragma once

#include "drive/base/unit_inputs.hpp"
#include "drive/clock/unit_clock.hpp"
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

  /// The clock of the unit. What may raise or end A01099 is done by the functions below.
  const UnitClock& clock() const noexcept { return clock_; }
  UnitClock& clock() noexcept { return clock_; }
  /// p3100: UTC begins, or ends.
  void run_utc(bool runs) noexcept;
  /// p3101.
  void set_clock(UnitClock::Part part, std::uint32_t value) noexcept;
  /// What the clock of the program around says, which was asked; nothing: it does not know.
  void take_host_time(std::optional<UtcTime> host) noexcept;

  /// Its digital inputs and outputs.
  const Terminals& terminals() const noexcept { return terminals_; }
  Terminals& terminals() noexcept { return terminals_; }
  /// The digital outputs follow what they are connected to.
  void lead_outputs() noexcept;

 private:
  void* own_block(BlockId id) noexcept override;
  const void* own_block(BlockId id) const noexcept override;
  WriteState write_state() const noexcept override;
  void follow(UnitClock::Correction correction) noexcept;

  UnitClock clock_{};
  Terminals terminals_{};
  ExternalMessages external_messages_;
  UnitInputs unit_inputs_{};
  TerminalInputs terminal_inputs_{};
};

}  // namespace drive
