// What parameters of IF1 lead to, and what they show.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "profidrive/interface/interface.hpp"
#include "profidrive/telegram/parameter_numbers.hpp"
#include "profidrive/telegram/telegrams.hpp"

namespace profidrive {
namespace {

using namespace parameter;

constexpr double kModbusTcp = 13.0;  // p2030
constexpr double kNotConnected = 65535.0;
constexpr std::uint16_t kWrongAssignment = 8550;  // A08550

/// Those that are asked for here.
constexpr std::array kAnswered{
    kSelection,        kExtendedSelection, kProtocol,   kWithoutControl, kMonitoringTime, kFaultDelay,
    kSignOfLife,       kFurtherTime,       kTolerance,  kCycle,          kState,          kWrongSignsOfLife,
    kHighestConnected, kOffsetReceived,    kOffsetSent, kAssignment};

// r2054
constexpr double kNoConnection = 1.0, kCyclic = 4.0;

/// The words of a source on the receiving side: r2050, r2060, r2090 to r2093.
struct ReceivedRange {
  std::size_t first = 0;
  std::size_t words = 0;
};
ReceivedRange words_of(const drive::BicoSource& source) noexcept {
  constexpr std::uint16_t kWordsWithBits = 4;
  if (source.number == kReceivedWord) return {source.position, 1};
  if (source.number == kReceivedDoubleWord) return {source.position, 2};
  if (source.number >= kReceivedBits && source.number < kReceivedBits + kWordsWithBits)
    return {static_cast<std::size_t>(source.number - kReceivedBits), 1};
  return {};
}

/// The words of @p object that the inputs of @p placed, a parameter of @p owner, take, told to @p visit.
template <class Visit>
void visit_uses(const drive::DriveObject& owner, const drive::PlacedRow& placed, const drive::DriveObject& object,
                const Visit& visit) {
  for (std::size_t i = 0; i < placed.row->count; ++i) {
    const drive::BicoSource source = drive::unpack(static_cast<std::uint32_t>(owner.value(placed, i)));
    const std::uint8_t from = source.object == drive::kOwnObject ? owner.number() : source.object;
    if (from == object.number()) visit(words_of(source));
  }
}
/// The same of all inputs of @p unit.
template <class Visit>
void for_each_use(const drive::DriveUnit& unit, const drive::DriveObject& object, const Visit& visit) {
  unit.for_each_object([&](const drive::DriveObject& owner) {
    for (const drive::PlacedRow& placed : drive::parameters_of(owner.kind()))
      if (drive::is_bico_input(placed.row->type) && owner.provides(*placed.row))
        visit_uses(owner, placed, object, visit);
  });
}

std::size_t highest_received(const drive::DriveUnit& unit, const drive::DriveObject& object) noexcept {
  std::size_t highest = 0;
  for_each_use(unit, object, [&](const ReceivedRange& range) {
    if (range.words != 0) highest = std::max(highest, range.first + range.words);
  });
  return highest;
}
bool is_received(const drive::DriveUnit& unit, const drive::DriveObject& object, std::size_t word) noexcept {
  bool found = false;
  for_each_use(unit, object, [&](const ReceivedRange& range) {
    found = found || (word >= range.first && word < range.first + range.words);
  });
  return found;
}

bool is_sent(const drive::DriveObject& object, std::size_t word) noexcept {
  const auto wired = [&](std::uint16_t number, std::size_t index) {
    return object.kept_value(number, index).value_or(0.0) > 0.0;
  };
  return wired(kSentWord, word) || wired(kSentDoubleWord, word) || (word > 0 && wired(kSentDoubleWord, word - 1));
}
std::size_t highest_sent(const drive::DriveObject& object) noexcept {
  std::size_t word = drive::If1Image::kSentWords;
  while (word > 0 && !is_sent(object, word - 1)) --word;
  return word;
}

}  // namespace

Interface::Interface(unit::Runner& runner) : runner_{runner} {
  runner.unit().for_each_object([this](drive::DriveObject& object) {
    if (drive::contains(drive::kWithProcessData, object.kind())) exchanges_.emplace_back(object);
  });
  for (const std::uint16_t number : kAnswered) runner.parameters().answer(number, *this);
  runner.parameters().lock_by(*this);
}

std::size_t Interface::words_to_send(std::uint8_t object) const noexcept {
  const Exchange* const exchange = find(object);
  if (exchange == nullptr) return 0;
  const Telegram* const telegram = exchange->selection().telegram;
  return std::max(telegram != nullptr ? profidrive::words_of(telegram->sent) : 0,
                  highest_sent(exchange->object()));
}

std::optional<double> Interface::value_of(const unit::ParameterPlace& place) const noexcept {
  const Exchange* const exchange = find(place.object.number());
  if (exchange == nullptr) return std::nullopt;
  const auto is_running = [](const Exchange& each) {
    return each.monitoring.stage() == Monitoring::Stage::Running;
  };
  const auto offset = [&](bool connected) {
    return connected ? static_cast<double>(place.index * sizeof(std::uint16_t)) : kNotConnected;
  };
  switch (place.row.number) {
    case kProtocol:
      return serves_modbus_ ? std::optional{kModbusTcp} : std::nullopt;
    case kState:
      return std::ranges::any_of(exchanges_, is_running) ? kCyclic : kNoConnection;
    case kWrongSignsOfLife:
      return exchange->sign_of_life.total_wrong();
    case kHighestConnected:
      return static_cast<double>(place.index == 0 ? highest_received(runner_.unit(), place.object)
                                                  : highest_sent(place.object));
    case kOffsetReceived:
      return offset(is_received(runner_.unit(), place.object, place.index));
    case kOffsetSent:
      return offset(is_sent(place.object, place.index));
    default:
      return std::nullopt;
  }
}

std::optional<drive::Refusal> Interface::take(const unit::ParameterPlace& place, double value) noexcept {
  if (place.row.number == kAssignment)
    return is_hardware(value) ? std::nullopt : std::optional<drive::Refusal>{drive::Refusal::IllegalValue};
  Exchange* const exchange = find(place.object.number());
  if (exchange == nullptr) return std::nullopt;
  switch (place.row.number) {
    case kSelection:
      return select_standard(*exchange, value);
    case kExtendedSelection:
      return select_extended(*exchange, value);
    default:
      break;
  }
  follow(place.row.number, value);
  exchange->follow(place.row.number, value);
  return std::nullopt;
}

/// What the interface has of its own of parameter @p number of the control unit.
void Interface::follow(std::uint16_t number, double value) noexcept {
  const auto time = std::chrono::duration_cast<unit::Duration>(std::chrono::duration<double, std::milli>{value});
  if (number == kMonitoringTime) limit_ = time;
  if (number == kFurtherTime) further_ = time;
  if (number == kCycle) follow_cycle(value);
}

/// p0922: p2079 follows.
std::optional<drive::Refusal> Interface::select_standard(Exchange& exchange, double telegram) noexcept {
  const Selection selection{find_telegram(exchange.object(), telegram), Reach::Everything};
  if (selection.telegram == nullptr && telegram != telegrams::kFreeWords) return drive::Refusal::IllegalValue;
  exchange.object().bring_in(kExtendedSelection, 0, telegram);
  select(exchange, selection);
  return std::nullopt;
}

std::optional<drive::Refusal> Interface::select_extended(Exchange& exchange, double telegram) noexcept {
  const Selection selection{find_telegram(exchange.object(), telegram), Reach::Words};
  if (selection.telegram == nullptr && telegram != telegrams::kFreeWords) return drive::Refusal::IllegalValue;
  select(exchange, selection);
  return std::nullopt;
}

void Interface::select(Exchange& exchange, const Selection& selection) noexcept {
  const bool is_new = selection != exchange.selection();
  exchange.select(selection);
  if (!is_new || selection.telegram == nullptr) return;
  is_used_ = true;
  wire(exchange.object(), selection, FreeWords::Propose);
  exchange.follow_parameters();
}

/// The parameters of the drive object have become others: what is selected holds its inputs, whatever they were
/// loaded with. What was not wired so before gets the free words, too.
void Interface::follow_selection(Exchange& exchange) noexcept {
  drive::DriveObject& object = exchange.object();
  const Selection selection = selection_of(object);
  const double standard = selection.telegram != nullptr && selection.reach == Reach::Everything
                              ? selection.telegram->number
                              : telegrams::kFreeWords;
  object.bring_in(kSelection, 0, standard);
  if (standard != telegrams::kFreeWords || selection.telegram == nullptr)
    object.bring_in(kExtendedSelection, 0, standard);
  exchange.select(selection);
  for (const std::uint16_t number : {kMonitoringTime, kFurtherTime, kCycle})
    follow(number, control_unit().kept_value(number).value_or(0.0));
  if (selection.telegram == nullptr) return exchange.follow_parameters();
  is_used_ = true;
  const bool was_wired = object.kept_value(kSentWord).value_or(0.0) > 0.0;
  wire(object, selection, was_wired ? FreeWords::Stay : FreeWords::Propose);
  exchange.follow_parameters();
}

/// @p period: p2048 (ms). It cannot be shorter than a cycle of the unit.
void Interface::follow_cycle(double period) noexcept {
  const double cycle = control_unit().kept_value(kCycleOfUnit).value_or(1.0);
  cycles_of_unit_ = static_cast<unsigned>(std::max(1.0, std::round(period / cycle)));
  cycle_ = 0;
}

bool Interface::holds(const drive::DriveObject& object, std::uint16_t number, std::size_t index) const noexcept {
  if (number == kProtocol && serves_modbus_) return true;
  const Exchange* const exchange = find(object.number());
  return exchange != nullptr && is_held(object, exchange->selection(), number, index);
}

/// p8839 as of power-on.
void Interface::assign() noexcept {
  const auto hardware = [this](std::size_t index) {
    return Hardware{static_cast<std::uint8_t>(control_unit().kept_value(kAssignment, index).value_or(0.0))};
  };
  assignment_ = assignment_of(hardware(0), hardware(1));
  if (assignment_.is_valid)
    runner_.unit().withdraw(control_unit().number(), kWrongAssignment);
  else
    static_cast<void>(runner_.unit().raise(control_unit().number(), kWrongAssignment, 0, drive::Cause::Present));
}

}  // namespace profidrive
