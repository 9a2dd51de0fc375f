#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

namespace conformance {
namespace {

using std::chrono::milliseconds;

constexpr std::uint8_t kWithSync = 252, kAtOnce = 253, kProfileEvent = 255;
constexpr milliseconds kAnswer{100};

/// A TPDO that answers remote requests.
struct Requested {
  Pdo pdo{};
  std::uint32_t identifier = 0;
};

/// Sets up a TPDO that can be requested; else the check is skipped.
std::optional<Requested> requestable(Context& context, std::uint8_t type, std::vector<MappedObject> mapping = {}) {
  if (!context.session().carries_remote_frames()) {
    context.skip("the bus carries no remote frames");
    return std::nullopt;
  }
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo) return std::nullopt;
  if (mapping.empty()) mapping = calm_mapping(context, *pdo);
  const PdoSetup setup{.type = type,
                       .inhibit_time = std::uint16_t{0},
                       .event_timer = std::uint16_t{0},
                       .mapping = std::move(mapping),
                       .remote_requests = true};
  if (!set_up(context, *pdo, setup)) return std::nullopt;
  const SdoAnswer cob_id = context.read(pdo->parameters(), kCobIdSub);
  if ((cob_id.number() & kBit30) != 0) {
    context.skip(fmt::format("{} keeps bit 30: it answers no remote request", pdo->name()));
    return std::nullopt;
  }
  return Requested{*pdo, identifier_of(context, *pdo)};
}

/// Goes to Operational; whatever comes of it has come.
void start(Context& context) {
  context.enter(canopen::NmtState::Operational);
  context.session().pass(kAnswer);
}

/// How long a frame is waited for that must not come after a remote request: several times as long as an answer
/// was seen to take.
canopen::Duration silent_time(const std::optional<canopen::Duration>& latency) {
  constexpr int kTimesAsLong = 10;
  constexpr canopen::Duration kLeast = milliseconds{20};
  return latency ? std::clamp<canopen::Duration>(kTimesAsLong * *latency, kLeast, kAnswer) : kAnswer;
}

void ask(Context& context, const Requested& requested) {
  context.session().drain();
  context.step();
  context.session().send({.id = requested.identifier, .length = 8, .remote = true});
}

/// What is sent under the identifier of the TPDO when it is requested, within kAnswer; further frames are waited
/// for as long as the first one lets expect.
std::vector<TimedFrame> request(Context& context, const Requested& requested) {
  Session& session = context.session();
  std::optional<canopen::Duration>& latency = context.manners().at_work.request_latency;
  const canopen::TimePoint begin = session.now();
  ask(context, requested);
  const auto first = session.wait_for(under(requested.identifier), kAnswer);
  if (!first) return {};
  latency = std::max(latency.value_or(canopen::Duration::zero()), first->time - begin);
  std::vector<TimedFrame> frames = session.collect(under(requested.identifier), silent_time(latency));
  frames.insert(frames.begin(), *first);
  return frames;
}

/// A finding unless there is one answer.
void expect_one(Context& context, const Requested& requested, std::uint8_t type, std::size_t answers) {
  if (answers == 1) return;
  context.fail(requested.pdo.parameters(), kCobIdSub,
               fmt::format("one frame of {}, type {}, to a remote request", requested.pdo.name(), type),
               fmt::format("{} in 100 ms", answers));
}

void answers_event_driven(Context& context) {
  const auto requested = requestable(context, kProfileEvent);
  if (!requested) return;
  start(context);
  expect_one(context, *requested, kProfileEvent, request(context, *requested).size());
}

/// Sets @p first, lets a SYNC pass, sets @p second: what a request gives then.
void answers_with_values(Context& context, std::uint8_t type) {
  const auto object = changeable(context);
  const auto requested = object ? requestable(context, type, {*object}) : std::nullopt;
  if (!requested) return;
  start(context);
  SyncSource sync{context};
  const std::uint64_t at_sync = change(context, *object);
  sync.send();
  context.session().pass(milliseconds{20});
  const std::uint64_t now = change(context, *object);
  const std::vector<TimedFrame> frames = request(context, *requested);
  expect_one(context, *requested, type, frames.size());
  if (frames.size() != 1) return;
  const std::uint64_t wanted = type == kWithSync ? at_sync : now, value = number_in(frames.front().frame);
  if (value != wanted)
    context.fail(
        requested->pdo.parameters(), kTypeSub,
        fmt::format("{:X}h, the value {}", wanted, type == kWithSync ? "of the last SYNC" : "of the moment"),
        fmt::format("{:X}h", value));
}

void answers_with_the_values_of_the_sync(Context& context) {
  answers_with_values(context, kWithSync);
}

void answers_with_present_values(Context& context) {
  answers_with_values(context, kAtOnce);
}

/// A finding for an answer; what a slow node sent on entering a state before is none.
void expect_silence(Context& context, const Requested& requested, const std::string& where) {
  const auto answers = [&](canopen::Duration span) {
    ask(context, requested);
    return context.session().collect(under(requested.identifier), span);
  };
  if (answers(silent_time(context.manners().at_work.request_latency)).empty()) return;
  context.session().pass(kAnswer);
  if (const auto frames = answers(kAnswer); !frames.empty())
    context.fail(requested.pdo.parameters(), kCobIdSub, "no answer to a remote request " + where,
                 fmt::format("{} frames", frames.size()));
}

void is_silent_elsewhere(Context& context) {
  const auto requested = requestable(context, kProfileEvent);
  if (!requested) return;
  context.enter(canopen::NmtState::Operational);
  context.session().pass(context.quiet(kAnswer));
  context.enter(canopen::NmtState::Stopped);
  expect_silence(context, *requested, "in Stopped");
  context.enter(canopen::NmtState::PreOperational);
  expect_silence(context, *requested, "in Pre-operational");
}

void is_silent_with_bit_30(Context& context) {
  if (!context.session().carries_remote_frames()) return context.skip("the bus carries no remote frames");
  if (context.manners().right.remote_request_forbidden) return;
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo) return;
  const PdoSetup setup{.type = kProfileEvent,
                       .inhibit_time = std::uint16_t{0},
                       .event_timer = std::uint16_t{0},
                       .mapping = calm_mapping(context, *pdo)};
  if (!set_up(context, *pdo, setup)) return;
  start(context);
  expect_silence(context, {*pdo, identifier_of(context, *pdo)}, "while bit 30 is set");
}

constexpr std::array kChecks{
    Check{.id = "pdo.remote-request",
          .name = "An event-driven TPDO answers a remote request while bit 30 of its COB-ID is clear",
          .clause = "CiA 301 7.2.2.5.1",
          .group = Group::Pdo,
          .run = answers_event_driven},
    Check{.id = "pdo.remote-request-forbidden",
          .name = "A TPDO answers no remote request while bit 30 of its COB-ID is set",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = is_silent_with_bit_30},
    Check{.id = "pdo.remote-request-sync",
          .name = "A TPDO of type 252 answers with the values of the last SYNC",
          .clause = "CiA 301 7.2.2.4",
          .group = Group::Pdo,
          .run = answers_with_the_values_of_the_sync},
    Check{.id = "pdo.remote-request-present",
          .name = "A TPDO of type 253 answers with the present values",
          .clause = "CiA 301 7.2.2.4",
          .group = Group::Pdo,
          .run = answers_with_present_values},
    Check{.id = "pdo.remote-request-state",
          .name = "Remote requests of TPDOs are answered in Operational only",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Pdo,
          .run = is_silent_elsewhere},
};

}  // namespace

std::span<const Check> pdo_request_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
