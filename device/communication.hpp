#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "device/unit_parameters.hpp"
#include "drive/drive_unit.hpp"
#include "libcanopen/nmt/state.hpp"
#include "libcanopen/node/node.hpp"

namespace device {

/// Error state of the CAN controller (ISO 11898-1), as far as the unit tells it apart.
enum class BusState : std::uint8_t { Active, Passive, Off };

/// What the unit makes of NMT and of errors of the bus: the parameters p8608, p8684 and p8685, the fault F08700
/// and the alarm A08752.
class Communication final : public ParameterOwner {
 public:
  /// Answers in @p parameters for p8608 and p8685; all arguments must outlive this.
  Communication(drive::DriveUnit& unit, UnitParameters& parameters, canopen::Node& node);

  /// p8684 holds for the next boot-up.
  void set_start_state() noexcept;
  /// The NMT command that was written to p8685 since the last call, if any; it is to be carried out when the
  /// answer to the write is out.
  std::optional<canopen::NmtCommand> take_command() noexcept { return std::exchange(command_, std::nullopt); }

  /// The life time of node guarding is over: F08700 with value 2.
  void on_life_time_over() noexcept;
  /// The monitoring time p8699 is over: F08702.
  void on_rpdos_missing() noexcept;
  /// The controller is in @p state now. Bus-off: F08700 with value 1. True if the bus is back from bus-off.
  bool on_bus_state(BusState state) noexcept;
  /// The bus is off: what is sent gets lost.
  bool is_bus_off() const noexcept { return bus_ == BusState::Off; }

  std::optional<double> value_of(const ParameterPlace& place) const noexcept override;
  canopen::Result<void> take(const ParameterPlace& place, double value) noexcept override;

 private:
  drive::DriveUnit& unit_;
  canopen::Node& node_;
  std::optional<canopen::NmtCommand> command_{};
  double automatic_restart_ = 0.0;  ///< p8608[1]
  BusState bus_ = BusState::Active;
};

}  // namespace device
