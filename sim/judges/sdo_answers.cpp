#include "sim/judges/sdo_answers.hpp"

#include <chrono>

#include <fmt/format.h>

#include "libcanopen/base/cob_id.hpp"
#include "sim/unit/simulated_unit.hpp"

namespace sim {
namespace {

using namespace canopen::function_code;

constexpr std::uint8_t kAbort = 0x80;
constexpr std::uint32_t kTimedOut = 0x0504'0000;
constexpr unsigned kCommandAt = 5;
constexpr unsigned kAbortCommand = 4, kBlockDownload = 5, kBlockUpload = 6;

/// The longest time for an answer: that of a save, which may wait for a disk that is slow.
constexpr canopen::Duration kLongest = std::chrono::seconds{2};

unsigned command_of(const canopen::Frame& frame) noexcept {
  return static_cast<unsigned>(frame.data[0]) >> kCommandAt;
}

std::uint32_t code_of(const canopen::Frame& frame) noexcept {
  std::uint32_t code = 0;
  for (unsigned i = 0; i < 4; ++i) code |= static_cast<std::uint32_t>(frame.data[4 + i]) << 8U * i;
  return code;
}

bool has_sdo(canopen::NmtState state) noexcept {
  return state == canopen::NmtState::PreOperational || state == canopen::NmtState::Operational;
}

}  // namespace

void SdoAnswers::forget(const SimulatedUnit& unit, canopen::TimePoint now) {
  seen(unit) = {.known_from = now + kLongest};
}

/// Requests that were read with a stop may be before it, or behind a start that follows.
void SdoAnswers::on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
  using record::EventKind;
  const bool is_mute = event.kind == EventKind::Nmt && !has_sdo(static_cast<canopen::NmtState>(event.number));
  if (is_mute || event.kind == EventKind::Link) forget(unit, event.time);
}

void SdoAnswers::on_taken(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
  if (frame.id != kSdoRequest + unit.node_id() || frame.remote || frame.length != 8 ||
      !has_sdo(unit.instance().device().node().state()))
    return;
  SeenSdoServer& server = seen(unit);
  const unsigned command = command_of(frame);
  const bool is_block = command == kBlockDownload || command == kBlockUpload;
  if (is_block || (command == kAbortCommand && server.owed + server.put_off != 0)) return forget(unit, now);
  if (command == kAbortCommand) return;
  ++(unit.instance().device().is_saving() ? server.put_off : server.owed);
  server.asked = now;
}

void SdoAnswers::on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) {
  if (frame.id != kSdoResponse + unit.node_id() || frame.extended) return;
  if (!unit.instance().faults().is_empty()) return forget(unit, now);
  SeenSdoServer& server = seen(unit);
  const bool ends_by_itself = frame.data[0] == kAbort && code_of(frame) == kTimedOut;
  if (server.owed + server.put_off == 0 && now >= server.known_from && !ends_by_itself)
    break_rule(unit.number(), now, fmt::format("an answer to nothing: {:02X}h", frame.data[0]));
  unsigned& of = server.owed != 0 ? server.owed : server.put_off;
  if (of != 0) --of;
}

void SdoAnswers::on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t) {
  SeenSdoServer& server = seen(unit);
  const axisd::Instance& instance = unit.instance();
  if (!instance.faults().is_empty() || !instance.bus().is_open()) return forget(unit, now);
  if (instance.bus().queue().waiting() != 0)
    server.asked = now;  // the answer may be in front of it
  else if (!instance.device().is_saving())
    server.put_off = 0;  // the answer of the save is out, and was theirs
  if (now < server.known_from || server.owed == 0 || now - server.asked < kLongest) return;
  break_rule(unit.number(), now,
             fmt::format("no answer to a request for {} ms", (now - server.asked).count() / 1'000'000));
}

}  // namespace sim
