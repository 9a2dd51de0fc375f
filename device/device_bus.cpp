// What becomes of NMT, of errors of the bus and of process data that are lost or missing.
#include <algorithm>
#include <cassert>
#include <utility>

#include "device/device.hpp"
#include "device/unit_time.hpp"
#include "libcanopen/base/cob_id.hpp"

namespace device {
namespace {

constexpr std::uint16_t kCommunicationError = 8700;
constexpr std::uint32_t kLifeTimeOver = 2;  // fault value
constexpr std::uint16_t kLeftOperational = 8701;
constexpr std::uint32_t kToPreOperational = 1;  // fault value
constexpr std::uint32_t kToStopped = 2;

/// SDO requests of all servers that the unit may have: 600h to 67Fh.
bool is_sdo_request(const canopen::Frame& frame) noexcept {
  constexpr canopen::Identifier kFunction = 0x780;
  constexpr canopen::Identifier kSdoRequest = 0x600;
  return !frame.remote && !frame.extended && (frame.id & kFunction) == kSdoRequest;
}

}  // namespace

void Device::on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
  if (from == canopen::NmtState::Operational && telegram_loss_.is_waiting()) make_up_cycle();
  tell_time(now_);
  rpdo_monitor_.stop();
  const bool resets = to == canopen::NmtState::Initialising;
  const bool left = from == canopen::NmtState::Operational && !resets && !restarting_;
  if (left && configuration_.fault_on_leaving_operational)
    leave_operational(to == canopen::NmtState::Stopped ? kToStopped : kToPreOperational);
  if (left) storage_.on_operational_left();
  if (from != canopen::NmtState::Initialising) process_data_.end_alarms();
  show_messages();
}

/// A reset of the communication leaves the drives and their faults as they are, but for p8641.
void Device::lose_connection() noexcept {
  for (drive::Axis& axis : unit_.axes()) axis.lose_connection();
  for (AxisObjects& axis : axes_) axis.forget_written();
  error_objects_.show_again();
}

/// 1001h, 1003h and EMCY tell at once; what the axes make of it is for the cycle that follows.
void Device::show_messages() noexcept {
  follow_ups_.drop(FollowUp::ShowMessages);
  error_objects_.update(node_);
  wake();
}

/// F08701 on every axis, and on the infeed, which it switches off; the control unit has no part in it.
void Device::leave_operational(std::uint32_t value) noexcept {
  if (drive::Infeed* const infeed = unit_.infeed()) static_cast<void>(infeed->raise(kLeftOperational, value));
  for (drive::Axis& axis : unit_.axes()) {
    [[maybe_unused]] const auto raised = axis.raise(kLeftOperational, value);
    assert(raised);
  }
}

void Device::on_communication_error(canopen::CommunicationError error, std::uint16_t) noexcept {
  if (error != canopen::CommunicationError::LifeGuarding || communication_.is_bus_off()) return;
  tell_time(now_);
  communication_.on_life_time_over();
  show_messages();
}

void Device::miss_rpdos() noexcept {
  rpdo_monitor_.stop();
  tell_time(now_);
  communication_.on_rpdos_missing();
  show_messages();
}

void Device::before_rpdo(std::uint16_t number) noexcept {
  rpdo_monitor_.on_rpdo(now_);
  if (telegram_loss_.on_rpdo(number)) overwrite(number);
}

void Device::on_rpdo(std::uint16_t number) noexcept {
  if (clock_.is_resting()) {
    const canopen::TimePoint now = now_;
    tell_time(std::min(now, listener_.frame_arrival(now)));  // the rest ends when the frame came
    clock_.wake(unit_time(std::exchange(now_, now)));
  }
  axes_[number / pdo::kStride].on_rpdo();
}

/// RPDO @p number is about to be stored, and no cycle has taken the values before. If cycles were missed
/// meanwhile, one of them takes those: frames that come while the unit is kept from running wait for it one behind
/// the other.
void Device::overwrite(std::uint16_t number) noexcept {
  if (unit_time(now_) >= clock_.next() && make_up_cycle()) {
    static_cast<void>(telegram_loss_.on_rpdo(number));
  } else if (now_ != made_up_at_) {  // more frames than missed cycles: nobody knows which of those they belong to
    lose_telegram(number);
  }
}

/// Runs the first of the cycles that were missed, if any was; what it leads to is shown after the last of them.
bool Device::make_up_cycle() noexcept {
  const CycleClock::Due due = clock_.take_first_due(unit_time(now_));
  if (due.run == 0) return false;
  made_up_at_ = now_;
  skipped_cycles_ += static_cast<std::uint64_t>(due.skipped);
  tell_time(now_);
  telegram_loss_.on_cycle();
  run_cycle(false);
  return true;
}

/// A frame of RPDO @p number has overwritten the one before in the same cycle. A08751 is for asynchronous ones
/// only.
void Device::lose_telegram(std::uint16_t number) noexcept {
  const auto pdos = node_.receive_pdos();
  const auto found = std::ranges::find(pdos, number, &canopen::PdoSettings::number);
  if (found != pdos.end() && found->transmission_type <= canopen::kLastSynchronousType) return;
  ++lost_telegrams_;
  if (!telegram_loss_.on_loss(now_)) return;
  tell_time(now_);
  communication_.on_telegram_loss();
  follow_ups_.add(FollowUp::ShowMessages);
}

void Device::end_telegram_loss() noexcept {
  telegram_loss_.clear();
  tell_time(now_);
  communication_.on_telegram_loss_over();
  show_messages();
}

void Device::on_frames_lost(canopen::TimePoint now) noexcept {
  tell_time(now);
  if (!telegram_loss_.on_loss(now)) return;
  communication_.on_telegram_loss();
  show_messages();
}

void Device::on_bus_state(BusState state, canopen::TimePoint now) noexcept {
  tell_time(now);
  const bool is_back = communication_.on_bus_state(state);
  error_objects_.set_bus_off(communication_.is_bus_off());
  communication_.plan_restart(now);
  node_.send_to(communication_.is_bus_off() ? static_cast<canopen::FrameSink&>(nowhere_) : sink_);
  show_messages();
  if (!is_back) return;
  communication_.on_bus_back();
  show_messages();
  node_.report(canopen::CommunicationError::BusOffRecovered, now);
  node_.report_recovery(canopen::CommunicationError::BusOffRecovered, now);
  // The master has seen nothing of what TPDOs said meanwhile.
  if (node_.state() == canopen::NmtState::Operational) node_.reload(now);
}

void Device::serve_off_the_bus(const canopen::Frame& frame) noexcept {
  if (!is_sdo_request(frame)) return;
  node_.send_to(sink_);
  serve(frame);
  if (communication_.is_bus_off()) node_.send_to(nowhere_);
}

void Device::plan_bus_restart(std::uint8_t asked) noexcept {
  communication_.plan_restart(now_, asked != 0);
}

void Device::restart_bus() noexcept {
  communication_.on_restart();
  if (listener_.on_bus_restart()) return on_bus_state(BusState::Active, now_);
  communication_.plan_restart(now_);
}

bool Device::restart_bus(canopen::TimePoint now) noexcept {
  if (!communication_.is_bus_off()) return false;
  tell_time(now);
  restart_bus();
  return true;
}

IndicatorLeds Device::leds() const noexcept {
  const auto faults = unit_.object(drive::kControlUnitNumber)->messages().faults();
  const bool guarding_lost = std::ranges::any_of(faults, [](const drive::FaultEntry& fault) {
    return fault.row->number == kCommunicationError && fault.value == kLifeTimeOver;
  });
  return leds_of(node_.state(), {.off = communication_.is_bus_off(),
                                 .guarding_lost = guarding_lost,
                                 .passive = communication_.bus_state() == BusState::Passive});
}

}  // namespace device
