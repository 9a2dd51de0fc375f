#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/error/calm.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/provocation.hpp"
#include "tools/canopen-check/checks/shared/stations.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint8_t kToggle = 0x80, kStateBits = 0x7F;
constexpr canopen::Duration kAnswer = std::chrono::milliseconds{100};

/// True if guarding can be asked for; the heartbeat, which would win, is off then.
bool can_guard(Context& context) {
  if (!context.need(object::kGuardTime) || !context.need(object::kLifeTimeFactor)) return false;
  if (!context.session().carries_remote_frames()) {
    context.skip("the bus carries no remote frames");
    return false;
  }
  const SdoAnswer heartbeat = context.read(object::kHeartbeatTime);
  return !heartbeat.done() || heartbeat.number() == 0 || context.set(object::kHeartbeatTime, 0, 0);
}

std::optional<canopen::Frame> guard(Context& context, std::uint8_t node_id) {
  Session& session = context.session();
  session.drain();
  session.send({.id = function_code::kErrorControl + node_id, .length = 1, .remote = true});
  const auto answer = session.wait_for(under(function_code::kErrorControl + node_id), kAnswer);
  if (!answer) return std::nullopt;
  return answer->frame;
}

void answers_guarding(Context& context) {
  if (!can_guard(context)) return;
  context.step();
  const std::optional<canopen::Frame> answer = guard(context, context.session().node_id());
  if (!answer) return context.fail("an answer to a guarding request", "none");
  const auto expected = static_cast<std::uint8_t>(canopen::NmtState::PreOperational);
  if (answer->length != 1 || (answer->data[0] & kStateBits) != expected)
    context.fail(fmt::format("one byte with state {:02X}h", expected),
                 fmt::format("{} bytes, the first {:02X}h", answer->length, answer->data[0]));
}

void toggles(Context& context) {
  constexpr int kRequests = 6;
  if (!can_guard(context) || !context.restart(canopen::NmtCommand::ResetCommunication)) return;
  context.enter(canopen::NmtState::PreOperational);
  if (!can_guard(context)) return;
  context.step();
  std::uint8_t expected = 0;
  for (int i = 0; i < kRequests; ++i, expected ^= kToggle) {
    const std::optional<canopen::Frame> answer = guard(context, context.session().node_id());
    if (!answer) return context.skip("the node answers no guarding request");
    if ((answer->data[0] & kToggle) == expected) continue;
    return context.fail(fmt::format("toggle bit {} in answer {} after a reset", expected == 0 ? 0 : 1, i + 1),
                        fmt::format("{:02X}h", answer->data[0]));
  }
}

void leaves_others_alone(Context& context) {
  if (!can_guard(context)) return;
  Session& session = context.session();
  const std::optional<std::uint8_t> other = unused_node_id(context);
  if (!other) return context.skip("every node-ID is taken by another station");
  context.step();
  session.drain();
  session.send({.id = function_code::kErrorControl + *other, .length = 1, .remote = true});
  const auto own = session.wait_for(under(session.identifier(function_code::kErrorControl)), kAnswer);
  if (own) context.fail(fmt::format("no answer to a guarding request to node {}", *other), "an answer");
}

/// Sets the life time without a request.
bool set_life_time(Context& context) {
  return context.set(object::kGuardTime, 0, kGuardTime) &&
         context.set(object::kLifeTimeFactor, 0, kLifeTimeFactor);
}

void life_guarding_waits(Context& context) {
  if (context.manners().right.life_guarding_begins) return;
  const std::optional<std::uint32_t> emcy = emcy_identifier(context);
  if (!emcy) return context.skip("1014h is invalid");
  if (!can_guard(context) || !context.restart(canopen::NmtCommand::ResetCommunication)) return;
  context.enter(canopen::NmtState::PreOperational);
  if (!can_guard(context) || !set_life_time(context)) return;
  context.step();
  const auto emergency = wait_for_error(context, *emcy, kLifeTime + kEmergencyPatience);
  if (emergency)
    context.fail("no life guarding event before the first request", "emergency message " + to_text(*emergency));
}

/// Life guarding that has begun on a node without an error, and where its event would be told; else the check is
/// skipped.
std::optional<Provocation> guarded(Context& context, std::optional<std::uint32_t>& emcy) {
  if (!can_guard(context) || !context.restart(canopen::NmtCommand::ResetNode)) return std::nullopt;
  context.enter(canopen::NmtState::PreOperational);
  emcy = emcy_identifier(context);
  std::optional<Provocation> how = guarding_loss(context);
  if (!emcy) context.skip("1014h is invalid");
  if (!how) context.skip("life guarding cannot be switched on");
  return emcy ? how : std::nullopt;
}

/// Ends @p how, which the node has told in the step: for the check of the end.
void keep_end(Context& context, const Provocation& how, std::uint32_t emcy) {
  how.end();
  GuardingLoss loss{.end_is_told = wait_for_code(context, emcy, 0, kLifeTime / 2).has_value()};
  loss.traffic.assign(context.traffic().begin(), context.traffic().end());
  context.manners().guarding_loss = std::move(loss);
}

void life_guarding_expires(Context& context) {
  std::optional<std::uint32_t> emcy;
  const std::optional<Provocation> how = guarded(context, emcy);
  if (!how) return;
  context.step();
  context.session().drain();
  how->raise();
  const canopen::TimePoint begin = context.session().now();
  const auto emergency = wait_for_error(context, *emcy, how->delay + kEmergencyPatience);
  const std::string expected = "an emergency message " + milliseconds(kLifeTime) + " after the last request";
  if (!emergency) return context.fail(expected, "none");
  const canopen::Duration time = emergency->frame.time - begin;
  context.manners().at_work.tells_guarding_loss = true;
  note_latency(context, time - how->delay);
  keep_end(context, *how, *emcy);
  context.note(fmt::format("life time {}: told after {}", milliseconds(kLifeTime), milliseconds(time)));
  if (!context.about(time, kLifeTime))
    context.fail(expected, to_text(*emergency) + " after " + milliseconds(time));
}

/// The loss of the guarding master and its end, of the check before or brought about for this one; nothing, and
/// the check is skipped, where it is not told.
const GuardingLoss* ended_loss(Context& context) {
  std::optional<GuardingLoss>& loss = context.manners().guarding_loss;
  if (loss) {
    context.step(loss->traffic);
    return &*loss;
  }
  std::optional<std::uint32_t> emcy;
  const std::optional<Provocation> how = guarded(context, emcy);
  if (!how) return nullptr;
  context.step();
  how->raise();
  if (wait_for_error(context, *emcy, how->delay + kEmergencyPatience)) {
    keep_end(context, *how, *emcy);
    return &*loss;
  }
  context.skip("the loss of the guarding master is not told");
  return nullptr;
}

void life_guarding_resumes(Context& context) {
  const GuardingLoss* const loss = ended_loss(context);
  if (loss == nullptr || loss->end_is_told) return;
  context.manners().errors_last = true;
  context.fail("emergency message 0000h with the next request", "none");
}

/// Writes that would switch on the second protocol are taken; else the findings say which are refused.
bool takes_both(Context& context) {
  constexpr std::uint64_t kPeriod = 100;  // ms
  const std::size_t before = context.findings().size();
  if (!set_life_time(context)) return false;
  if (context.set(object::kHeartbeatTime, 0, kPeriod)) return true;
  if (!context.set(object::kGuardTime, 0, 0) || !context.set(object::kLifeTimeFactor, 0, 0) ||
      !context.set(object::kHeartbeatTime, 0, kPeriod))
    return false;
  (void)context.set(object::kGuardTime, 0, kGuardTime);
  (void)context.set(object::kLifeTimeFactor, 0, kLifeTimeFactor);
  return context.findings().size() == before;
}

/// What comes under the identifier of error control.
struct Heard {
  std::size_t frames = 0;
  bool toggled = false;
};

/// What comes with @p requests guarding requests, @p pause apart.
Heard guard_beside_heartbeat(Context& context, int requests, canopen::Duration pause) {
  Session& session = context.session();
  const std::uint32_t identifier = session.identifier(function_code::kErrorControl);
  Heard heard;
  context.step();
  session.drain();
  for (int i = 0; i < requests; ++i) {
    session.send({.id = identifier, .length = 1, .remote = true});
    for (const TimedFrame& each : session.collect(under(identifier), pause)) {
      ++heard.frames;
      heard.toggled = heard.toggled || (each.frame.data[0] & kToggle) != 0;
    }
  }
  return heard;
}

void heartbeat_wins(Context& context) {
  constexpr int kRequests = 10, kQuickRequests = 12;
  constexpr std::size_t kMostBeats = 7, kMostQuickBeats = 2;
  constexpr canopen::Duration kPause = std::chrono::milliseconds{50};
  if (!context.need(object::kHeartbeatTime) || !can_guard(context)) return;
  if (!guard(context, context.session().node_id())) return context.skip("the node answers no guarding request");
  if (!takes_both(context)) return;
  if (const canopen::Duration quick = context.quiet(kPause); quick * kRequests <= kPause * 2) {
    const Heard heard = guard_beside_heartbeat(context, kQuickRequests, quick);
    if (heard.frames != 0 && heard.frames <= kMostQuickBeats && !heard.toggled) return;
  }
  const auto [frames, toggled] = guard_beside_heartbeat(context, kRequests, kPause);
  if (frames == 0) return context.fail("heartbeats while guarding is set too", "none");
  if (frames > kMostBeats || toggled)
    context.fail("heartbeats of 100 ms, and no answer to guarding requests",
                 fmt::format("{} frames in 500 ms{}", frames, toggled ? ", with toggle bits" : ""));
}

constexpr std::array kChecks{
    Check{.id = "error-control.guarding-answer",
          .name = "A guarding request is answered with the NMT state",
          .clause = "CiA 301 7.2.8.3.2.1",
          .group = Group::ErrorControl,
          .run = answers_guarding},
    Check{.id = "error-control.guarding-toggle",
          .name = "The toggle bit of guarding is 0 after a reset, and alternates",
          .clause = "CiA 301 7.2.8.3.2.1",
          .group = Group::ErrorControl,
          .run = toggles},
    Check{.id = "error-control.guarding-other-node",
          .name = "A guarding request to another node is not answered",
          .clause = "CiA 301 7.2.8.3.2.1",
          .group = Group::ErrorControl,
          .run = leaves_others_alone},
    Check{.id = kLifeGuardingBegins,
          .name = "Life guarding begins with the first request",
          .clause = "CiA 301 7.2.8.2.2.1",
          .group = Group::ErrorControl,
          .run = life_guarding_waits},
    Check{.id = "error-control.life-guarding-event",
          .name = "A master that is silent for the life time is told by an emergency message",
          .clause = "CiA 301 7.2.8.2.2.1",
          .group = Group::ErrorControl,
          .run = life_guarding_expires},
    Check{.id = "error-control.life-guarding-resumes",
          .name = "The next guarding request ends a life guarding event: emergency message 0000h",
          .clause = "CiA 301 7.2.8.2.2.1",
          .group = Group::ErrorControl,
          .run = life_guarding_resumes},
    Check{.id = "error-control.heartbeat-wins",
          .name = "With heartbeat and guarding both set, the heartbeat is in force",
          .clause = "CiA 301 7.2.8.3.2",
          .group = Group::ErrorControl,
          .run = heartbeat_wins},
};

}  // namespace

std::span<const Check> guarding_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
