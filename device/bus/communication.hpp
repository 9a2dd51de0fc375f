#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "device/bus/bus_follow_ups.hpp"
#include "device/bus/bus_outlet.hpp"
#include "device/bus/bus_state.hpp"
#include "drive/drive_unit.hpp"
#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/node/node.hpp"
#include "unit/unit_parameters.hpp"

namespace device {

/// What the unit makes of NMT and of errors of the bus: the parameters p8608, p8684 and p8685, the faults F08700
/// and F08702 and the alarms A08751 and A08752.
class Communication final : public unit::ParameterOwner {
 public:
  /// The node and where its frames go.
  struct Bus {
    canopen::Node& node;
    canopen::FrameSink& sink;
  };
  /// Answers in @p parameters for p8608 and p8685; what they command is left to @p follow_ups. All that is named
  /// must outlive this.
  Communication(drive::DriveUnit& unit, unit::UnitParameters& parameters, BusFollowUps& follow_ups,
                const Bus& bus);

  /// p8684 holds for the next boot-up.
  void set_start_state() noexcept;

  /// The life time of node guarding is over: F08700 with value 2.
  void on_life_time_over() noexcept;
  /// The monitoring time p8699 is over: F08702.
  void on_rpdos_missing() noexcept;
  /// Received process data are being lost, or have not been for a while: A08751.
  void on_telegram_loss() noexcept;
  void on_telegram_loss_over() noexcept;
  /// The controller is in @p state now. Bus-off: F08700 with value 1. True if the bus is back from bus-off.
  bool on_bus_state(BusState state) noexcept;
  /// The bus is back and has been told of F08700, which leaves if it was acknowledged meanwhile.
  void on_bus_back() noexcept;
  /// The bus is off: what is sent gets lost.
  bool is_bus_off() const noexcept { return bus_ == BusState::Off; }
  /// Frames go to the bus, or nowhere while that is off; answers go there in any case.
  void lead_frames() noexcept { outlet_.lead(!is_bus_off()); }
  void lead_answers() noexcept { outlet_.lead(true); }
  /// From now on the bus is @p sink, which outlives this.
  void send_to(canopen::FrameSink& sink) noexcept { outlet_.connect(sink); }
  /// The error state that was told last.
  BusState bus_state() const noexcept { return bus_; }

  /// The bus has gone off, p8608 was written, a restart by p8608[0] being @p asked for, or one was of no use: sees
  /// when the next is to be tried.
  void plan_restart(canopen::TimePoint now, bool asked = false) noexcept;
  /// When the controller is to be restarted from bus-off: at once if p8608[0] was written, 2 s later with
  /// p8608[1]; kNever if nobody wants that.
  canopen::TimePoint restart_at() const noexcept { return restart_at_; }
  /// A restart is being tried.
  void on_restart() noexcept { restart_at_ = canopen::kNever; }

  std::optional<double> value_of(const unit::ParameterPlace& place) const noexcept override;
  std::optional<drive::Refusal> take(const unit::ParameterPlace& place, double value) noexcept override;

 private:
  drive::DriveUnit& unit_;
  canopen::Node& node_;
  BusOutlet outlet_;
  BusFollowUps& follow_ups_;
  double automatic_restart_ = 0.0;  ///< p8608[1]
  canopen::TimePoint restart_at_ = canopen::kNever;
  BusState bus_ = BusState::Active;
};

}  // namespace device
