#include <array>
#include <concepts>

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

/// Sets up a TPDO that can be requested and goes to Operational; else the check is skipped.
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
  const Requested requested{*pdo, identifier_of(context, *pdo)};
  context.enter(canopen::NmtState::Operational);
  context.session().pass(context.quiet(kAnswer));
  return requested;
}

/// What is sent under the identifier of the TPDO when it is requested, within kAnswer. What is right is looked at
/// for as long as the node is seen to need only: what @p is_right does not say so of is asked for once more, when
/// what a slow node sends on entering Operational has come.
std::vector<TimedFrame> request(Context& context, const Requested& requested, std::size_t expected,
                                std::predicate<const std::vector<TimedFrame>&> auto is_right) {
  Session& session = context.session();
  const Condition is_answer = under(requested.identifier);
  const auto ask = [&] {
    session.drain();
    context.step();
    session.send({.id = requested.identifier, .length = 8, .remote = true});
  };
  ask();
  std::vector<TimedFrame> frames = session.collect_first(expected, is_answer, kAnswer);
  if (frames.size() < expected) return frames;
  for (const TimedFrame& frame : session.collect(is_answer, context.quiet(kAnswer))) frames.push_back(frame);
  if (is_right(frames)) return frames;
  session.pass(kAnswer);
  ask();
  return session.collect(is_answer, kAnswer);
}

/// A finding unless there is one answer; its bytes as a number, which should be @p value if that is given.
std::optional<std::uint64_t> expect_one(Context& context, const Requested& requested, std::uint8_t type,
                                        std::optional<std::uint64_t> value = {}) {
  const auto frames = request(context, requested, 1, [&](const std::vector<TimedFrame>& found) {
    return found.size() == 1 && (!value || number_in(found.front().frame) == *value);
  });
  if (frames.size() == 1) return number_in(frames.front().frame);
  context.fail(requested.pdo.parameters(), kCobIdSub,
               fmt::format("one frame of {}, type {}, to a remote request", requested.pdo.name(), type),
               fmt::format("{} in 100 ms", frames.size()));
  return std::nullopt;
}

void answers_event_driven(Context& context) {
  if (const auto requested = requestable(context, kProfileEvent))
    (void)expect_one(context, *requested, kProfileEvent);
}

/// Sets @p first, lets a SYNC pass, sets @p second: what a request gives then.
void answers_with_values(Context& context, std::uint8_t type) {
  const auto object = changeable(context);
  const auto requested = object ? requestable(context, type, {*object}) : std::nullopt;
  if (!requested) return;
  SyncSource sync{context};
  const std::uint64_t at_sync = change(context, *object);
  sync.send();
  context.session().pass(milliseconds{20});
  const std::uint64_t now = change(context, *object);
  const std::uint64_t wanted = type == kWithSync ? at_sync : now;
  const auto value = expect_one(context, *requested, type, wanted);
  if (value && *value != wanted)
    context.fail(
        requested->pdo.parameters(), kTypeSub,
        fmt::format("{:X}h, the value {}", wanted, type == kWithSync ? "of the last SYNC" : "of the moment"),
        fmt::format("{:X}h", *value));
}

void answers_with_the_values_of_the_sync(Context& context) {
  answers_with_values(context, kWithSync);
}

void answers_with_present_values(Context& context) {
  answers_with_values(context, kAtOnce);
}

void expect_silence(Context& context, const Requested& requested, const std::string& where) {
  const auto frames =
      request(context, requested, 0, [](const std::vector<TimedFrame>& found) { return found.empty(); });
  if (!frames.empty())
    context.fail(requested.pdo.parameters(), kCobIdSub, "no answer to a remote request " + where,
                 fmt::format("{} frames", frames.size()));
}

void is_silent_elsewhere(Context& context) {
  const auto requested = requestable(context, kProfileEvent);
  if (!requested) return;
  context.enter(canopen::NmtState::Stopped);
  expect_silence(context, *requested, "in Stopped");
  context.enter(canopen::NmtState::PreOperational);
  expect_silence(context, *requested, "in Pre-operational");
}

void is_silent_with_bit_30(Context& context) {
  if (!context.session().carries_remote_frames()) return context.skip("the bus carries no remote frames");
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo) return;
  const PdoSetup setup{.type = kProfileEvent,
                       .inhibit_time = std::uint16_t{0},
                       .event_timer = std::uint16_t{0},
                       .mapping = calm_mapping(context, *pdo)};
  if (!set_up(context, *pdo, setup)) return;
  const Requested requested{*pdo, identifier_of(context, *pdo)};
  context.enter(canopen::NmtState::Operational);
  context.session().pass(context.quiet(kAnswer));
  expect_silence(context, requested, "while bit 30 is set");
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
