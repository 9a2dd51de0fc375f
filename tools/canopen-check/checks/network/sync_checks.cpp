#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/process_data.hpp"
#include "tools/canopen-check/checks/shared/provocation.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030, kTooHigh = 0x06090031, kTooLow = 0x06090032,
                        kDeviceState = 0x08000022;
constexpr std::uint32_t kStandardBits = 0x7FF;
/// Identifiers that CiA 301 leaves free.
constexpr std::uint32_t kFree = 0x6C1, kOtherFree = 0x6C2;

void sync_has_default_80(Context& context) {
  constexpr std::uint64_t kDefault = 0x80;
  if (!context.need(object::kCobIdSync)) return;
  const eds::EntryFacts* const facts = context.eds().find(object::kCobIdSync);
  if (facts == nullptr || !facts->initial) return context.skip("the EDS states no default of 1005h");
  const std::optional<eds::Integer> value = facts->initial->at(context.eds().node_id());
  if (value && (value->magnitude & kIdentifierBits) != kDefault)
    context.fail(object::kCobIdSync, 0, "default identifier 80h", fmt::format("{:X}h", value->magnitude));
}

void sync_follows_its_cob_id(Context& context) {
  if (!context.need(object::kCobIdSync)) return;
  const std::optional<ValidPdo> tpdo = synchronous_tpdo(context);
  if (!tpdo) return;
  const std::uint32_t before = sync_identifier(context);
  const SdoAnswer written = context.write_number(object::kCobIdSync, 0, kFree);
  if (!written.done())
    return context.skip(fmt::format("1005h does not take identifier {:X}h: {}", kFree, to_text(written)));
  context.step();
  context.enter(canopen::NmtState::Operational);
  context.session().pass(kEmergencyPatience / 10);
  const bool follows = follows_sync(context, *tpdo, kFree), still = follows_sync(context, *tpdo, before);
  if (!follows)
    context.fail(object::kCobIdSync, 0, fmt::format("SYNC under {:X}h, which was written", kFree),
                 "it has no effect");
  if (still)
    context.fail(object::kCobIdSync, 0, fmt::format("no SYNC under {:X}h any more", before),
                 "it still has effect");
}

/// Findings for values that 1019h must not take.
void counter_refuses(Context& context) {
  constexpr std::array kWrong{1, 241, 255};
  if (!context.need(object::kSyncOverflow)) return;
  for (const int value : kWrong) {
    context.step();
    context.expect_abort(context.write_number(object::kSyncOverflow, 0, static_cast<std::uint64_t>(value)),
                         {kInvalidValue, kTooHigh, kTooLow}, object::kSyncOverflow, 0,
                         fmt::format("writing {}", value));
  }
}

void counter_takes(Context& context) {
  if (!context.need(object::kSyncOverflow)) return;
  for (const std::uint64_t value : std::array<std::uint64_t, 3>{2, 240, 0})
    if (!context.set(object::kSyncOverflow, 0, value)) return;
}

void counter_is_locked(Context& context) {
  constexpr std::uint64_t kPeriod = 100'000, kCounter = 10;  // us
  if (!context.need(object::kSyncOverflow) || !context.need(object::kCyclePeriod)) return;
  if (!context.set(object::kCyclePeriod, 0, kPeriod)) return;
  context.step();
  context.expect_abort(context.write_number(object::kSyncOverflow, 0, kCounter), {kDeviceState},
                       object::kSyncOverflow, 0, "writing it while 1006h is not 0");
}

void tells_unexpected_length(Context& context) {
  if (!context.need(object::kSyncOverflow)) return;
  const std::optional<std::uint32_t> emcy = emcy_identifier(context);
  const std::optional<Provocation> how = sync_length(context);
  if (!emcy || !how) return context.skip("1014h is invalid");
  context.step();
  context.session().drain();
  how->raise();
  if (!wait_for_error(context, *emcy, kEmergencyPatience))
    context.fail(object::kSyncOverflow, 0, "an emergency message for a SYNC of unexpected length", "none");
  how->end();
}

/// Sets bit 31 of 1012h: the node consumes TIME. Nothing, and the check is skipped, where it does not.
std::optional<std::uint32_t> consume_time(Context& context) {
  if (!context.need(object::kCobIdTime)) return std::nullopt;
  const std::optional<std::uint64_t> now = context.number(object::kCobIdTime);
  if (!now) return std::nullopt;
  const std::uint32_t consuming = static_cast<std::uint32_t>(*now) | kInvalid;
  const SdoAnswer answer = context.write_number(object::kCobIdTime, 0, consuming);
  if (answer.done()) return consuming;
  context.skip("the node does not consume TIME: 1012h with bit 31 is answered with " + to_text(answer));
  return std::nullopt;
}

void time_cob_id_is_locked(Context& context) {
  const std::optional<std::uint32_t> cob_id = consume_time(context);
  if (!cob_id) return;
  context.step();
  context.expect_abort(context.write_number(object::kCobIdTime, 0, kInvalid | kOtherFree),
                       {kDeviceState, kInvalidValue}, object::kCobIdTime, 0,
                       fmt::format("identifier {:X}h while it consumes TIME", kOtherFree));
}

void time_does_no_harm(Context& context) {
  constexpr std::uint8_t kLongest = 8;
  const std::optional<std::uint32_t> cob_id = consume_time(context);
  if (!cob_id || !context.observe_state()) return;
  Session& session = context.session();
  context.step();
  for (std::uint8_t length = 0; length <= kLongest; ++length)
    session.send({.id = *cob_id & kStandardBits, .length = length, .data = {0x00, 0x5C, 0x26, 0x05, 0xC9, 0x3A}});
  if (!context.expect_state(canopen::NmtState::PreOperational, "time stamps of 0 to 8 bytes")) return;
  (void)context.number(object::kCobIdTime);
}

constexpr std::array kChecks{
    Check{.id = "sync.cob-id-default",
          .name = "SYNC has the identifier 80h by default",
          .clause = "CiA 301 7.5.2.5",
          .group = Group::Sync,
          .mode = Mode::ReadOnly,
          .run = sync_has_default_80},
    Check{.id = "sync.cob-id",
          .name = "SYNC is taken under the identifier that was written to 1005h",
          .clause = "CiA 301 7.5.2.5",
          .group = Group::Sync,
          .run = sync_follows_its_cob_id},
    Check{.id = "sync.counter-refuses",
          .name = "1019h refuses 1 and more than 240",
          .clause = "CiA 301 7.5.2.22",
          .group = Group::Sync,
          .run = counter_refuses},
    Check{.id = "sync.counter-takes",
          .name = "1019h takes 0 and 2 to 240",
          .clause = "CiA 301 7.5.2.22",
          .group = Group::Sync,
          .run = counter_takes},
    Check{.id = "sync.counter-locked",
          .name = "1019h cannot be changed while 1006h is not 0",
          .clause = "CiA 301 7.5.2.22",
          .group = Group::Sync,
          .run = counter_is_locked},
    Check{.id = "sync.unexpected-length",
          .name = "A SYNC with or without counter against 1019h is told by an emergency message",
          .clause = "CiA 301 7.5.2.22",
          .group = Group::Sync,
          .run = tells_unexpected_length},
    Check{.id = "sync.time-cob-id-locked",
          .name = "The identifier of TIME cannot be changed while the node consumes it",
          .clause = "CiA 301 7.5.2.15",
          .group = Group::Sync,
          .run = time_cob_id_is_locked},
    Check{.id = "sync.time-lengths",
          .name = "Time stamps of any length do no harm",
          .clause = "CiA 301 7.2.6",
          .group = Group::Sync,
          .run = time_does_no_harm},
};

}  // namespace

std::span<const Check> sync_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
