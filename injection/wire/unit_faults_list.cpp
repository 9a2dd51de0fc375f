#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "injection/wire/actions.hpp"
#include "injection/wire/kinds.hpp"
#include "injection/wire/unit_faults.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/object_index.hpp"

namespace injection {
namespace {

constexpr std::uint32_t kStormCode = 0xFF00;  ///< device specific
constexpr std::uint32_t kStormPeriodMs = 10;
constexpr std::uint8_t kEmcyBytes = 8;
constexpr std::size_t kRegisterAt = 2;

/// Those of every axis begin with a number of their own.
std::optional<std::string> objection_to_pdo(std::span<const canopen::PdoSettings> pdos, std::uint32_t number) {
  std::string ranges;
  for (std::size_t i = 0; i < pdos.size(); ++i) {
    if (pdos[i].number + 1U == number) return std::nullopt;
    const bool begins = i == 0 || pdos[i - 1].number + 1 != pdos[i].number;
    const bool ends = i + 1 == pdos.size() || pdos[i].number + 1 != pdos[i + 1].number;
    if (begins) ranges += fmt::format("{}{}", ranges.empty() ? "" : " or ", pdos[i].number + 1);
    if (ends) ranges += fmt::format(" to {}", pdos[i].number + 1);
  }
  return fmt::format("pdo: expected {}, the PDOs of the unit, got {}", ranges, number);
}

}  // namespace

tl::expected<std::uint32_t, std::string> UnitFaults::add(const Fault& fault) {
  if (auto objection = objection_to(fault)) return tl::unexpected{*std::move(objection)};
  if (loaded_.size() == kMost)
    return tl::unexpected{fmt::format("{} faults are loaded, that is the most: take some back", kMost)};
  now_ = hooks_.now();
  loaded_.push_back({.id = ++last_id_, .fault = fault, .trigger = Trigger{fault, now_}});
  if (loaded_.size() == 1) {
    std::ranges::fill(transfers_, Transfer{});
    hooks_.on_loaded(true);
    drive_faults_.put_in(true);
  }
  Loaded& loaded = loaded_.back();
  if (wire_kind(*fault.kind).act == &actions::freeze) loaded.kept.reserve(device_.node().transmit_pdos().size());
  const bool is_now = !fault.when.event && fault.when.after == 0 && fault.kind->nature != Nature::Each;
  if (is_now && is_allowed(loaded) && loaded.trigger.on_opportunity(now_))
    loaded.is_pending = fault.kind->nature == Nature::Moment;
  drive_faults_.run_cycles(now_);
  on_change();
  return last_id_;
}

std::optional<std::string> UnitFaults::objection_to(const Fault& fault) const {
  const auto exceeds = [&](Argument argument, std::size_t most,
                           std::string_view what) -> std::optional<std::string> {
    if (fault.value_or(argument, 0) <= most) return std::nullopt;
    return fmt::format("{}: expected 1 to {}, the {} of the unit, got {}", row_of(argument).key, most, what,
                       fault.value_or(argument, 0));
  };
  if (auto objection = exceeds(Argument::Axis, device_.unit().axes().size(), "axes")) return objection;
  if (auto objection = exceeds(Argument::Server, transfers_.size(), "SDO servers")) return objection;
  if (!fault.value(Argument::Pdo)) return std::nullopt;
  const bool is_tpdo = fault.kind->own == EventKind::Tpdo;
  return objection_to_pdo(is_tpdo ? device_.node().transmit_pdos() : device_.node().receive_pdos(),
                          *fault.value(Argument::Pdo));
}

bool UnitFaults::remove(std::uint32_t id) {
  const auto found = std::ranges::find(loaded_, id, &Loaded::id);
  if (found == loaded_.end()) return false;
  now_ = hooks_.now();
  if (std::exchange(found->has_begun, false)) end(*found);
  if (is_dark_ && id == dark_by_) dark_until_ = now_;
  loaded_.erase(found);
  drive_faults_.run_cycles(now_);
  on_change();
  return true;
}

std::size_t UnitFaults::remove_all() {
  const std::size_t count = loaded_.size();
  while (!loaded_.empty()) remove(loaded_.back().id);
  return count;
}

/// What is delayed still is when nothing is loaded any more goes out now: no frame is lost by that.
void UnitFaults::on_change() noexcept {
  settle(now_);
  if (!loaded_.empty()) return hooks_.on_subscriptions_changed();
  delayed_.send_due(canopen::kNever, bus_);
  drive_faults_.put_in(false);
  hooks_.on_loaded(false);
  hooks_.on_subscriptions_changed();
}

/// What this does to the unit may make it send, which may be what another fault waits for.
void UnitFaults::settle(canopen::TimePoint now) noexcept {
  if (is_settling_) return;
  is_settling_ = true;
  now_ = std::max(now_, now);
  if (is_dark_ && dark_until_ <= now_) {
    is_dark_ = false;
    hooks_.power_cycle(now_);
  }
  for (Loaded& loaded : loaded_) carry_out(loaded);
  is_settling_ = false;
}

void UnitFaults::carry_out(Loaded& loaded) noexcept {
  if (loaded.is_pending && device_.is_on()) {
    loaded.is_pending = false;
    begin(loaded);
  }
  if (loaded.fault.kind->nature != Nature::Lasting || loaded.trigger.holds() == loaded.has_begun) return;
  loaded.has_begun = !loaded.has_begun;
  if (loaded.has_begun)
    begin(loaded);
  else
    end(loaded);
}

void UnitFaults::begin(Loaded& loaded) noexcept {
  switch (wire_kind(*loaded.fault.kind).doing) {
    case Doing::None:
      return;
    case Doing::Gone:
      is_gone_ = true;
      return delayed_.clear();
    case Doing::Reset:
      return reset(loaded);
    case Doing::NodeId:
      return lead_identifiers();
    case Doing::Passive:
    case Doing::BusOff:
      return lead_bus_state();
    case Doing::Storm:
      loaded.next = now_;
      return storm(loaded);
  }
}

void UnitFaults::end(Loaded& loaded) noexcept {
  switch (wire_kind(*loaded.fault.kind).doing) {
    case Doing::Gone:
      is_gone_ = has_begun(Doing::Gone);
      return;
    case Doing::NodeId:
      return lead_identifiers();
    case Doing::BusOff:
    case Doing::Passive:
      return lead_bus_state();
    case Doing::Storm:
      loaded.next = canopen::kNever;
      return;
    case Doing::None:
    case Doing::Reset:
      return;
  }
}

bool UnitFaults::has_begun(Doing doing) const noexcept {
  return std::ranges::any_of(loaded_, [doing](const Loaded& loaded) {
    return loaded.has_begun && wire_kind(*loaded.fault.kind).doing == doing;
  });
}

void UnitFaults::reset(const Loaded& loaded) noexcept {
  delayed_.clear();
  dark_until_ = now_ + std::chrono::milliseconds{loaded.value(Argument::DelayMs).value_or(0)};
  is_dark_ = dark_until_ > now_;
  dark_by_ = loaded.id;
  hooks_.power_cycle(now_);
}

/// Of several the last one holds.
void UnitFaults::lead_identifiers() noexcept {
  other_node_id_.reset();
  for (const Loaded& loaded : loaded_)
    if (loaded.has_begun && wire_kind(*loaded.fault.kind).doing == Doing::NodeId)
      other_node_id_ = static_cast<std::uint8_t>(loaded.value(Argument::NodeId).value_or(1));
  hooks_.on_subscriptions_changed();
}

/// Of several the worst one holds. A unit that is not switched on is told when it is.
void UnitFaults::lead_bus_state() noexcept {
  using device::BusState;
  const BusState state = has_begun(Doing::BusOff)    ? BusState::Off
                         : has_begun(Doing::Passive) ? BusState::Passive
                                                     : BusState::Active;
  if (state == std::exchange(bus_state_, state)) return;
  is_off_ = false;  // what it has to say of that may be heard still, or again
  if (device_.is_on()) hooks_.set_bus_state(state, now_);
  is_off_ = state == BusState::Off;
  if (is_off_) delayed_.clear();
}

void UnitFaults::on_start(canopen::TimePoint now) noexcept {
  now_ = now;
  if (leads_bus_state()) hooks_.set_bus_state(bus_state_, now);
  drive_faults_.run_cycles(now);
  settle(now);
}

/// As a node sends them: not when it is Stopped or has no identifier for them.
void UnitFaults::storm(Loaded& loaded) noexcept {
  loaded.next = now_ + std::chrono::milliseconds{loaded.value(Argument::PeriodMs).value_or(kStormPeriodMs)};
  const canopen::Dictionary& dictionary = device_.dictionary();
  const auto cob_id = dictionary.stored(canopen::object::kCobIdEmcy, 0);
  const canopen::NmtState state = device_.node().state();
  const bool has_emergencies =
      state == canopen::NmtState::PreOperational || state == canopen::NmtState::Operational;
  if (!cob_id || !has_emergencies) return;
  canopen::Frame frame =
      canopen::frame_under(canopen::valid_identifier(static_cast<std::uint32_t>(*cob_id)), kEmcyBytes);
  if (frame.id == 0) return;
  canopen::store(frame.data.data(), static_cast<std::uint16_t>(loaded.value(Argument::Code).value_or(kStormCode)));
  frame.data[kRegisterAt] =
      static_cast<std::uint8_t>(dictionary.stored(canopen::object::kErrorRegister, 0).value_or(0));
  send(frame, canopen::Delivery::Ordered);
}

std::span<const canopen::Subscription> UnitFaults::subscriptions() noexcept {
  subscriptions_.clear();
  const auto add = [&](canopen::Identifier identifier, bool remote) {
    const canopen::Subscription wanted{identifier, remote};
    const bool has_room = subscriptions_.size() < kMostSubscriptions;
    if (has_room && std::ranges::find(subscriptions_, wanted) == subscriptions_.end())
      subscriptions_.push_back(wanted);
  };
  const auto shifted = shift();
  for (const canopen::Subscription& wanted : device_.subscriptions())
    add(shifted ? shifted->outward(wanted.identifier) : wanted.identifier, wanted.remote);
  for (const Loaded& loaded : loaded_) {
    const When& when = loaded.fault.when;
    if (when.event && when.event->identifier) add(travelling_identifier(*when.event->identifier), false);
    if (when.until && when.until->event.identifier)
      add(travelling_identifier(*when.until->event.identifier), false);
  }
  return subscriptions_;
}

}  // namespace injection
