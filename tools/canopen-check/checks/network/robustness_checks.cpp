#include <algorithm>
#include <array>
#include <random>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/process_data.hpp"
#include "tools/canopen-check/checks/shared/provocation.hpp"
#include "tools/canopen-check/checks/shared/stations.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::NmtCommand;
using canopen::NmtState;

constexpr std::uint32_t kEmcy = 0x80;
/// How long what follows from frames may take.
constexpr canopen::Duration kSettle = std::chrono::milliseconds{100};

bool is_boot_up(const Session& session, const canopen::Frame& frame) {
  return under(session.identifier(function_code::kErrorControl))(frame) && frame.length == 1 && frame.data[0] == 0;
}

/// What the node says of itself before and after.
struct Health {
  std::optional<std::uint64_t> device_type{};
  std::size_t mark = 0;
};

Health health(Context& context) {
  return {.device_type = context.number(object::kDeviceType), .mark = context.session().mark()};
}

/// Findings if the node is not what it was: reset, in another state, or with another device type. kSettle has
/// passed since the frames.
void expect_health(Context& context, const Health& before, const char* after) {
  Session& session = context.session();
  bool was_reset = false;
  const auto judge_reset = [&] {
    const auto is_sign = [&](const TimedFrame& each) { return !each.sent && is_boot_up(session, each.frame); };
    if (was_reset || std::ranges::none_of(session.since(before.mark), is_sign)) return;
    was_reset = true;
    context.fail(fmt::format("no reset by {}", after), "a boot-up message");
  };
  judge_reset();
  if (!context.expect_state(NmtState::PreOperational, after)) return;
  context.sdo().abort(0, 0, 0x08000000);
  session.drain();
  const std::optional<std::uint64_t> now = context.number(object::kDeviceType);
  judge_reset();  // which may take until the node answers again
  if (now && now != before.device_type)
    context.fail(object::kDeviceType, 0, fmt::format("{:X}h still after {}", *before.device_type, after),
                 fmt::format("{:X}h", *now));
}

/// Makes frames that no order is in: no NMT, no download, no data for RPDOs.
class RandomFrames {
 public:
  RandomFrames(Context& context, const std::vector<ValidPdo>& rpdos)
      : random_{context.settings().seed},
        request_{context.session().identifier(function_code::kSdoRequest)},
        error_control_{context.session().identifier(function_code::kErrorControl)},
        sync_{sync_identifier(context)} {
    for (const ValidPdo& rpdo : rpdos) rpdos_.push_back(rpdo.identifier);
  }

  canopen::Frame next() {
    constexpr std::uint64_t kKinds = 8;
    switch (random_() % kKinds) {
      case 0:
        return {.id = sync_, .length = length()};
      case 1:
        return {.id = error_control_, .length = length(), .remote = random_() % 2 != 0};
      case 2:
        if (!rpdos_.empty()) return {.id = rpdos_[random_() % rpdos_.size()]};
        [[fallthrough]];
      default:
        return request();
    }
  }

 private:
  std::uint8_t length() { return static_cast<std::uint8_t>(random_() % 9); }

  canopen::Frame request() {
    // Initiate upload, upload segment, abort, block upload, and one that is none: nothing that writes.
    constexpr std::array<std::uint8_t, 5> kSpecifiers{0x40, 0x60, 0x80, 0xA0, 0xE0};
    constexpr std::uint8_t kFlags = 0x1F;
    canopen::Frame frame{.id = request_, .length = random_() % 8 == 0 ? length() : std::uint8_t{8}};
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random_());
    frame.data[0] =
        static_cast<std::uint8_t>(kSpecifiers[random_() % kSpecifiers.size()] | (frame.data[0] & kFlags));
    if (random_() % 2 != 0) frame.data[2] = 0x10;  // objects that there are
    return frame;
  }

  std::mt19937_64 random_;
  std::uint32_t request_, error_control_, sync_;
  std::vector<std::uint32_t> rpdos_;
};

void survives_random_frames(Context& context) {
  constexpr int kFrames = 10'000, kAtOnce = 8;
  if (!context.observe_state()) return;
  RandomFrames frames{context, valid_pdos(context, object::kRpdoParameter)};
  const Health before = health(context);
  if (!before.device_type) return;
  Session& session = context.session();
  for (int i = 0; i < kFrames && !session.ended(); ++i) {
    canopen::Frame frame = frames.next();
    if (frame.remote && !session.carries_remote_frames()) frame.remote = false;
    session.send(frame);
    if (i % kAtOnce == 0) session.drain();
  }
  context.note(fmt::format("{} random frames, seed {}", kFrames, context.settings().seed));
  context.step();
  session.pass(kSettle);
  expect_health(context, before, "random frames");
}

/// True under the identifiers that the node may send under meanwhile.
bool may_answer(const Context& context, const Session& session, std::optional<std::uint32_t> emcy,
                std::uint32_t identifier) {
  constexpr std::uint32_t kFunctionBits = 0x780;
  if (identifier == session.identifier(function_code::kErrorControl) || identifier == emcy) return true;
  // The first server answers under that of the node; further ones have identifiers of their own.
  return identifier == session.identifier(function_code::kSdoResponse) ||
         (context.eds().has(0x1201) && (identifier & kFunctionBits) == function_code::kSdoResponse);
}

void survives_all_identifiers(Context& context) {
  constexpr std::uint32_t kIdentifiers = 0x800, kLengths = 9, kAtOnce = 8, kMostFindings = 20;
  if (!alone(context, "frames under every identifier") || !context.observe_state()) return;
  const Health before = health(context);
  if (!before.device_type) return;
  Session& session = context.session();
  std::optional<std::uint32_t> emcy = emcy_identifier(context);
  // Without 1014h nothing says that it may not send them.
  if (!emcy && !context.eds().has(object::kCobIdEmcy)) emcy = session.identifier(kEmcy);
  context.step();
  for (const bool remote : {false, true}) {
    if (remote && !session.carries_remote_frames()) continue;
    for (std::uint32_t id = 1; id < kIdentifiers; ++id) {  // 0 is NMT
      // Without data where an RPDO may be: it has no values then.
      const std::uint32_t length = id < function_code::kSdoRequest ? 0 : (id + session.node_id()) % kLengths;
      session.send({.id = id, .length = static_cast<std::uint8_t>(length), .remote = remote});
      if (id % kAtOnce == 0) session.drain();
    }
  }
  session.pass(kSettle);
  std::size_t found = 0;
  for (const TimedFrame& each : session.since(before.mark)) {
    if (each.sent || may_answer(context, session, emcy, each.frame.id) || ++found > kMostFindings) continue;
    context.fail("no frame of the node but answers to SDO requests, guarding and emergency messages",
                 fmt::format("a frame {:03X}h", each.frame.id));
  }
  expect_health(context, before, "frames under every identifier");
}

/// Notes median, 99 % and longest of @p times.
void note_times(Context& context, std::vector<canopen::Duration> times, const char* when) {
  if (times.empty()) return;
  std::ranges::sort(times);
  const auto at = [&](std::size_t percent) { return milliseconds(times[(times.size() - 1) * percent / 100]); };
  context.note(fmt::format("SDO answers {}: median {}, 99 % {}, longest {}, of {}", when, at(50), at(99), at(100),
                           times.size()));
}

void answers_in_time(Context& context, const char* when, const std::function<void()>& meanwhile) {
  constexpr int kRequestsSent = 100;
  const std::size_t first = context.sdo().response_times().size();
  for (int i = 0; i < kRequestsSent; ++i) {
    meanwhile();
    context.step();
    if (context.read(object::kDeviceType).kind != SdoAnswer::Kind::Silent) continue;
    context.fail(object::kDeviceType, 0,
                 fmt::format("an answer within {} {}", milliseconds(context.settings().patience), when), "none");
    break;
  }
  const auto& times = context.sdo().response_times();
  note_times(context, {times.begin() + static_cast<std::ptrdiff_t>(first), times.end()}, when);
}

void answers_when_idle(Context& context) {
  answers_in_time(context, "at idle", [] {});
}

void answers_under_load(Context& context) {
  const std::uint32_t sync = sync_identifier(context);
  if (!synchronous_tpdo(context)) return;
  context.enter(NmtState::Operational);
  answers_in_time(context, "under SYNC", [&] { context.session().send({.id = sync}); });
}

void boots_every_time(Context& context) {
  constexpr int kResets = 20;
  if (!context.may_reset()) return;
  if (context.manners().boots_without_message) return context.skip("the node sends no boot-up message");
  canopen::Duration longest{}, sum{};
  for (int i = 0; i < kResets; ++i) {
    Session& session = context.session();
    context.step();
    session.drain();
    const canopen::TimePoint begin = session.now();
    session.command(i % 2 == 0 ? NmtCommand::ResetCommunication : NmtCommand::ResetNode);
    const auto boot_up = session.wait_for([&](const canopen::Frame& frame) { return is_boot_up(session, frame); },
                                          context.settings().boot_up_limit);
    if (!boot_up && i < 2) return context.skip("the node sends no boot-up message");
    if (!boot_up)
      return context.fail(fmt::format("a boot-up message after each of {} resets", kResets),
                          fmt::format("none after reset {}", i + 1));
    longest = std::max(longest, boot_up->time - begin);
    sum += boot_up->time - begin;
  }
  context.note(fmt::format("{} resets: boot-up after {} on average, {} at most", kResets,
                           milliseconds(sum / kResets), milliseconds(longest)));
}

constexpr std::array kChecks{
    Check{.id = "robustness.random-frames",
          .name = "10 000 random frames leave the node as it was",
          .clause = "CiA 301 7.2",
          .group = Group::Robustness,
          .run = survives_random_frames},
    Check{.id = "robustness.all-identifiers",
          .name = "Data and remote frames under every identifier bring no answer that is not asked for",
          .clause = "CiA 301 7.2",
          .group = Group::Robustness,
          .run = survives_all_identifiers},
    Check{.id = "robustness.sdo-answers",
          .name = "100 SDO requests are answered",
          .clause = "CiA 301 7.2.4",
          .group = Group::Robustness,
          .mode = Mode::ReadOnly,
          .run = answers_when_idle},
    Check{.id = "robustness.sdo-answers-under-load",
          .name = "100 SDO requests are answered between SYNCs in Operational",
          .clause = "CiA 301 7.2.4",
          .group = Group::Robustness,
          .run = answers_under_load},
    Check{.id = "robustness.resets",
          .name = "The node boots after each of 20 resets",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Robustness,
          .run = boots_every_time},
};

}  // namespace

std::span<const Check> robustness_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
