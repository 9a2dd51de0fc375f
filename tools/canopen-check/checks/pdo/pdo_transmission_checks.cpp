#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

namespace conformance {
namespace {

using std::chrono::milliseconds;

constexpr std::uint8_t kProfileEvent = 255;
constexpr int kPeriods = 10;
/// How long a frame may take after an event, a further one included.
constexpr milliseconds kReaction{100};

/// The TPDO of a check, event-driven with @p event_timer, and valid.
std::optional<Pdo> event_driven(Context& context, std::uint16_t event_timer, std::uint8_t type = kProfileEvent) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo) return std::nullopt;
  if (event_timer != 0 && !has_parameter(context, *pdo, kTimerSub)) {
    context.skip(fmt::format("object {} is not there", to_text(Subject{pdo->parameters(), kTimerSub})));
    return std::nullopt;
  }
  const bool done = set_up(context, *pdo,
                           {.type = type,
                            .inhibit_time = std::uint16_t{0},
                            .event_timer = event_timer,
                            .mapping = calm_mapping(context, *pdo)});
  return done ? pdo : std::nullopt;
}

canopen::Duration mean_period(const std::vector<TimedFrame>& frames) {
  return (frames.back().time - frames.front().time) / static_cast<std::int64_t>(frames.size() - 1);
}

/// A finding unless frames under @p identifier come @p wanted apart on the average. Half of them are enough if
/// they do.
void expect_period(Context& context, const Pdo& pdo, std::uint32_t identifier, canopen::Duration wanted) {
  constexpr std::size_t kEnough = kPeriods / 2 + 1;
  const Subject subject{pdo.parameters(), kTimerSub};
  const std::string expected = fmt::format("{} every {}", pdo.name(), conformance::milliseconds(wanted));
  Session& session = context.session();
  const canopen::TimePoint until = session.now() + (kPeriods + 1) * wanted;
  std::vector<TimedFrame> frames = session.collect_first(kEnough, under(identifier), until - session.now());
  if (frames.size() == kEnough && !context.about(mean_period(frames), wanted))
    for (const TimedFrame& frame : session.collect(under(identifier), until - session.now()))
      frames.push_back(frame);
  if (frames.size() < kPeriods / 2)
    return context.fail(subject, expected, fmt::format("{} frames in {} periods", frames.size(), kPeriods + 1));
  const canopen::Duration mean = mean_period(frames);
  if (!context.about(mean, wanted)) context.fail(subject, expected, "every " + conformance::milliseconds(mean));
  context.note(fmt::format("{} every {}", pdo.name(), conformance::milliseconds(mean)));
}

void repeats_with_the_event_timer(Context& context) {
  constexpr std::uint16_t kTime = 50;
  const auto pdo = event_driven(context, kTime);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  context.step();
  context.enter(canopen::NmtState::Operational);
  expect_period(context, *pdo, identifier, milliseconds{kTime});
}

/// What comes under @p identifier within 400 ms of entering Operational.
std::vector<TimedFrame> frames_from_start(Context& context, std::uint32_t identifier) {
  context.step();
  context.enter(canopen::NmtState::Operational);
  return context.session().collect(under(identifier), milliseconds{400});
}

/// The same; half way the TPDO, which answers no remote request, is requested. pdo.remote-request-forbidden, which
/// needs the same silence, is right if nothing comes then.
std::vector<TimedFrame> frames_beside_a_request(Context& context, std::uint32_t identifier) {
  constexpr milliseconds kHalf{200};
  Session& session = context.session();
  context.step();
  context.enter(canopen::NmtState::Operational);
  std::vector<TimedFrame> frames = session.collect(under(identifier), kHalf);
  session.send({.id = identifier, .length = 8, .remote = true});
  const std::vector<TimedFrame> late = session.collect(under(identifier), kHalf);
  context.manners().right.remote_request_forbidden = late.empty();
  frames.insert(frames.end(), late.begin(), late.end());
  return frames;
}

void stops_without_event_timer(Context& context) {
  const auto pdo = event_driven(context, 0);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  const bool may_request = context.session().carries_remote_frames() &&
                           context.manners().ahead.contains("pdo.remote-request-forbidden");
  if (may_request && frames_beside_a_request(context, identifier).size() <= 1) return;
  if (may_request) {
    context.enter(canopen::NmtState::PreOperational);
    context.session().pass(kReaction);
  }
  const auto frames = frames_from_start(context, identifier);
  if (frames.size() > 1)
    context.fail(pdo->parameters(), kTimerSub, "one frame of " + pdo->name() + " at most without an event",
                 fmt::format("{} frames in 400 ms", frames.size()));
}

void takes_an_event_timer_at_once(Context& context) {
  constexpr std::uint16_t kLong = 1000, kShort = 50;
  const auto pdo = event_driven(context, kLong);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  context.enter(canopen::NmtState::Operational);
  context.step();
  const SdoAnswer answer = context.write_number(pdo->parameters(), kTimerSub, kShort);
  if (!answer.done())
    return context.skip(fmt::format("the event timer cannot be written in Operational: {}", to_text(answer)));
  expect_period(context, *pdo, identifier, milliseconds{kShort});
}

void sends_a_first_frame(Context& context) {
  for (const std::uint8_t type : {std::uint8_t{254}, kProfileEvent}) {
    context.enter(canopen::NmtState::PreOperational);
    const auto pdo = event_driven(context, 0, type);
    if (!pdo) return;
    const std::uint32_t identifier = identifier_of(context, *pdo);
    context.session().drain();
    context.step();
    context.enter(canopen::NmtState::Operational);
    if (!context.session().wait_for(under(identifier), milliseconds{250}))
      context.fail(pdo->parameters(), kTypeSub,
                   fmt::format("a frame of {}, type {}, on entering Operational", pdo->name(), type),
                   "none in 250 ms");
  }
}

/// Changes @p object a few times and gives what was sent of it, the end of the inhibit time included.
std::vector<TimedFrame> frames_of_changes(Context& context, const MappedObject& object, std::uint32_t identifier,
                                          canopen::Duration inhibit_time, std::uint64_t& last) {
  constexpr int kChanges = 6;
  context.session().pass(2 * inhibit_time);
  context.step();
  const std::size_t mark = context.session().mark();
  for (int i = 0; i < kChanges; ++i) {
    last = change(context, object);
    context.session().pass(inhibit_time / 4);
  }
  context.session().pass(3 * inhibit_time);
  return frames_since(context, mark, identifier);
}

void keeps_the_inhibit_time(Context& context) {
  constexpr std::uint16_t kInhibit = 800;  // 80 ms
  const auto object = changeable(context);
  const auto pdo = object ? test_pdo(context, PdoDirection::Transmit) : std::nullopt;
  if (!pdo) return;
  const PdoSetup setup{
      .type = kProfileEvent, .inhibit_time = kInhibit, .event_timer = std::uint16_t{0}, .mapping = {*object}};
  if (!set_up(context, *pdo, setup)) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  context.enter(canopen::NmtState::Operational);
  const canopen::Duration inhibit_time = kInhibit * std::chrono::microseconds{100};
  std::uint64_t last = 0;
  const auto frames = frames_of_changes(context, *object, identifier, inhibit_time, last);
  if (frames.empty()) return context.skip("a change of the mapped object makes no frame");
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const canopen::Duration apart = frames[i].time - frames[i - 1].time;
    if (apart + context.settings().slack >= inhibit_time) continue;
    context.fail(pdo->parameters(), kInhibitSub,
                 fmt::format("frames at least {} apart", conformance::milliseconds(inhibit_time)),
                 conformance::milliseconds(apart));
    break;
  }
  if (number_in(frames.back().frame) != last)
    context.fail(pdo->parameters(), kInhibitSub, fmt::format("the last value, {:X}h, in the last frame", last),
                 fmt::format("{:X}h", number_in(frames.back().frame)));
}

void sends_on_a_change(Context& context) {
  const auto object = changeable(context);
  const auto pdo = object ? test_pdo(context, PdoDirection::Transmit) : std::nullopt;
  if (!pdo) return;
  const PdoSetup setup{.type = kProfileEvent,
                       .inhibit_time = std::uint16_t{0},
                       .event_timer = std::uint16_t{0},
                       .mapping = {*object}};
  if (!set_up(context, *pdo, setup)) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  context.enter(canopen::NmtState::Operational);
  context.session().pass(kReaction);
  context.step();
  const std::size_t mark = context.session().mark();
  (void)change(context, *object);
  // The first frame may have come before the answer to the write.
  if (frames_since(context, mark, identifier).empty())
    (void)context.session().wait_for(under(identifier), kReaction);
  context.session().pass(kReaction);
  // Which events an application knows is its own affair: a change of a value need not be one.
  if (frames_since(context, mark, identifier).empty())
    context.note(fmt::format("a change of {} is no event", to_text(Subject{object->index, object->sub_index})));
  else if (frames_since(context, mark, identifier).size() > 1)
    context.fail(pdo->parameters(), kTypeSub, "one frame for one change",
                 fmt::format("{} frames", frames_since(context, mark, identifier).size()));
}

constexpr std::array kChecks{
    Check{.id = "pdo.event-timer",
          .name = "An event-driven TPDO repeats with its event timer",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = repeats_with_the_event_timer},
    Check{.id = "pdo.event-timer-off",
          .name = "An event timer of 0 repeats nothing",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = stops_without_event_timer},
    Check{.id = "pdo.event-timer-change",
          .name = "A new event timer holds from its write on",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = takes_an_event_timer_at_once},
    Check{.id = "pdo.first-frame",
          .name = "An event-driven TPDO is sent on entering Operational",
          .clause = "CiA 301 7.2.2.4",
          .group = Group::Pdo,
          .run = sends_a_first_frame},
    Check{.id = "pdo.event",
          .name = "An event makes one frame",
          .clause = "CiA 301 7.2.2.4",
          .group = Group::Pdo,
          .run = sends_on_a_change},
    Check{.id = "pdo.inhibit-time",
          .name = "The inhibit time keeps frames apart, and the last value is sent when it is over",
          .clause = "CiA 301 7.2.2.6",
          .group = Group::Pdo,
          .run = keeps_the_inhibit_time},
};

}  // namespace

std::span<const Check> pdo_transmission_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
