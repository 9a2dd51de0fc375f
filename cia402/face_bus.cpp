// What becomes of NMT, of errors of the bus, of time, and of what is saved.
#include <chrono>
#include <utility>

#include "cia402/drive/drive_state.hpp"
#include "cia402/face.hpp"
#include "device/bus/unit_time.hpp"
#include "libcanopen/time/time_of_day.hpp"

namespace cia402 {
namespace {

using canopen::CommunicationError;
using canopen::NmtState;

/// What an SDO client gets for what has become of a save.
canopen::Result<void> answer_to(unit::Keeping keeping) noexcept {
  switch (keeping) {
    case unit::Keeping::Kept:
    case unit::Keeping::Begun:
      return {};
    case unit::Keeping::Refused:
      return canopen::refuse(canopen::AbortCode::DeviceState);
    case unit::Keeping::Failed:
      break;
  }
  return canopen::refuse(canopen::AbortCode::HardwareError);
}

}  // namespace

void Face::start() noexcept {
  if (bus_ != device::BusState::Active) outlet_.lead(true);
  bus_ = device::BusState::Active;
  runner_.take_over_period();
  if (node_.state() == NmtState::Initialising) power_on_axes();
  node_.start(now());
  runner_.show_messages();
}

void Face::power_on_axes() noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    axes_[i].axis().power_on(state_of(runner_.unit().axes()[i]));
    wake_for(i);
  }
}

void Face::on_nmt_state(NmtState from, NmtState to) noexcept {
  listener_.on_nmt_state(from, to);
  runner_.tell_time();
  pending_ = {};
  if (to == NmtState::Operational) return follow_rpdos();
  for (AxisObjects& axis : axes_) axis.axis().set_remote(false, ActingSet{0});
  if (from != NmtState::Operational) return;
  runner_.on_operation_left();
  if (to != NmtState::Initialising) lose_connection();
}

/// In Operational: what RPDOs bring from now on.
void Face::follow_rpdos() noexcept {
  rpdo_actions_.compile(objects_.dictionary, node_.receive_pdos());
  for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].axis().set_remote(true, rpdo_actions_.with_sync(i));
}

/// A master that has led the axes is gone (6007h).
void Face::lose_connection(bool only_late) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (axes_[i].axis().state() != State::OperationEnabled) continue;
    wake_for(i);
    axes_[i].axis().lose_connection(only_late);
  }
}

void Face::on_reset(canopen::NmtCommand command) noexcept {
  const bool all = command == canopen::NmtCommand::ResetNode;
  if (all) {
    if (restarts_unit_)
      runner_.restart_unit();
    else
      runner_.power_off();
    image_.restore(ObjectGroup::All);
    for (std::size_t i = 0; i < axes_.size(); ++i) errors_[i].count = 0;
    power_on_axes();
  } else {
    image_.restore(ObjectGroup::Communication);
    lose_connection();
  }
  runner_.show_messages();
}

bool Face::restart_unit() noexcept {
  restarts_unit_ = true;
  node_.command(canopen::NmtCommand::ResetNode, now());
  restarts_unit_ = false;
  return true;
}

void Face::on_communication_error(CommunicationError error, std::uint16_t) noexcept {
  runner_.tell_time();
  is_told_ = true;
  switch (error) {
    case CommunicationError::LifeGuarding:
    case CommunicationError::Heartbeat:
      lose_connection();
      break;
    case CommunicationError::RpdoTimeout:
      lose_connection(true);
      break;
    case CommunicationError::SyncTimeout:
      for (AxisObjects& axis : axes_)
        if (axis.axis().state() == State::OperationEnabled) axis.axis().fault(error::kSetPointsMissing, true);
      break;
    default:
      break;
  }
  is_told_ = false;
}

void Face::on_bus_state(device::BusState state) noexcept {
  const device::BusState before = bus_;
  bus_ = state;
  if (state == before) return;
  if (state == device::BusState::Off) {
    outlet_.lead(false);
    lose_connection();
    static_cast<void>(listener_.on_bus_restart());
    return;
  }
  if (state == device::BusState::Passive) {
    outlet_.lead(true);
    return node_.report(CommunicationError::ErrorPassive, now());
  }
  outlet_.lead(true);
  node_.report_recovery(CommunicationError::ErrorPassive, now());
  if (before != device::BusState::Off) return;
  node_.report(CommunicationError::BusOffRecovered, now());
  node_.report_recovery(CommunicationError::BusOffRecovered, now());
  if (node_.state() == NmtState::Operational) node_.reload(now());
}

bool Face::restart_bus() noexcept {
  if (bus_ != device::BusState::Off) return false;
  if (listener_.on_bus_restart()) on_bus_state(device::BusState::Active);
  return true;
}

void Face::on_frames_lost() noexcept {
  node_.report(CommunicationError::CanOverrun, now());
  node_.report_recovery(CommunicationError::CanOverrun, now());
}

device::IndicatorLeds Face::leds() const noexcept {
  return device::leds_of(node_.state(), {.off = bus_ == device::BusState::Off,
                                         .guarding_lost = false,
                                         .passive = bus_ == device::BusState::Passive});
}

void Face::on_time_of_day(const canopen::TimeOfDay& time) noexcept {
  const auto day =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::milliseconds{time.milliseconds});
  const auto last =
      std::chrono::duration_cast<std::chrono::microseconds>(runner_.clock().last().time_since_epoch());
  clock_offset_us_ = (day - last).count();
}

tl::expected<void, drive::image_format::Error> Face::load(std::span<const std::byte> image) noexcept {
  auto loaded = image_.adopt(image);
  if (!loaded) return loaded;
  image_.restore(ObjectGroup::All);
  if (const auto node_id = image_.node_id()) node_.set_node_id(*node_id);
  return loaded;
}

std::optional<drive::Refusal> Face::restore() noexcept {
  for (const AxisObjects& axis : axes_)
    if (axis.axis().is_active()) return drive::Refusal::NotNow;
  image_.forget(ObjectGroup::All);
  image_.restore(ObjectGroup::All);
  keeper_.on_restore();
  for (AxisObjects& axis : axes_) axis.axis().scale();
  node_.reload(now());
  return std::nullopt;
}

canopen::Result<void> Face::keep(std::span<const std::byte> image) noexcept {
  if (is_saving_) return canopen::refuse(canopen::AbortCode::DeviceState);
  const unit::Keeping keeping = keeper_.on_store(image);
  is_saving_ = keeping == unit::Keeping::Begun;
  if (keeping == unit::Keeping::Kept) image_.keep();
  return answer_to(keeping);
}

canopen::Result<void> Face::on_store(std::uint8_t sub_index) noexcept {
  auto kept = keep(image_.make(ObjectGroup{sub_index}));
  if (is_saving_) node_.defer_answer();
  return kept;
}

/// Comes into force with the next reset of the node (CiA 301, 7.5.2.14).
canopen::Result<void> Face::on_restore(std::uint8_t sub_index) noexcept {
  if (is_saving_) return canopen::refuse(canopen::AbortCode::DeviceState);
  image_.forget(ObjectGroup{sub_index});
  keeper_.on_restore();
  return keep(image_.make_saved());
}

void Face::on_stored(bool kept) noexcept {
  if (!std::exchange(is_saving_, false)) return;
  if (kept) image_.keep();
  listener_.on_saved(kept);
  node_.answer_deferred(kept ? canopen::Result<void>{} : canopen::refuse(canopen::AbortCode::HardwareError),
                        now());
  lss_.answer_store(kept ? canopen::LssStored::Done : canopen::LssStored::Failed);
}

canopen::LssStored Face::on_lss_store(const canopen::LssSettings& settings) noexcept {
  image_.set_node_id(settings.node_id);
  if (!keep(image_.make_saved())) return canopen::LssStored::Failed;
  return is_saving_ ? canopen::LssStored::Later : canopen::LssStored::Done;
}

}  // namespace cia402
