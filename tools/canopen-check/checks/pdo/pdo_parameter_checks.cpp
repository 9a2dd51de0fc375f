#include <array>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/finding_limit.hpp"

namespace conformance {
namespace {

using enum canopen::AbortCode;

/// Identifiers that no service of the predefined connection set has.
constexpr std::uint32_t kFree = 0x6A1, kOtherFree = 0x6A2;
constexpr std::uint32_t kFrameBit = 0x2000'0000;

void has_no_reserved_entry(Context& context) {
  FindingLimit findings{context};
  int tried = 0;
  for (const PdoDirection direction : {PdoDirection::Receive, PdoDirection::Transmit})
    for (const Pdo& pdo : all_pdos(context, direction)) {
      ++tried;
      context.step();
      const SdoAnswer answer = context.read(pdo.parameters(), kReservedSub);
      if (answer.aborted() && answer.abort_code == number_of(NoSubIndex)) continue;
      findings.fail({pdo.parameters(), kReservedSub},
                    meaning::abort_text(number_of(NoSubIndex)) + ": the entry is reserved", to_text(answer));
    }
  if (tried == 0) context.skip("the node has no PDO");
}

void keeps_its_identifier(Context& context) {
  for (const Pdo& pdo : test_pdos(context)) {
    if (!set_up(context, pdo, {})) return;
    const std::uint64_t cob_id = context.read(pdo.parameters(), kCobIdSub).number();
    context.step();
    const std::uint64_t other = (cob_id & ~std::uint64_t{0x7FF}) | kFree;
    context.expect_abort(context.write_number(pdo.parameters(), kCobIdSub, other),
                         {number_of(InvalidValue), number_of(DeviceState)}, pdo.parameters(), kCobIdSub,
                         "another identifier while it is valid");
  }
}

void takes_another_identifier(Context& context) {
  for (const Pdo& pdo : test_pdos(context)) {
    if (!disable(context, pdo)) return;
    const std::uint64_t keeps = context.read(pdo.parameters(), kCobIdSub).number() & kBit30 &
                                (pdo.direction == PdoDirection::Transmit ? ~0U : 0U);
    for (const std::uint64_t cob_id : {keeps | kInvalid | kFree, keeps | kFree, keeps | kInvalid | kFree}) {
      context.step();
      const SdoAnswer answer = context.write_number(pdo.parameters(), kCobIdSub, cob_id);
      if ((cob_id & kInvalid) == 0 && refused_as_empty(context, pdo, answer)) continue;
      if (!answer.done())
        return context.fail(pdo.parameters(), kCobIdSub, fmt::format("{:X}h can be written", cob_id),
                            to_text(answer));
      const auto now = context.number(pdo.parameters(), kCobIdSub);
      if (now && *now != cob_id)
        context.fail(pdo.parameters(), kCobIdSub, fmt::format("{:08X}h, as written", cob_id),
                     fmt::format("{:08X}h", *now));
    }
  }
}

void uses_its_identifier(Context& context) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  constexpr std::uint16_t kPeriod = 50;
  if (!pdo || !set_up(context, *pdo, {.type = 254, .inhibit_time = 0, .event_timer = kPeriod})) return;
  const std::uint32_t before = identifier_of(context, *pdo);
  if (!disable(context, *pdo)) return;
  const SdoAnswer answer = context.write_number(pdo->parameters(), kCobIdSub, kBit30 | kOtherFree);
  if (!answer.done()) return context.skip("another identifier is refused: " + to_text(answer));
  context.step();
  context.enter(canopen::NmtState::Operational);
  int old = 0, fresh = 0;
  // With the third frame two periods are over in which one under the former identifier would have come.
  (void)context.session().wait_for(
      [&](const canopen::Frame& frame) {
        old += !frame.remote && frame.id == before ? 1 : 0;
        fresh += !frame.remote && frame.id == kOtherFree ? 1 : 0;
        return old == 0 && fresh == 3;
      },
      std::chrono::milliseconds{6 * kPeriod});
  if (fresh == 0 && old == 0) return context.skip("the event timer makes no frame");
  if (old != 0 || fresh == 0)
    context.fail(pdo->parameters(), kCobIdSub, fmt::format("frames under {:03X}h only", kOtherFree),
                 fmt::format("{} under it, {} under {:03X}h", fresh, old, before));
}

void judges_the_frame_bit(Context& context) {
  for (const Pdo& pdo : test_pdos(context)) {
    if (!disable(context, pdo)) return;
    context.step();
    const std::uint64_t cob_id = kFrameBit | 0x1'2345;
    const SdoAnswer answer = context.write_number(pdo.parameters(), kCobIdSub, cob_id);
    if (refused_as_empty(context, pdo, answer)) continue;
    if (!answer.done()) {
      context.expect_abort(answer, {number_of(InvalidValue), number_of(ValueTooHigh)}, pdo.parameters(), kCobIdSub,
                           "an identifier of 29 bits");
      continue;
    }
    const auto now = context.number(pdo.parameters(), kCobIdSub);
    if (now && *now != cob_id)
      context.fail(pdo.parameters(), kCobIdSub, fmt::format("{:08X}h, as accepted, or a refusal", cob_id),
                   fmt::format("{:08X}h", *now));
  }
}

/// Bit 30 may be changed in an invalid TPDO; a device without remote requests may keep it at 1.
void judges_the_request_bit(Context& context) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo || !disable(context, *pdo)) return;
  for (const std::uint64_t bit : {std::uint64_t{kBit30}, std::uint64_t{0}}) {
    const std::uint64_t cob_id = kInvalid | bit | identifier_of(context, *pdo);
    context.step();
    const SdoAnswer answer = context.write_number(pdo->parameters(), kCobIdSub, cob_id);
    if (answer.aborted() && bit == 0) {
      context.note("bit 30 cannot be cleared: " + to_text(answer));
      continue;
    }
    const auto now = answer.done() ? context.number(pdo->parameters(), kCobIdSub) : std::nullopt;
    if (!answer.done() || (now && *now != cob_id))
      context.fail(pdo->parameters(), kCobIdSub, fmt::format("{:08X}h can be written", cob_id),
                   answer.done() ? fmt::format("it reads {:08X}h then", now.value_or(0)) : to_text(answer));
  }
}

/// The bounds of the restricted ranges of CiA 301, table 38.
constexpr std::array<std::uint32_t, 12> kRestricted{0x000, 0x001, 0x07F, 0x101, 0x180, 0x581,
                                                    0x5FF, 0x601, 0x67F, 0x6E0, 0x701, 0x77F};

void refuses_restricted_identifiers(Context& context) {
  FindingLimit findings{context};
  for (const Pdo& pdo : test_pdos(context)) {
    if (!disable(context, pdo)) return;
    const std::uint32_t keeps = pdo.direction == PdoDirection::Transmit ? kBit30 : 0;
    for (const std::uint32_t identifier : kRestricted) {
      context.step();
      const SdoAnswer answer = context.write_number(pdo.parameters(), kCobIdSub, keeps | identifier);
      const bool refused = answer.aborted() && (answer.abort_code == number_of(InvalidValue) ||
                                                answer.abort_code == number_of(ValueTooLow) ||
                                                answer.abort_code == number_of(ValueTooHigh));
      if (!refused && refused_as_empty(context, pdo, answer)) break;
      if (!refused)
        findings.fail({pdo.parameters(), kCobIdSub},
                      fmt::format("{} for the restricted identifier {:03X}h",
                                  meaning::abort_text(number_of(InvalidValue)), identifier),
                      to_text(answer));
      if (answer.done() && !disable(context, pdo)) return;
    }
  }
}

void keeps_to_its_limits(Context& context) {
  bool any = false;
  FindingLimit findings{context};
  for (const Pdo& pdo : test_pdos(context)) {
    const eds::EntryFacts* const facts = context.eds().find(pdo.parameters(), kCobIdSub);
    const auto high =
        facts != nullptr && facts->high ? facts->high->at(context.session().node_id()) : std::nullopt;
    if (!high || high->negative || high->magnitude < kInvalid || high->magnitude >= 0xFFFF'FFFF) continue;
    any = true;
    if (!disable(context, pdo)) return;
    context.step();
    context.expect_abort(context.write_number(pdo.parameters(), kCobIdSub, high->magnitude + 1),
                         {number_of(ValueTooHigh), number_of(InvalidValue)}, pdo.parameters(), kCobIdSub,
                         fmt::format("{:08X}h, above the limit of the EDS", high->magnitude + 1));
  }
  if (!any && !context.skipped()) context.skip("the EDS states no upper limit of a COB-ID with bit 31");
}

constexpr std::array kChecks{
    Check{.id = "pdo.reserved-entry",
          .name = "Sub-index 4 of PDO communication parameters is reserved and does not exist",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .mode = Mode::ReadOnly,
          .run = has_no_reserved_entry},
    Check{.id = "pdo.identifier-lock",
          .name = "The identifier of a valid PDO cannot be changed",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = keeps_its_identifier},
    Check{.id = "pdo.identifier-change",
          .name = "An invalid PDO takes another identifier and becomes valid under it",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = takes_another_identifier},
    Check{.id = "pdo.identifier-in-force",
          .name = "A TPDO comes under the identifier it was given, and no longer under the former one",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = uses_its_identifier},
    Check{.id = "pdo.frame-bit",
          .name = "An identifier of 29 bits is kept as written or refused with 06090030h",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = judges_the_frame_bit},
    Check{.id = "pdo.remote-request-bit",
          .name = "Bit 30 of the COB-ID of a TPDO is kept as written",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = judges_the_request_bit},
    Check{.id = "pdo.restricted-identifiers",
          .name = "Restricted identifiers are refused in COB-IDs of PDOs",
          .clause = "CiA 301 7.3.5",
          .group = Group::Pdo,
          .run = refuses_restricted_identifiers},
    Check{.id = "pdo.cob-id-limits",
          .name = "A COB-ID above the upper limit of the EDS is refused",
          .clause = "CiA 306 4.6.3.2",
          .group = Group::Pdo,
          .run = keeps_to_its_limits},
};

}  // namespace

std::span<const Check> pdo_parameter_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
