#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/told_error.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030, kDeviceState = 0x08000022;
constexpr std::uint32_t kFree = 0x6C3;  // an identifier that CiA 301 leaves free
constexpr std::uint8_t kGenericError = 0x01, kCommunicationError = 0x10;

void emcy_has_default(Context& context) {
  constexpr std::uint32_t kEmcy = 0x80;
  if (!context.need(object::kCobIdEmcy)) return;
  const std::uint32_t expected = context.session().identifier(kEmcy);
  const eds::EntryFacts* const facts = context.eds().find(object::kCobIdEmcy);
  if (facts == nullptr || !facts->initial) return context.skip("the EDS states no default of 1014h");
  const std::optional<eds::Integer> value = facts->initial->at(context.eds().node_id());
  if (value && (value->magnitude & kIdentifierBits) != expected)
    context.fail(object::kCobIdEmcy, 0, fmt::format("default {:X}h, 80h + node-ID", expected),
                 fmt::format("{:X}h", value->magnitude));
}

void cob_id_is_locked(Context& context) {
  if (!context.need(object::kCobIdEmcy)) return;
  if (!emcy_identifier(context)) return context.skip("1014h is invalid");
  context.step();
  context.expect_abort(context.write_number(object::kCobIdEmcy, 0, kFree), {kDeviceState, kInvalidValue},
                       object::kCobIdEmcy, 0, fmt::format("identifier {:X}h while EMCY is valid", kFree));
}

/// Writes 1014h, by way of invalid.
bool move_to(Context& context, const Provoked& provoked, std::uint32_t cob_id) {
  const SdoAnswer off = context.write_number(object::kCobIdEmcy, 0, kInvalid | provoked.identifier);
  const SdoAnswer on = off.done() && cob_id != 0 ? context.write_number(object::kCobIdEmcy, 0, cob_id) : off;
  if (!on.done()) context.skip("1014h cannot be changed: " + to_text(on));
  return on.done();
}

void follows_its_cob_id(Context& context) {
  if (!context.need(object::kCobIdEmcy)) return;
  const ToldError* const told = told_error(context);
  std::optional<Provoked> provoked = told != nullptr ? prepare_again(context, *told) : std::nullopt;
  if (!provoked || !move_to(context, *provoked, kFree)) return;
  const std::uint32_t before = provoked->identifier;
  provoked->identifier = kFree;
  if (!bring_about(context, *provoked))
    context.fail(object::kCobIdEmcy, 0, fmt::format("an emergency message under {:X}h, which was written", kFree),
                 fmt::format("none when {}; it came under {:X}h before", provoked->how.name, before));
}

void is_silenced(Context& context) {
  if (!context.need(object::kCobIdEmcy)) return;
  const ToldError* const told = told_error(context);
  const std::optional<Provoked> provoked = told != nullptr ? prepare_again(context, *told) : std::nullopt;
  if (!provoked || !move_to(context, *provoked, 0)) return;
  if (const auto emergency = bring_about(context, *provoked, emergency_silence(context)))
    context.fail(object::kCobIdEmcy, 0, "no emergency message while bit 31 is set", to_text(*emergency));
}

void keeps_inhibit_time(Context& context) {
  constexpr std::uint64_t kInhibit = 500;  // 100 us
  constexpr canopen::Duration kTime = std::chrono::milliseconds{50};
  if (!context.need(object::kInhibitTimeEmcy)) return;
  const ToldError* const told = told_error(context);
  if (told == nullptr) return;
  if (!told->ends) return context.skip("no error can be ended, which would be told at once");
  const std::optional<Provoked> provoked = prepare_again(context, *told);
  if (!provoked || !context.set(object::kInhibitTimeEmcy, 0, kInhibit)) return;
  context.session().pass(kTime);
  const std::optional<Emergency> first = bring_about(context, *provoked);
  if (!first) return context.skip("the error is not told once more");
  provoked->how.end();
  const auto second = wait_for_emergency(context, provoked->identifier, 3 * kTime / 2);
  if (!second) return context.skip("the end of the error is not told");
  const canopen::Duration apart = second->frame.time - first->frame.time;
  context.note(fmt::format("inhibit time {}: messages {} apart", milliseconds(kTime), milliseconds(apart)));
  if (apart < kTime && !context.about(apart, kTime))
    context.fail(object::kInhibitTimeEmcy, 0, "emergency messages at least " + milliseconds(kTime) + " apart",
                 milliseconds(apart));
}

void has_eight_bytes(Context& context) {
  const ToldError* const told = told_error(context);
  if (told != nullptr && told->message.length != 8)
    context.fail("an emergency message of eight bytes", fmt::format("{} bytes", told->message.length));
}

void has_the_code(Context& context) {
  const ToldError* const told = told_error(context);
  if (told != nullptr && code_of(told->message) != told->code)
    context.fail(fmt::format("error code {:04X}h when {}", told->code, told->name),
                 fmt::format("{:04X}h", code_of(told->message)));
}

void shows_the_register(Context& context) {
  const ToldError* const told = told_error(context);
  if (told == nullptr) return;
  const std::uint8_t in_message = told->message.data[2];
  const auto now = context.number_in(told->error_register, object::kErrorRegister);
  if (now && *now != in_message)
    context.fail(object::kErrorRegister, 0, fmt::format("{:02X}h, as the emergency message says", in_message),
                 fmt::format("{:02X}h", *now));
}

void has_the_bit(Context& context) {
  constexpr std::uint8_t kExpected = kGenericError | kCommunicationError;
  const ToldError* const told = told_error(context);
  if (told != nullptr && (told->message.data[2] & kExpected) != kExpected)
    context.fail(object::kErrorRegister, 0, "bits 0 and 4, generic and communication error, when " + told->name,
                 fmt::format("register {:02X}h", told->message.data[2]));
}

void tells_the_end(Context& context) {
  constexpr std::array<Way, 4> kQuickestFirst{sync_length, short_rpdo, heartbeat_loss, guarding_loss};
  const std::optional<Provoked> provoked = provoke(context, kQuickestFirst);
  if (!provoked) return;
  if (!provoked->how.end) return context.skip("no error can be ended");
  context.session().drain();
  provoked->how.end();
  if (!wait_for_code(context, provoked->identifier, 0, kEmergencyPatience / 4))
    context.fail(fmt::format("error code 0000h once it is over that {}", provoked->how.name), "none");
}

constexpr std::array kChecks{
    Check{.id = "emcy.cob-id-default",
          .name = "Emergency messages have the identifier 80h + node-ID by default",
          .clause = "CiA 301 7.5.2.17",
          .group = Group::Emcy,
          .mode = Mode::ReadOnly,
          .run = emcy_has_default},
    Check{.id = "emcy.cob-id-locked",
          .name = "The identifier of EMCY cannot be changed while it is valid",
          .clause = "CiA 301 7.5.2.17",
          .group = Group::Emcy,
          .run = cob_id_is_locked},
    Check{.id = "emcy.cob-id",
          .name = "Emergency messages come under the identifier that was written to 1014h",
          .clause = "CiA 301 7.5.2.17",
          .group = Group::Emcy,
          .run = follows_its_cob_id},
    Check{.id = "emcy.disabled",
          .name = "Bit 31 of 1014h silences EMCY",
          .clause = "CiA 301 7.5.2.17",
          .group = Group::Emcy,
          .run = is_silenced},
    Check{.id = "emcy.inhibit-time",
          .name = "Emergency messages keep the inhibit time of 1015h",
          .clause = "CiA 301 7.5.2.18",
          .group = Group::Emcy,
          .run = keeps_inhibit_time},
    Check{.id = "emcy.length",
          .name = "An emergency message has eight bytes",
          .clause = "CiA 301 7.2.7.3.1",
          .group = Group::Emcy,
          .run = has_eight_bytes},
    Check{.id = "emcy.code",
          .name = "An error of the communication has its error code",
          .clause = "CiA 301 7.2.7.1",
          .group = Group::Emcy,
          .run = has_the_code},
    Check{.id = "emcy.register",
          .name = "Emergency messages show the error register 1001h",
          .clause = "CiA 301 7.2.7.3.1",
          .group = Group::Emcy,
          .run = shows_the_register},
    Check{.id = "emcy.register-bits",
          .name = "An error of the communication sets bits 0 and 4 of the error register",
          .clause = "CiA 301 7.5.2.2",
          .group = Group::Emcy,
          .run = has_the_bit},
    Check{.id = "emcy.error-reset",
          .name = "The end of an error is told by error code 0000h",
          .clause = "CiA 301 7.2.7.1",
          .group = Group::Emcy,
          .run = tells_the_end},
};

}  // namespace

std::span<const Check> emcy_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
