#include "sim/judges/bus_rules.hpp"

#include <chrono>

#include <fmt/format.h>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/nmt_state.hpp"
#include "sim/unit/simulated_unit.hpp"

namespace sim {
namespace {

using canopen::NmtState;
using namespace canopen::function_code;
using record::EventKind;

constexpr std::uint16_t kHeartbeatTime = 0x1017, kErrorRegister = 0x1001, kTpdo = 0x1800;
constexpr std::int64_t kIdentifier = 0x7FF, kInvalid = 0x8000'0000;
constexpr std::int64_t kFirstEventDriven = 254;

/// What its program may be late in a turn, from when it was due.
constexpr canopen::Duration kLate = std::chrono::microseconds{100};

/// A program that has not run for a while sends what was due in the last of its cycles, from which it counts on.
constexpr canopen::Duration kCycle = std::chrono::milliseconds{1};

const canopen::Dictionary& dictionary_of(const SimulatedUnit& unit) noexcept {
  return unit.instance().device().dictionary();
}

bool is_tampered(const SimulatedUnit& unit) noexcept {
  return !unit.instance().faults().is_empty();
}

/// Whether its frames go out when it sends them.
bool is_heard(const SimulatedUnit& unit) noexcept {
  const axisd::BusTurn& bus = unit.instance().bus();
  return bus.is_open() && bus.queue().waiting() == 0 && bus.port().error_state() != bus::ErrorState::BusOff;
}

/// The position of the TPDO that @p frame is, as the dictionary has it now.
std::optional<std::size_t> tpdo_of(const SimulatedUnit& unit, const canopen::Frame& frame,
                                   std::size_t most) noexcept {
  for (std::size_t i = 0; i < most; ++i) {
    const auto cob_id = dictionary_of(unit).stored(static_cast<std::uint16_t>(kTpdo + i), 1);
    if (cob_id && (*cob_id & kInvalid) == 0 && (*cob_id & kIdentifier) == frame.id) return i;
  }
  return std::nullopt;
}

bool is_boot_up(const SimulatedUnit& unit, const canopen::Frame& frame) noexcept {
  return frame.id == kErrorControl + unit.node_id() && frame.length == 1 && frame.data[0] == 0;
}

}  // namespace

void FirstFrames::on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
  auto& seen = this->seen(unit);
  if (event.kind == EventKind::Link && event.active) seen = {};
  if (event.kind == EventKind::Nmt)
    seen.was_started = event.number == static_cast<std::uint16_t>(NmtState::Operational);
}

void FirstFrames::on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
  auto& seen = this->seen(unit);
  if (is_boot_up(unit, frame)) seen.owes_boot_up = false;
  if (is_tampered(unit)) seen = {.owes_boot_up = false, .was_started = true};
  if (seen.owes_boot_up)
    break_rule(unit.number(), now, fmt::format("{:03X}h before the boot-up message", frame.id));
  if (!seen.was_started && is_heard(unit) && tpdo_of(unit, frame, kJudgedTpdos))
    break_rule(unit.number(), now, fmt::format("TPDO {:03X}h outside Operational", frame.id));
}

/// A new life of the node begins without a past.
void InhibitTimes::on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
  auto& tpdos = seen(unit);
  if (is_boot_up(unit, frame)) tpdos = {};
  const auto position = tpdo_of(unit, frame, tpdos.size());
  if (!position) return;
  const auto index = static_cast<std::uint16_t>(kTpdo + *position);
  const std::int64_t type = dictionary_of(unit).stored(index, 2).value_or(0);
  const bus::TransmitQueue& queue = unit.instance().bus().queue();
  const std::uint64_t waits = queue.counters().queued + queue.counters().refused;
  SeenTpdo& tpdo = tpdos[*position];
  const SeenTpdo before = tpdo;
  tpdo = {now, dictionary_of(unit).stored(index, 3).value_or(0), waits,
          waits == before.waits && queue.waiting() == 0 && now - unit.stalled_until() > kCycle};
  const bool is_judged =
      type >= kFirstEventDriven && before.inhibit == tpdo.inhibit && before.is_punctual && tpdo.is_punctual;
  if (!is_judged || is_tampered(unit)) return;
  const canopen::Duration inhibit = tpdo.inhibit * std::chrono::microseconds{100};
  if (now - before.sent + kLate >= inhibit) return;
  break_rule(unit.number(), now,
             fmt::format("TPDO {}: {} us after the one before, the inhibit time is {} us", *position + 1,
                         (now - before.sent).count() / 1000, inhibit.count() / 1000));
}

void HeartbeatTimes::on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
  if (frame.id == kErrorControl + unit.node_id() && !frame.remote) seen(unit).sent = now;
}

void HeartbeatTimes::on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t) {
  auto& seen = this->seen(unit);
  const std::int64_t period = dictionary_of(unit).stored(kHeartbeatTime, 0).value_or(0);
  const NmtState state = unit.instance().device().node().state();
  const bool is_owed =
      period != 0 && period == seen.period && is_heard(unit) && !is_tampered(unit) &&
      (state == NmtState::PreOperational || state == NmtState::Operational || state == NmtState::Stopped);
  if (!is_owed) seen.sent = now;
  seen.period = period;
  if (!is_owed || seen.sent == canopen::kNever || now - seen.sent <= std::chrono::milliseconds{period} + kLate)
    return;
  break_rule(unit.number(), now,
             fmt::format("none for {} ms, 1017h is {} ms", (now - seen.sent).count() / 1'000'000, period));
}

/// In Stopped, and while there is no bus, nothing is told.
void EmergencyPairs::on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
  const bool is_mute =
      (event.kind == EventKind::Nmt && event.number != static_cast<std::uint16_t>(NmtState::Operational)) ||
      event.kind == EventKind::Link || event.kind == EventKind::Bus;
  if (is_mute) seen(unit) = {};
}

void EmergencyPairs::on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
  if (frame.id != kEmcy + unit.node_id() || frame.length != 8 || is_tampered(unit)) return;
  auto& seen = this->seen(unit);
  const bool is_error = frame.data[0] != 0 || frame.data[1] != 0;
  if (!is_error && frame.data[2] != 0) return;  // an error is gone, others are there
  if (!is_error && seen.told == SeenEmergency::Told::None)
    break_rule(unit.number(), now, "0000h, and no error was told before");
  seen = {.told = is_error ? SeenEmergency::Told::Error : SeenEmergency::Told::None};
}

void EmergencyPairs::on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t) {
  constexpr canopen::Duration kLongest = std::chrono::milliseconds{100};
  auto& seen = this->seen(unit);
  if (is_tampered(unit) || !is_heard(unit)) seen = {};
  const bool owes_end =
      seen.told == SeenEmergency::Told::Error && dictionary_of(unit).stored(kErrorRegister, 0).value_or(0) == 0;
  if (!owes_end) seen.clear_since = canopen::kNever;
  if (owes_end && seen.clear_since == canopen::kNever) seen.clear_since = now;
  if (owes_end && now - seen.clear_since > kLongest)
    break_rule(unit.number(), now, "1001h is 0, and EMCY 0000h has not come");
}

}  // namespace sim
