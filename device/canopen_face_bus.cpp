// What becomes of NMT, of errors of the bus and of process data that come.
#include <algorithm>
#include <cassert>

#include "device/canopen_face.hpp"

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

void CanopenFace::on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
  listener_.on_nmt_state(from, to);
  if (from == canopen::NmtState::Operational) reception_.on_operational_left();
  runner_.tell_time();
  reception_.stop();
  const bool resets = to == canopen::NmtState::Initialising;
  const bool left = from == canopen::NmtState::Operational && !resets && !restarting_;
  if (left && fault_on_leaving_operational_)
    leave_operational(to == canopen::NmtState::Stopped ? kToStopped : kToPreOperational);
  if (left) runner_.on_operation_left();
  if (from != canopen::NmtState::Initialising) process_data_.end_alarms();
  runner_.show_messages();
}

/// A reset of the communication leaves the drives and their faults as they are, but for p8641.
void CanopenFace::lose_connection() noexcept {
  for (drive::Axis& axis : runner_.unit().axes()) axis.lose_connection();
  forget_written();
  error_objects_.show_again();
}

/// F08701 on every axis, and on the infeed, which it switches off; the control unit has no part in it.
void CanopenFace::leave_operational(std::uint32_t value) noexcept {
  if (drive::Infeed* const infeed = runner_.unit().infeed())
    static_cast<void>(infeed->raise(kLeftOperational, value));
  for (drive::Axis& axis : runner_.unit().axes()) {
    [[maybe_unused]] const auto raised = axis.raise(kLeftOperational, value);
    assert(raised);
  }
}

void CanopenFace::on_communication_error(canopen::CommunicationError error, std::uint16_t) noexcept {
  if (error != canopen::CommunicationError::LifeGuarding || communication_.is_bus_off()) return;
  runner_.tell_time();
  communication_.on_life_time_over();
  runner_.show_messages();
}

/// A rest ends when the frame came.
void CanopenFace::on_rpdo(std::uint16_t number) noexcept {
  if (runner_.is_resting()) runner_.end_rest(unit_time(listener_.frame_arrival(now())));
  axes_[number / pdo::kStride].on_rpdo();
}

void CanopenFace::on_bus_state(BusState state) noexcept {
  const bool is_back = communication_.on_bus_state(state);
  error_objects_.set_bus_off(communication_.is_bus_off());
  communication_.plan_restart(now());
  communication_.lead_frames();
  runner_.show_messages();
  if (!is_back) return;
  communication_.on_bus_back();
  runner_.show_messages();
  node_.report(canopen::CommunicationError::BusOffRecovered, now());
  node_.report_recovery(canopen::CommunicationError::BusOffRecovered, now());
  // The master has seen nothing of what TPDOs said meanwhile.
  if (node_.state() == canopen::NmtState::Operational) node_.reload(now());
}

void CanopenFace::serve_off_the_bus(const canopen::Frame& frame) noexcept {
  if (!is_sdo_request(frame)) return;
  communication_.lead_answers();
  serve(frame);
  communication_.lead_frames();
}

void CanopenFace::try_bus_restart() noexcept {
  communication_.on_restart();
  if (!listener_.on_bus_restart()) return communication_.plan_restart(now());
  runner_.tell_time();
  on_bus_state(BusState::Active);
}

bool CanopenFace::restart_bus() noexcept {
  if (!communication_.is_bus_off()) return false;
  runner_.tell_time();
  try_bus_restart();
  return true;
}

IndicatorLeds CanopenFace::leds() const noexcept {
  const drive::DriveUnit& unit = runner_.unit();
  const auto faults = unit.object(drive::kControlUnitNumber)->messages().faults();
  const bool guarding_lost = std::ranges::any_of(faults, [](const drive::FaultEntry& fault) {
    return fault.row->number == kCommunicationError && fault.value == kLifeTimeOver;
  });
  return leds_of(node_.state(), {.off = communication_.is_bus_off(),
                                 .guarding_lost = guarding_lost,
                                 .passive = communication_.bus_state() == BusState::Passive});
}

}  // namespace device
