#include "trace/trigger_table.hpp"

#include <algorithm>
#include <array>

namespace trace {
namespace {

using Is = const TriggerSettings&;

bool is_message(Is is, const Event& event, std::string_view kind) noexcept {
  return event.active && event.kind == kind && (is.number == 0 || is.number == event.number) &&
         (!is.place || *is.place == event.place);
}

bool is_entered(Is is, const Event& event) noexcept {
  return event.kind == event_kind::kDriveState && event.text == name_of(is.state) &&
         (!is.place || *is.place == event.place);
}

bool is_frame(Is is, const Frame& frame) noexcept {
  const FramePattern& wanted = is.frame;
  if (frame.extended != wanted.extended || ((frame.id ^ wanted.id) & wanted.id_mask) != 0) return false;
  if (wanted.direction && *wanted.direction != frame.direction) return false;
  if (frame.length < wanted.length) return false;
  for (std::size_t i = 0; i < wanted.length; ++i)
    if (((frame.data[i] ^ wanted.data[i]) & wanted.data_mask[i]) != 0) return false;
  return true;
}

bool has_bits(Is is, double, double now) noexcept {
  const auto word = static_cast<std::uint32_t>(static_cast<std::int64_t>(now));
  return (word & is.mask) == (is.value & is.mask);
}

constexpr std::uint16_t kLevel = kTakesSignal | kTakesLevel;
constexpr std::uint16_t kBand = kTakesSignal | kTakesBand;
constexpr std::uint16_t kMessage = kTakesPlace | kTakesNumber;

constexpr std::array kRows{
    TriggerRow{TriggerKind::None, "none", 0, "at once", [](Is, double, double) noexcept { return true; }},
    TriggerRow{TriggerKind::Stop, "stop", 0, "never: it records until it is stopped and keeps what came last"},
    TriggerRow{TriggerKind::Rising, "rising", kLevel, "the signal rises to the level or above",
               [](Is is, double before, double now) noexcept { return before < is.level && now >= is.level; }},
    TriggerRow{TriggerKind::Falling, "falling", kLevel, "the signal falls to the level or below",
               [](Is is, double before, double now) noexcept { return before > is.level && now <= is.level; }},
    TriggerRow{TriggerKind::Above, "above", kLevel, "the signal is above the level",
               [](Is is, double, double now) noexcept { return now > is.level; }},
    TriggerRow{TriggerKind::Below, "below", kLevel, "the signal is below the level",
               [](Is is, double, double now) noexcept { return now < is.level; }},
    TriggerRow{TriggerKind::Inside, "inside", kBand, "the signal is inside the band, its ends included",
               [](Is is, double, double now) noexcept { return now >= is.low && now <= is.high; }},
    TriggerRow{TriggerKind::Outside, "outside", kBand, "the signal is outside the band",
               [](Is is, double, double now) noexcept { return now < is.low || now > is.high; }},
    TriggerRow{TriggerKind::Bits, "bits", kTakesSignal | kTakesBits,
               "the signal has the value where the mask has ones", &has_bits},
    TriggerRow{TriggerKind::Fault, "fault", kMessage, "a fault comes, or the one of this number", nullptr,
               [](Is is, const Event& event) noexcept { return is_message(is, event, event_kind::kFault); }},
    TriggerRow{TriggerKind::Alarm, "alarm", kMessage, "an alarm comes, or the one of this number", nullptr,
               [](Is is, const Event& event) noexcept { return is_message(is, event, event_kind::kAlarm); }},
    TriggerRow{TriggerKind::State, "state", kTakesPlace | kTakesState, "the drive state is reached", nullptr,
               &is_entered},
    TriggerRow{TriggerKind::Frame, "frame", kTakesFrame, "a frame of the unit is received or sent", nullptr,
               nullptr, &is_frame},
};
static_assert([] {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].kind != static_cast<TriggerKind>(i)) return false;
  return kRows.back().kind == TriggerKind::Frame;
}());

}  // namespace

std::span<const TriggerRow> trigger_rows() noexcept {
  return kRows;
}

const TriggerRow& row_of(TriggerKind kind) noexcept {
  return kRows[static_cast<std::size_t>(kind)];
}

const TriggerRow* find_trigger(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kRows, name, &TriggerRow::name);
  return row != kRows.end() ? row : nullptr;
}

}  // namespace trace
