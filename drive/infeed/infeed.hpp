#pragma once

#include <cstdint>

#include "drive/base/unit_inputs.hpp"
#include "drive/external_messages/external_messages.hpp"
#include "drive/object/drive_object.hpp"
#include "drive/sequence_control/state_machine.hpp"

namespace drive {

/// The infeed of a unit that has one as a drive object of its own (number 2, the axes behind it): a sequence
/// control that puts the DC link on the line. It has no OFF3, and an OFF1 switches it off at once.
class Infeed final : public DriveObject {
 public:
  /// @p context has the supply.
  explicit Infeed(const ObjectContext& context);

  /// Voltages of the DC link (V).
  struct Link {
    double voltage = 0.0;  ///< now
    double lowest = 0.0;   ///< of the last cycle
  };
  /// One process-data cycle of @p duration (s) with what the interconnections have brought and what @p link was.
  void cycle(double duration, const Link& link) noexcept;
  /// What the interconnections have brought,
  const InfeedInputs& inputs() const noexcept { return inputs_; }
  /// and that for messages.
  ExternalMessages& external_messages() noexcept { return external_messages_; }

  /// Switch on disabled, Ready to switch on, Switched on while the DC link is charged, Operation enabled or Fault.
  State state() const noexcept { return state_; }
  /// r0863.1: the line contactor is closed.
  bool is_connected() const noexcept { return state_ == State::SwitchedOn || operates(); }
  /// r0863.0: it operates.
  bool operates() const noexcept { return state_ == State::OperationEnabled; }
  /// Whether the DC link has its voltage.
  bool has_link() const noexcept { return link_.voltage >= context().supply.undervoltage; }
  /// r0070 (V).
  double dc_voltage() const noexcept { return link_.voltage; }
  /// Whether p0009 keeps it from being switched on.
  bool is_inhibited() const noexcept { return inhibited_; }
  void inhibit(bool inhibited) noexcept;
  /// Whether further cycles with the inputs of the last one would change nothing.
  bool is_quiescent() const noexcept { return settled_ && (state_ != State::SwitchedOn || has_link()); }

  bool acknowledge() noexcept override;
  void power_off() noexcept override;

 private:
  void* own_block(BlockId id) noexcept override;
  const void* own_block(BlockId id) const noexcept override;
  WriteState write_state() const noexcept override;
  void react(const FaultRow& row) noexcept override;
  void on_acknowledged_fault_left() noexcept override;
  void on_messages_changed() noexcept override { settled_ = false; }

  void apply(Event event) noexcept;
  void await_link(double duration) noexcept;

  State state_ = State::NotReadyToSwitchOn;
  InfeedInputs inputs_{};
  ExternalMessages external_messages_;
  // Those of the cycle before.
  InfeedInputs inputs_before_{};
  ExternalMessages::Inputs external_before_{};
  Link link_{};
  double link_missing_ = 0.0;  // s, since ON
  bool inhibited_ = false;
  bool settled_ = false;  // the last cycle changed nothing
};

}  // namespace drive
