#include "device/bus/communication.hpp"

#include <algorithm>

namespace device {
namespace {

constexpr std::uint16_t kClearBusOff = 8608;
constexpr std::size_t kAutomaticRestart = 1;
constexpr std::uint16_t kStartState = 8684;
constexpr std::uint16_t kState = 8685;

constexpr std::uint16_t kCommunicationError = 8700;
constexpr std::uint32_t kBusOff = 1, kLifeTimeOver = 2;  // fault values
constexpr std::uint16_t kRpdosMissing = 8702;
constexpr std::uint16_t kTelegramLoss = 8751;
constexpr std::uint16_t kErrorPassive = 8752;

/// Between two attempts with p8608[1].
constexpr canopen::Duration kRestartPeriod = std::chrono::seconds{2};

/// The drive object that messages of the unit as a whole come from.
constexpr std::uint8_t kOrigin = drive::kControlUnitNumber;

/// Values of p8685; the NMT states have those of error control.
struct CommandRow {
  int value;
  canopen::NmtCommand command;
};
constexpr std::array kCommands{
    CommandRow{4, canopen::NmtCommand::Stop},
    CommandRow{5, canopen::NmtCommand::Start},
    CommandRow{127, canopen::NmtCommand::EnterPreOperational},
    CommandRow{128, canopen::NmtCommand::ResetNode},
    CommandRow{129, canopen::NmtCommand::ResetCommunication},
};

}  // namespace

Communication::Communication(drive::DriveUnit& unit, unit::UnitParameters& parameters, BusFollowUps& follow_ups,
                             const Bus& bus)
    : unit_{unit}, node_{bus.node}, outlet_{bus.node, bus.sink}, follow_ups_{follow_ups} {
  for (const std::uint16_t number : {kClearBusOff, kState}) parameters.answer(number, *this);
}

void Communication::set_start_state() noexcept {
  const double state = unit_.object(drive::kControlUnitNumber)->read(kStartState).value_or(0.0);
  node_.set_start_state(static_cast<canopen::NmtState>(state));
}

void Communication::on_life_time_over() noexcept {
  static_cast<void>(unit_.raise(kOrigin, kCommunicationError, kLifeTimeOver));
}

void Communication::on_rpdos_missing() noexcept {
  static_cast<void>(unit_.raise(kOrigin, kRpdosMissing));
}

void Communication::on_telegram_loss() noexcept {
  static_cast<void>(unit_.raise(kOrigin, kTelegramLoss, 0, drive::Cause::Present));
}

void Communication::on_telegram_loss_over() noexcept {
  unit_.withdraw(kOrigin, kTelegramLoss);
}

void Communication::plan_restart(canopen::TimePoint now, bool asked) noexcept {
  const bool automatic = automatic_restart_ != 0.0;
  if (!is_bus_off() || !(asked || automatic)) {
    restart_at_ = canopen::kNever;
  } else if (asked) {
    restart_at_ = now;
  } else if (restart_at_ == canopen::kNever) {
    restart_at_ = now + kRestartPeriod;
  }
}

bool Communication::on_bus_state(BusState state) noexcept {
  const BusState before = std::exchange(bus_, state);
  if (state == before) return false;
  if (state == BusState::Active) unit_.withdraw(kOrigin, kErrorPassive);
  if (state == BusState::Passive) static_cast<void>(unit_.raise(kOrigin, kErrorPassive, 0, drive::Cause::Present));
  if (state == BusState::Off)
    static_cast<void>(unit_.raise(kOrigin, kCommunicationError, kBusOff, drive::Cause::Ending));
  return before == BusState::Off;
}

void Communication::on_bus_back() noexcept {
  unit_.withdraw(kOrigin, kCommunicationError);
}

std::optional<double> Communication::value_of(const unit::ParameterPlace& place) const noexcept {
  if (place.row.number == kState) return static_cast<double>(node_.state());
  return place.index == kAutomaticRestart ? automatic_restart_ : 0.0;
}

std::optional<drive::Refusal> Communication::take(const unit::ParameterPlace& place, double value) noexcept {
  if (place.row.number == kState) {
    const auto* const row = std::ranges::find(kCommands, static_cast<int>(value), &CommandRow::value);
    if (row == kCommands.end()) return drive::Refusal::IllegalValue;
    follow_ups_.add(BusFollowUp::CommandNode, static_cast<std::uint8_t>(row->command));
    return std::nullopt;
  }
  const bool automatic = place.index == kAutomaticRestart;
  if (automatic) automatic_restart_ = value;
  follow_ups_.add(BusFollowUp::PlanBusRestart, !automatic && value != 0.0 ? 1 : 0);
  return std::nullopt;
}

}  // namespace device
