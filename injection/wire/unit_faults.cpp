#include "injection/wire/unit_faults.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "device/objects/sdo_channels.hpp"
#include "injection/wire/kinds.hpp"
#include "libcanopen/base/little_endian.hpp"

namespace injection {
namespace {

constexpr std::size_t kAddressAt = 1, kSubIndexAt = 3, kCodeAt = 4;

canopen::Frame abort_frame(canopen::Identifier identifier, canopen::sdo::Address at, std::uint32_t code) noexcept {
  canopen::Frame frame = canopen::frame_under(identifier, 8);
  frame.data[0] = kAbortCommand;
  canopen::store(&frame.data[kAddressAt], at.index);
  frame.data[kSubIndexAt] = at.sub_index;
  canopen::store(&frame.data[kCodeAt], code);
  return frame;
}

}  // namespace

UnitFaults::UnitFaults(device::Device& device, canopen::FrameSink& bus, UnitHooks& hooks)
    : device_{device}, bus_{bus}, hooks_{hooks}, transfers_(device.node().sdo_servers()) {
  loaded_.reserve(kMost);
  subscriptions_.reserve(kMostSubscriptions);
}

/// What happens is told to all faults; those that @p fits lets act on it and that are hit do.
template <class Fits>
void UnitFaults::judge(const Occurrence& occurrence, const Fits& fits) noexcept {
  for (Loaded& loaded : loaded_) {
    loaded.trigger.note(occurrence, now_);
    bool is_hit = false;
    if (loaded.fault.kind->nature != Nature::Each)
      is_hit = judge_unit(loaded, occurrence);
    else if (fits(loaded) && is_allowed(loaded))
      is_hit = loaded.trigger.on_opportunity(now_);
    if (!is_hit) loaded.trigger.note_healthy(occurrence);
    const bool lasts_a_cycle = loaded.fault.kind->own == EventKind::Cycle;
    if (!lasts_a_cycle || occurrence.kind == EventKind::Cycle) loaded.was_hit = is_hit;
  }
}

/// Without an event the cycles are its opportunities.
bool UnitFaults::judge_unit(Loaded& loaded, const Occurrence& occurrence) noexcept {
  const When& when = loaded.fault.when;
  const Event opportunity = when.event.value_or(Event{loaded.fault.kind->own});
  if (!opportunity.matches(occurrence) || !is_allowed(loaded) || !loaded.trigger.on_opportunity(now_))
    return false;
  loaded.is_pending = loaded.fault.kind->nature == Nature::Moment;
  return true;
}

/// What does not come through to the unit, or from it, is counted all the same.
void UnitFaults::overhear(const Occurrence& occurrence) noexcept {
  judge(occurrence, [](const Loaded&) { return false; });
}

bool UnitFaults::is_allowed(const Loaded& loaded) const noexcept {
  const auto& during = loaded.fault.when.during;
  return !during || is_in_state(*during, loaded);
}

bool UnitFaults::is_in_state(State state, const Loaded& loaded) const noexcept {
  constexpr std::array kNmt{canopen::NmtState::Stopped, canopen::NmtState::PreOperational,
                            canopen::NmtState::Operational};
  if (is_nmt_state(state)) return device_.node().state() == kNmt[static_cast<std::size_t>(state)];
  constexpr std::array kDrive{drive::State::NotReadyToSwitchOn,  drive::State::SwitchOnDisabled,
                              drive::State::ReadyToSwitchOn,     drive::State::SwitchedOn,
                              drive::State::OperationEnabled,    drive::State::QuickStopActive,
                              drive::State::FaultReactionActive, drive::State::Fault};
  const drive::State wanted = kDrive[static_cast<std::size_t>(state) - kNmt.size()];
  const auto axes = device_.unit().axes();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (loaded.fault.allows(Argument::Axis, static_cast<std::uint32_t>(i + 1)) && axes[i].actual().state == wanted)
      return true;
  return false;
}

void UnitFaults::pass(Passing& passing) noexcept {
  const Occurrence occurrence = passing.occurrence();
  judge(occurrence, [&](const Loaded& loaded) {
    const WireKind& kind = wire_kind(*loaded.fault.kind);
    return kind.act != nullptr && Event{loaded.fault.kind->own}.matches(occurrence) &&
           kind.fits(passing, loaded.fault);
  });
  for (Loaded& loaded : loaded_) {
    if (loaded.was_hit && loaded.fault.kind->own != EventKind::Cycle)
      wire_kind(*loaded.fault.kind).act(passing, loaded, device_);
    else if (loaded.trigger.phase() == Phase::Over)
      loaded.kept.clear();
  }
}

void UnitFaults::on_cycle() noexcept {
  judge({.kind = EventKind::Cycle},
        [](const Loaded& loaded) { return loaded.fault.kind->own == EventKind::Cycle; });
}

Transfer* UnitFaults::transfer_of(const Role& role) noexcept {
  const bool is_transfer = role.kind == EventKind::SdoRequest || role.kind == EventKind::SdoResponse;
  return is_transfer ? &transfers_[role.number - 1U] : nullptr;
}

std::optional<AddressShift> UnitFaults::shift() const noexcept {
  return other_node_id_ ? std::optional{AddressShift{device_.node_id(), *other_node_id_}} : std::nullopt;
}

void UnitFaults::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  now_ = now;
  if (is_dark_) return;
  const auto shifted = shift();
  const auto heard = shifted ? shifted->inward(frame) : frame;
  const std::uint32_t identifier = event_identifier(frame);
  const Role role = heard ? role_of(device_, *heard, false) : Role{};
  if (is_gone_ || is_off_ || !heard) {
    overhear({role.kind, identifier});
    return settle(now);
  }
  Passing passing{.frame = *heard, .role = role, .is_sent = false, .identifier = identifier};
  Transfer* const transfer = transfer_of(passing.role);
  if (transfer != nullptr) transfer->on_request(passing.frame);
  passing.transfer = transfer;
  pass(passing);
  if (passing.abort) {
    abort(passing, *transfer);
  } else if (!passing.is_dropped) {
    answers_guard_ = passing.role.kind == EventKind::Guard;
    hooks_.take(passing.frame, now);
    answers_guard_ = false;
  }
  settle(now);
}

/// The server forgets what it had begun, by an abort of its client.
void UnitFaults::abort(const Passing& passing, Transfer& transfer) noexcept {
  const auto server = static_cast<std::size_t>(passing.role.number - 1);
  const canopen::sdo::Address at = transfer.at();
  hooks_.take(abort_frame(canopen::identifier_of(passing.frame), at, *passing.abort), now_);
  const canopen::Identifier identifier =
      device::sdo_identifier(device_.dictionary(), device_.node_id(), server, device::SdoWay::Response);
  if (identifier != 0) send(abort_frame(identifier, at, *passing.abort), canopen::Delivery::Ordered);
  transfer = {};
}

void UnitFaults::send(const canopen::Frame& frame, canopen::Delivery delivery) {
  const auto shifted = shift();
  Passing passing{.frame = frame,
                  .role = role_of(device_, frame, true),
                  .is_sent = true,
                  .identifier = event_identifier(shifted ? shifted->outward(frame) : frame)};
  if (passing.role.kind == EventKind::BootUp) std::ranges::fill(transfers_, Transfer{});  // reset with the node
  if (answers_guard_ && passing.role.kind == EventKind::Heartbeat) passing.role.kind = EventKind::Guard;
  if (Transfer* const transfer = transfer_of(passing.role)) {
    transfer->on_response(passing.frame);
    passing.transfer = transfer;
  }
  if (is_dark_) return;
  now_ = std::max(now_, hooks_.now());
  if (is_gone_ || is_off_) return overhear(passing.occurrence());
  pass(passing);
  if (passing.is_dropped) return;
  for (unsigned copy = 0; copy < passing.copies; ++copy) emit(passing.frame, delivery, passing.delay);
}

void UnitFaults::emit(const canopen::Frame& frame, canopen::Delivery delivery, canopen::Duration delay) noexcept {
  const auto by = shift();
  const canopen::Frame shifted = by ? by->outward(frame) : frame;
  if (!delayed_.keep(shifted, now_ + delay, now_)) bus_.send(shifted, delivery);
}

void UnitFaults::on_time(canopen::TimePoint now) noexcept {
  now_ = now;
  delayed_.send_due(now, bus_);
  for (Loaded& loaded : loaded_) {
    loaded.trigger.on_time(now);
    if (loaded.next <= now) storm(loaded);
  }
  settle(now);
}

canopen::TimePoint UnitFaults::next_deadline() const noexcept {
  canopen::TimePoint deadline = is_dark_ ? dark_until_ : delayed_.deadline();
  for (const Loaded& loaded : loaded_) deadline = std::min({deadline, loaded.trigger.deadline(), loaded.next});
  return deadline;
}

}  // namespace injection
