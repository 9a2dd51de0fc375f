#include <array>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/finding_limit.hpp"

namespace conformance {
namespace {

using enum canopen::AbortCode;

/// What CiA 301 says of a transmission type.
struct TypeRule {
  std::uint8_t first, last;
  bool reserved_for_rpdos, reserved_for_tpdos;
};
constexpr std::array kTypeRules{TypeRule{0, 240, false, false}, TypeRule{241, 251, true, true},
                                TypeRule{252, 253, true, false}, TypeRule{254, 255, false, false}};
constexpr std::array<std::uint8_t, 10> kTypes{0, 1, 2, 240, 241, 251, 252, 253, 254, 255};

bool is_reserved(std::uint8_t type, PdoDirection direction) noexcept {
  for (const TypeRule& rule : kTypeRules)
    if (type >= rule.first && type <= rule.last)
      return direction == PdoDirection::Receive ? rule.reserved_for_rpdos : rule.reserved_for_tpdos;
  return true;
}

void judge_type(Context& context, FindingLimit& findings, const Pdo& pdo, std::uint8_t type) {
  context.step();
  const SdoAnswer answer = context.write_number(pdo.parameters(), kTypeSub, type);
  const bool refused = answer.aborted() && (answer.abort_code == number_of(InvalidValue) ||
                                            answer.abort_code == number_of(ValueTooHigh));
  const Subject subject{pdo.parameters(), kTypeSub};
  if (is_reserved(type, pdo.direction)) {
    if (!refused)
      findings.fail(subject,
                    fmt::format("{} for the reserved type {}", meaning::abort_text(number_of(InvalidValue)), type),
                    to_text(answer));
    return;
  }
  if (!answer.done()) {
    if (!refused)
      findings.fail(subject,
                    fmt::format("type {} is taken, or {}", type, meaning::abort_text(number_of(InvalidValue))),
                    to_text(answer));
    return context.note(fmt::format("{} does not support type {}", pdo.name(), type));
  }
  const auto now = context.number(pdo.parameters(), kTypeSub);
  if (now && *now != type)
    findings.fail(subject, fmt::format("type {}, as accepted", type), fmt::format("type {}", *now));
}

/// True if the EDS says that the transmission type of @p pdo cannot be written, which is noted.
bool has_fixed_type(Context& context, const Pdo& pdo) {
  if (!context.is_fixed(pdo.parameters(), kTypeSub)) return false;
  context.note(fmt::format("the transmission type of {} is fixed", pdo.name()));
  return true;
}

void judges_transmission_types(Context& context) {
  FindingLimit findings{context};
  std::vector<Pdo> pdos = test_pdos(context);
  if (pdos.empty()) return;
  std::erase_if(pdos, [&](const Pdo& pdo) { return has_fixed_type(context, pdo); });
  if (pdos.empty()) return context.skip("the EDS calls no transmission type writable");
  for (const Pdo& pdo : pdos) {
    if (!disable(context, pdo)) return;
    for (const std::uint8_t type : kTypes) judge_type(context, findings, pdo, type);
  }
}

/// True if @p pdo has this parameter; else the check is skipped.
bool need_parameter(Context& context, const Pdo& pdo, std::uint8_t sub_index) {
  if (has_parameter(context, pdo, sub_index)) return true;
  context.skip(fmt::format("object {} is not there", to_text(Subject{pdo.parameters(), sub_index})));
  return false;
}

void locks_the_inhibit_time(Context& context) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo || !need_parameter(context, *pdo, kInhibitSub) || !set_up(context, *pdo, {.type = 255})) return;
  const std::uint64_t before = context.read(pdo->parameters(), kInhibitSub).number();
  context.step();
  context.expect_abort(context.write_number(pdo->parameters(), kInhibitSub, before ^ 0x40U),
                       {number_of(InvalidValue), number_of(DeviceState)}, pdo->parameters(), kInhibitSub,
                       "another inhibit time while the PDO is valid");
}

void takes_an_inhibit_time(Context& context) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo || !need_parameter(context, *pdo, kInhibitSub) || !disable(context, *pdo)) return;
  const std::uint64_t time = context.read(pdo->parameters(), kInhibitSub).number() ^ 0x40U;
  if (!context.set(pdo->parameters(), kInhibitSub, time)) return;
  const auto now = context.number(pdo->parameters(), kInhibitSub);
  if (now && *now != time)
    context.fail(pdo->parameters(), kInhibitSub, fmt::format("{}, as written", time), fmt::format("{}", *now));
}

/// Expects that a value can be written, in Operational.
void write_in_operational(Context& context, std::uint16_t index, std::uint8_t sub_index, std::uint64_t value) {
  context.step();
  const SdoAnswer answer = context.write_number(index, sub_index, value);
  if (!answer.done())
    context.fail(index, sub_index, fmt::format("{:X}h can be written in Operational", value), to_text(answer));
}

void changes_in_operational(Context& context) {
  const std::vector<Pdo> pdos = test_pdos(context);
  context.enter(canopen::NmtState::Operational);
  for (const Pdo& pdo : pdos) {
    const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
    if (!cob_id.done()) return context.skip("the node answers no SDO in Operational");
    write_in_operational(context, pdo.parameters(), kCobIdSub, cob_id.number() | kInvalid);
    if (has_fixed_type(context, pdo)) continue;
    const SdoAnswer type = context.read(pdo.parameters(), kTypeSub);
    write_in_operational(context, pdo.parameters(), kTypeSub, type.number());
  }
}

void maps_in_operational(Context& context) {
  const std::vector<Pdo> pdos = test_pdos(context);
  for (const Pdo& pdo : pdos) {
    if (!disable(context, pdo)) return;
    const SdoAnswer writable = context.write_number(pdo.mapping(), 0, 0);
    if (!writable.done()) return context.skip(fmt::format("the mapping of {} is fixed", pdo.name()));
  }
  context.enter(canopen::NmtState::Operational);
  for (const Pdo& pdo : pdos) write_in_operational(context, pdo.mapping(), 0, 0);
}

/// Makes every PDO of @p direction valid that is not, under identifiers from @p identifier on.
void makes_all_valid(Context& context, PdoDirection direction, std::uint32_t& identifier) {
  FindingLimit findings{context};
  for (const Pdo& pdo : all_pdos(context, direction)) {
    constexpr std::uint32_t kLastFree = 0x6DF;
    const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
    if (!cob_id.done() || (cob_id.number() & kInvalid) == 0 || identifier > kLastFree) continue;
    context.step();
    const std::uint64_t valid = identifier++ | (cob_id.number() & kBit30);
    const SdoAnswer answer = context.write_number(pdo.parameters(), kCobIdSub, valid);
    if (answer.done() || refused_as_empty(context, pdo, answer)) continue;
    if (answer.abort_code == number_of(InternalIncompatibility) ||
        answer.abort_code == number_of(ResourceNotAvailable))
      context.note(fmt::format("no resources for {}: {}", pdo.name(), to_text(answer)));
    else
      findings.fail({pdo.parameters(), kCobIdSub}, fmt::format("{} can be valid beside the others", pdo.name()),
                    to_text(answer));
  }
}

void can_all_be_valid(Context& context) {
  if (test_pdos(context).empty()) return;
  std::uint32_t identifier = 0x681;  // no service of the predefined connection set has those up to 6DFh
  makes_all_valid(context, PdoDirection::Receive, identifier);
  makes_all_valid(context, PdoDirection::Transmit, identifier);
}

constexpr std::array kChecks{
    Check{.id = "pdo.transmission-types",
          .name = "Reserved transmission types are refused with 06090030h, others taken or refused so",
          .clause = "CiA 301 7.5.2.35, 7.5.2.37",
          .group = Group::Pdo,
          .run = judges_transmission_types},
    Check{.id = "pdo.inhibit-time-lock",
          .name = "The inhibit time of a valid TPDO cannot be changed",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = locks_the_inhibit_time},
    Check{.id = "pdo.inhibit-time-change",
          .name = "The inhibit time of an invalid TPDO can be changed",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = takes_an_inhibit_time},
    Check{.id = "pdo.parameters-in-operational",
          .name = "Communication parameters of PDOs can be changed in Operational",
          .clause = "CiA 301 7.5.2.35, 7.5.2.37",
          .group = Group::Pdo,
          .run = changes_in_operational},
    Check{.id = "pdo.mapping-in-operational",
          .name = "The mapping of an invalid PDO can be changed in Operational",
          .clause = "CiA 301 7.5.2.36, 7.5.2.38",
          .group = Group::Pdo,
          .run = maps_in_operational},
    Check{.id = "pdo.all-valid",
          .name = "All PDOs can be valid at once, as far as the resources of the device go",
          .clause = "CiA 301 7.5.2.35, 7.5.2.37",
          .group = Group::Pdo,
          .run = can_all_be_valid},
};

}  // namespace

std::span<const Check> pdo_setting_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
