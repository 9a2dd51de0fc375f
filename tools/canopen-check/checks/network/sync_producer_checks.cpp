#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/process_data.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030, kDeviceState = 0x08000022;
constexpr std::uint64_t kPeriod = 20'000;  // us
constexpr canopen::Duration kPeriodTime = std::chrono::microseconds{kPeriod};
constexpr int kPeriods = 10;

/// Lets the node produce SYNC with @p counter as overflow value of its counter, where it has one: the identifier.
/// Nothing, and the check is skipped, where it does not.
std::optional<std::uint32_t> produce(Context& context, std::uint64_t counter = 0) {
  if (!context.need(object::kCobIdSync) || !context.need(object::kCyclePeriod)) return std::nullopt;
  if (counter != 0 && !context.need(object::kSyncOverflow)) return std::nullopt;
  const std::uint32_t identifier = sync_identifier(context);
  if (!context.set(object::kCyclePeriod, 0, 0)) return std::nullopt;
  const SdoAnswer answer = context.write_number(object::kCobIdSync, 0, kBit30 | identifier);
  if (!answer.done()) {
    context.skip("the node produces no SYNC: 1005h with bit 30 is answered with " + to_text(answer));
    return std::nullopt;
  }
  if (counter != 0 && !context.set(object::kSyncOverflow, 0, counter)) return std::nullopt;
  if (!context.set(object::kCyclePeriod, 0, kPeriod)) return std::nullopt;
  context.session().drain();
  return identifier;
}

std::vector<TimedFrame> syncs(Context& context, std::uint32_t identifier) {
  return context.session().collect(under(identifier), kPeriodTime * kPeriods + kPeriodTime / 2);
}

void keeps_its_period(Context& context) {
  const std::optional<std::uint32_t> identifier = produce(context);
  if (!identifier) return;
  context.step();
  const std::vector<TimedFrame> frames = syncs(context, *identifier);
  const std::string expected = "a SYNC every " + milliseconds(kPeriodTime);
  if (frames.size() < 2)
    return context.fail(object::kCyclePeriod, 0, expected,
                        fmt::format("{} in {} periods", frames.size(), kPeriods));
  const canopen::Duration mean =
      (frames.back().time - frames.front().time) / static_cast<canopen::Duration::rep>(frames.size() - 1);
  context.note("SYNC: mean period " + milliseconds(mean));
  if (!context.about(mean, kPeriodTime))
    context.fail(object::kCyclePeriod, 0, expected, "one every " + milliseconds(mean));
}

void ends(Context& context) {
  const std::optional<std::uint32_t> identifier = produce(context);
  if (!identifier) return;
  if (syncs(context, *identifier).empty()) return context.skip("there is no SYNC to be ended");
  if (!context.set(object::kCyclePeriod, 0, 0)) return;
  context.session().drain();
  const std::size_t found = syncs(context, *identifier).size();
  if (found != 0)
    context.fail(object::kCyclePeriod, 0, "no SYNC after 0 is written to 1006h", fmt::format("{} SYNCs", found));
}

void is_silent_in_stopped(Context& context) {
  const std::optional<std::uint32_t> identifier = produce(context);
  if (!identifier) return;
  if (syncs(context, *identifier).empty()) return context.skip("there is no SYNC to be stopped");
  context.enter(canopen::NmtState::Stopped);
  context.session().pass(kPeriodTime);
  context.step();
  const std::size_t found = syncs(context, *identifier).size();
  if (found != 0) context.fail(object::kCobIdSync, 0, "no SYNC in Stopped", fmt::format("{} SYNCs", found));
}

void counts(Context& context) {
  constexpr std::uint8_t kCounter = 4;
  const std::optional<std::uint32_t> identifier = produce(context, kCounter);
  if (!identifier) return;
  context.step();
  const std::vector<TimedFrame> frames = syncs(context, *identifier);
  if (frames.empty()) return context.skip("there is no SYNC");
  std::uint8_t expected = frames.front().frame.data[0];
  for (const TimedFrame& each : frames) {
    const bool right = each.frame.length == 1 && each.frame.data[0] == expected && expected >= 1;
    if (!right)
      return context.fail(object::kSyncOverflow, 0, fmt::format("a SYNC with counter {}", expected),
                          fmt::format("{} bytes, counter {}", each.frame.length, each.frame.data[0]));
    expected = expected == kCounter ? std::uint8_t{1} : static_cast<std::uint8_t>(expected + 1);
  }
}

void has_no_counter(Context& context) {
  if (context.eds().has(object::kSyncOverflow) && !context.set(object::kSyncOverflow, 0, 0)) return;
  const std::optional<std::uint32_t> identifier = produce(context);
  if (!identifier) return;
  context.step();
  const std::vector<TimedFrame> frames = syncs(context, *identifier);
  const auto wrong = std::ranges::find_if(frames, [](const TimedFrame& each) { return each.frame.length != 0; });
  if (wrong != frames.end())
    context.fail(object::kSyncOverflow, 0, "a SYNC without data while 1019h is 0",
                 fmt::format("{} bytes", wrong->frame.length));
}

void is_locked(Context& context) {
  constexpr std::uint32_t kFree = 0x6C1;
  const std::optional<std::uint32_t> identifier = produce(context);
  if (!identifier) return;
  context.step();
  context.expect_abort(context.write_number(object::kCobIdSync, 0, kBit30 | kFree), {kDeviceState, kInvalidValue},
                       object::kCobIdSync, 0, "another identifier while SYNC is produced");
}

constexpr std::array kChecks{
    Check{.id = "sync.producer-period",
          .name = "SYNC is produced with the period of 1006h",
          .clause = "CiA 301 7.5.2.6",
          .group = Group::Sync,
          .run = keeps_its_period},
    Check{.id = "sync.producer-ends",
          .name = "Writing 0 to 1006h ends the production of SYNC",
          .clause = "CiA 301 7.5.2.6",
          .group = Group::Sync,
          .run = ends},
    Check{.id = "sync.producer-in-stopped",
          .name = "No SYNC is produced in Stopped",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Sync,
          .run = is_silent_in_stopped},
    Check{.id = "sync.producer-counter",
          .name = "The counter of SYNC runs from 1 to the value of 1019h",
          .clause = "CiA 301 7.5.2.22",
          .group = Group::Sync,
          .run = counts},
    Check{.id = "sync.producer-without-counter",
          .name = "SYNC has no data while 1019h is 0",
          .clause = "CiA 301 7.5.2.22",
          .group = Group::Sync,
          .run = has_no_counter},
    Check{.id = "sync.producer-cob-id-locked",
          .name = "The identifier of SYNC cannot be changed while it is produced",
          .clause = "CiA 301 7.5.2.5",
          .group = Group::Sync,
          .run = is_locked},
};

}  // namespace

std::span<const Check> sync_producer_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
