#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/error/calm.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/silence.hpp"
#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::NmtState;

constexpr std::uint64_t kPeriod = 100, kLongPeriod = 200;  // ms
constexpr canopen::Duration kPeriodTime = std::chrono::milliseconds{kPeriod};

Condition heartbeats(const Session& session) {
  return under(session.identifier(function_code::kErrorControl));
}

/// Switches the heartbeat off, so that a new one begins with its write.
bool silence(Context& context) {
  const SdoAnswer now = context.read(object::kHeartbeatTime);
  if (now.done() && now.number() == 0) return true;
  return context.set(object::kHeartbeatTime, 0, 0);
}

canopen::Duration mean_period(const std::vector<TimedFrame>& beats) {
  return (beats.back().time - beats.front().time) / static_cast<canopen::Duration::rep>(beats.size() - 1);
}

void heartbeat_keeps_its_period(Context& context) {
  constexpr int kPeriods = 10;
  constexpr canopen::Duration kSpan = kPeriodTime * kPeriods + kPeriodTime / 2;
  if (!context.need(object::kHeartbeatTime) || !context.set(object::kHeartbeatTime, 0, kPeriod)) return;
  Session& session = context.session();
  std::vector<TimedFrame> beats = listen_alone(context, heartbeats(session), kSpan);
  if (beats.size() < 2 || !context.about(mean_period(beats), kPeriodTime)) {
    if (!context.set(object::kHeartbeatTime, 0, kPeriod)) return;
    beats = session.collect(heartbeats(session), kSpan);
  }
  session.pass(kPeriodTime / 2);  // so that none is under way when another check begins
  if (beats.size() < 2)
    return context.fail(object::kHeartbeatTime, 0, fmt::format("a heartbeat every {} ms", kPeriod),
                        fmt::format("{} in {} periods", beats.size(), kPeriods));
  const canopen::Duration mean = mean_period(beats);
  canopen::Duration longest{};
  for (std::size_t i = 1; i < beats.size(); ++i) longest = std::max(longest, beats[i].time - beats[i - 1].time);
  context.note(fmt::format("{} ms: mean {}, longest {}", kPeriod, milliseconds(mean), milliseconds(longest)));
  if (!context.about(mean, kPeriodTime))
    context.fail(object::kHeartbeatTime, 0, fmt::format("a heartbeat every {} ms", kPeriod),
                 fmt::format("one every {}", milliseconds(mean)));
}

void heartbeat_begins(Context& context) {
  if (!context.need(object::kHeartbeatTime) || !silence(context)) return;
  constexpr canopen::Duration kLimit = std::chrono::milliseconds{kLongPeriod};
  Session& session = context.session();
  session.drain();
  if (!context.set(object::kHeartbeatTime, 0, kLongPeriod)) return;
  const canopen::TimePoint written = session.now();
  const auto first = session.wait_for(heartbeats(session), 3 * kLimit);
  // None at all is a matter of the period; one that came before the answer to the write has been passed over.
  if (!first) return context.skip("there is no heartbeat");
  const canopen::Duration time = first->time - written;
  context.note(fmt::format("the first heartbeat came {} after the write", milliseconds(time)));
  if (time > kLimit && !context.about(time, kLimit))
    context.fail(object::kHeartbeatTime, 0, fmt::format("the first heartbeat within {} ms", kLongPeriod),
                 fmt::format("after {}", milliseconds(time)));
}

void heartbeat_ends(Context& context) {
  if (!context.need(object::kHeartbeatTime)) return;
  Calm calm{context};
  if (!context.set(object::kHeartbeatTime, 0, kPeriod)) return;
  Session& session = context.session();
  if (!session.wait_for(heartbeats(session), 3 * kPeriodTime))
    return context.skip("there is no heartbeat to be ended");
  if (!context.set(object::kHeartbeatTime, 0, 0)) return;
  session.drain();
  const std::size_t beats = calm.listen(heartbeats(session), 3 * kPeriodTime).size();
  if (beats != 0)
    context.fail(object::kHeartbeatTime, 0, "no heartbeat after 0 is written",
                 fmt::format("{} heartbeats", beats));
}

void heartbeat_tells_the_state(Context& context) {
  if (!context.need(object::kHeartbeatTime) || !context.set(object::kHeartbeatTime, 0, kPeriod)) return;
  Session& session = context.session();
  for (const NmtState state : {NmtState::Operational, NmtState::Stopped, NmtState::PreOperational}) {
    context.step();
    context.enter(state);
    canopen::Frame last{};
    const auto tells = [&, is_beat = heartbeats(session)](const canopen::Frame& frame) {
      if (is_beat(frame)) last = frame;
      return is_beat(frame) && frame.length == 1 && frame.data[0] == static_cast<std::uint8_t>(state);
    };
    if (session.wait_for(tells, 2 * kPeriodTime + kPeriodTime / 2)) continue;
    if (last.id == 0) return context.skip("there is no heartbeat");
    return context.fail(
        fmt::format("a heartbeat of one byte, {:02X}h, in {}", static_cast<unsigned>(state), name_of(state)),
        fmt::format("{} bytes, {}", last.length,
                    hexadecimal(std::span{last.data}.first(std::min<std::size_t>(last.length, 8)))));
  }
}

constexpr std::array kChecks{
    Check{.id = "error-control.heartbeat-period",
          .name = "The heartbeat comes with the period of 1017h",
          .clause = "CiA 301 7.2.8.3.2.2",
          .group = Group::ErrorControl,
          .run = heartbeat_keeps_its_period},
    Check{.id = "error-control.heartbeat-begins",
          .name = "The first heartbeat comes within one period after 1017h is written",
          .clause = "CiA 301 7.2.8.3.2.2",
          .group = Group::ErrorControl,
          .run = heartbeat_begins},
    Check{.id = "error-control.heartbeat-ends",
          .name = "Writing 0 to 1017h ends the heartbeat",
          .clause = "CiA 301 7.5.2.20",
          .group = Group::ErrorControl,
          .run = heartbeat_ends},
    Check{.id = "error-control.heartbeat-state",
          .name = "The heartbeat tells the NMT state",
          .clause = "CiA 301 7.2.8.3.2.2",
          .group = Group::ErrorControl,
          .run = heartbeat_tells_the_state},
};

}  // namespace

std::span<const Check> error_control_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
