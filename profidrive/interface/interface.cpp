#include "profidrive/interface/interface.hpp"

#include <algorithm>
#include <utility>

namespace profidrive {
namespace {

constexpr std::uint16_t kTimeout = 1910, kNoSignOfLife = 1912, kInterruption = 1920, kConnectionLost = 1925;

// Of r2043.
constexpr std::size_t kNoSetpoints = 0, kRuns = 2;

/// The controlword of the CAN bus has no say in what goes through no input: no halt, the ramp is free.
constexpr std::uint16_t kNeutralControlword = 0x0070;

}  // namespace

Exchange* Interface::find(std::uint8_t object) noexcept {
  const auto found =
      std::ranges::find_if(exchanges_, [=](const Exchange& each) { return each.object().number() == object; });
  return found != exchanges_.end() ? &*found : nullptr;
}
const Exchange* Interface::find(std::uint8_t object) const noexcept {
  const auto found =
      std::ranges::find_if(exchanges_, [=](const Exchange& each) { return each.object().number() == object; });
  return found != exchanges_.end() ? &*found : nullptr;
}

bool Interface::has(std::uint8_t object) const noexcept {
  return assignment_.if1 && find(object) != nullptr;
}

std::span<const std::uint16_t> Interface::sent(std::uint8_t object) const noexcept {
  const Exchange* const exchange = find(object);
  return exchange != nullptr ? exchange->sent() : std::span<const std::uint16_t>{};
}
std::span<const std::uint16_t> Interface::received(std::uint8_t object) const noexcept {
  const Exchange* const exchange = find(object);
  return exchange != nullptr ? exchange->received() : std::span<const std::uint16_t>{};
}
Monitoring::Stage Interface::stage(std::uint8_t object) const noexcept {
  const Exchange* const exchange = find(object);
  return exchange != nullptr ? exchange->monitoring.stage() : Monitoring::Stage::Off;
}
Selection Interface::selection(std::uint8_t object) const noexcept {
  const Exchange* const exchange = find(object);
  return exchange != nullptr ? exchange->selection() : Selection{};
}

void Interface::receive(std::uint8_t object, std::span<const std::uint16_t> words, std::size_t first) noexcept {
  Exchange* const exchange = find(object);
  if (exchange == nullptr || !assignment_.if1) return;
  is_used_ = true;
  exchange->receive(words, first);
  begin(*exchange);
  exchange->monitoring.receive(runner_.now(), {limit_, further_, exchange->fault_delay()});
  watch_sign_of_life(*exchange);
  runner_.wake();
}

/// Process data are exchanged, again or for the first time.
void Interface::begin(Exchange& exchange) noexcept {
  if (exchange.monitoring.stage() == Monitoring::Stage::Interrupted ||
      exchange.monitoring.stage() == Monitoring::Stage::Failed)
    tell(exchange, kInterruption, false);
  if (std::exchange(exchange.connection_lost, false)) tell(exchange, kConnectionLost, false);
  auto& state = exchange.object().if1().interface_state;
  state[kNoSetpoints] = false;
  state[kRuns] = true;
}

void Interface::watch_sign_of_life(Exchange& exchange) noexcept {
  const auto value = exchange.received_sign_of_life();
  if (!value) return;
  const bool is_axis = exchange.object().kind() != drive::ObjectKind::ControlUnit;
  if (exchange.sign_of_life.receive(*value, exchange.tolerance()) && is_axis) tell(exchange, kNoSignOfLife, true);
}

void Interface::touch(std::uint8_t object) noexcept {
  Exchange* const exchange = find(object);
  if (exchange == nullptr) return;
  const bool was_interrupted = exchange->monitoring.stage() == Monitoring::Stage::Interrupted;
  if (was_interrupted) begin(*exchange);
  exchange->monitoring.touch(runner_.now());
}

void Interface::on_connection_lost(std::uint8_t object) noexcept {
  Exchange* const exchange = find(object);
  if (exchange == nullptr || exchange->connection_lost) return;
  exchange->connection_lost = true;
  tell(*exchange, kConnectionLost, true);
}

/// A fault may be acknowledged at once, an alarm stays until it is taken back.
void Interface::tell(Exchange& exchange, std::uint16_t message, bool present) noexcept {
  runner_.tell_time();
  drive::DriveUnit& unit = runner_.unit();
  const std::uint8_t object = exchange.object().number();
  const bool is_fault = message == kTimeout || message == kNoSignOfLife;
  if (present)
    static_cast<void>(unit.raise(object, message, 0, is_fault ? drive::Cause::Gone : drive::Cause::Present));
  else
    unit.withdraw(object, message);
  runner_.show_messages();
}

void Interface::bring() noexcept {
  if (!assignment_.if2) shut_can_out();
  if (!is_used_) return;
  const bool begins = cycle_ == 0;
  if (++cycle_ >= cycles_of_unit_) cycle_ = 0;
  for (Exchange& exchange : exchanges_) {
    if (begins) exchange.take();
    if (exchange.selection().telegram == nullptr) continue;
    exchange.object().process_data().controlword = kNeutralControlword;
    exchange.object().process_data().requested_mode.reset();
  }
}

/// IF2 is assigned nothing: what the CAN bus brings does not act.
void Interface::shut_can_out() noexcept {
  runner_.unit().for_each_object([](drive::DriveObject& object) {
    drive::ProcessDataImage& image = object.process_data();
    image.received = {};
    image.unplaced = {};
    image.controlword = kNeutralControlword;
    image.requested_mode.reset();
  });
}

unit::AxisMask Interface::waiting() const noexcept {
  if (!is_used_) return 0;
  const bool waits = std::ranges::any_of(exchanges_, [](const Exchange& exchange) {
    return exchange.has_new() || exchange.monitoring.waits() || exchange.sign_of_life.runs();
  });
  return waits ? unit::mask_of(1) : 0;
}

void Interface::show() noexcept {
  if (!is_used_ || cycle_ != 0) return;
  for (Exchange& exchange : exchanges_) exchange.sample(runner_.unit().control_unit().clock().is_synchronised());
}

void Interface::on_cycles_over() noexcept {
  if (!is_used_) return;
  for (Exchange& exchange : exchanges_) monitor(exchange);
}

void Interface::monitor(Exchange& exchange) noexcept {
  using Stage = Monitoring::Stage;
  while (exchange.monitoring.advance(runner_.now())) {
    const bool is_axis = exchange.object().kind() != drive::ObjectKind::ControlUnit;
    if (exchange.monitoring.stage() == Stage::Interrupted) {
      auto& state = exchange.object().if1().interface_state;
      state[kNoSetpoints] = true;
      state[kRuns] = false;
      exchange.sign_of_life.stop();
      tell(exchange, kInterruption, true);
    } else if (is_axis) {
      tell(exchange, kTimeout, true);
    }
  }
}

void Interface::adopt(const unit::Replacement& replacement) noexcept {
  using Cause = unit::Replacement::Cause;
  for (Exchange& exchange : exchanges_) {
    if (replacement.object != 0 && exchange.object().number() != replacement.object) continue;
    follow_selection(exchange);
  }
  const bool starts = replacement.cause != Cause::Restored && replacement.group == unit::ParameterGroup::All;
  if (!starts) return;
  for (Exchange& exchange : exchanges_) {
    exchange.monitoring.stop();
    exchange.sign_of_life.stop();
    exchange.connection_lost = false;
    exchange.object().if1().interface_state = {};
  }
  assign();
}

}  // namespace profidrive
