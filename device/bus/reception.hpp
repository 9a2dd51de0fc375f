#pragma once

#include <algorithm>
#include <cstdint>

#include "device/bus/communication.hpp"
#include "device/bus/rpdo_monitor.hpp"
#include "device/bus/telegram_loss.hpp"
#include "device/bus/unit_time.hpp"
#include "unit/runner.hpp"

namespace device {

/// What becomes of received process data that are late, overwritten or missing (A08751, F08702).
///
/// Of the frames of one RPDO each is taken by a cycle of its own: before one that would overwrite values that
/// wait, the next missed cycle is run. Frames that come while the unit is kept from running wait for it one behind
/// the other.
class Reception {
 public:
  /// Answers in the parameters of @p runner for p8699; all arguments must outlive this.
  Reception(unit::Runner& runner, const canopen::Node& node, Communication& communication)
      : runner_{runner}, node_{node}, communication_{communication}, monitor_{runner.parameters()} {}

  /// What the parameters say of the monitoring, which is judged in cycles of @p grid, is in force.
  void take_over(const canopen::PdoCycle& grid) noexcept;
  /// RPDO @p number (0 for 1400h) is about to be stored.
  void before_rpdo(std::uint16_t number) noexcept {
    monitor_.on_rpdo(now());
    if (loss_.on_rpdo(number)) overwrite(number);
  }
  /// A cycle takes what was received.
  void on_cycle() noexcept { loss_.on_cycle(); }
  /// Operational is left: what waits is taken by a cycle that was missed, if one was.
  void on_operational_left() noexcept {
    if (loss_.is_waiting()) make_up_cycle();
  }
  /// Frames were lost before they could be received.
  void on_frames_lost() noexcept;
  /// Nothing more is expected.
  void stop() noexcept { monitor_.stop(); }
  /// Nothing waits, and no loss is known.
  void forget() noexcept { loss_.clear(); }

  /// When on_time() is wanted next; kNever while nothing is watched.
  canopen::TimePoint next_deadline() const noexcept { return std::min(monitor_.deadline(), loss_.deadline()); }
  void on_time(canopen::TimePoint now) noexcept {
    if (monitor_.deadline() <= now) miss_rpdos();
    if (loss_.deadline() <= now) end_loss();
  }
  /// Frames of asynchronous RPDOs whose values were overwritten before a cycle has taken them.
  std::uint64_t lost_telegrams() const noexcept { return lost_telegrams_; }

 private:
  canopen::TimePoint now() const noexcept { return node_time(runner_.now()); }
  bool make_up_cycle() noexcept;
  void overwrite(std::uint16_t number) noexcept;
  void lose(std::uint16_t number) noexcept;
  void miss_rpdos() noexcept;
  void end_loss() noexcept;

  unit::Runner& runner_;
  const canopen::Node& node_;
  Communication& communication_;
  RpdoMonitor monitor_;
  TelegramLoss loss_;
  canopen::TimePoint made_up_at_ = canopen::kNever;  ///< when a missed cycle has last been run for a frame
  std::uint64_t lost_telegrams_ = 0;
};

}  // namespace device
