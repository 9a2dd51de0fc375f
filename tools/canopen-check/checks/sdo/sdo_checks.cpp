#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/sheet/object_lists.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

constexpr int kMostSilent = 3;

/// Calls @p judge for every entry of the EDS that @p concerns, until the session has ended or @p judge says that
/// the node was silent too often.
template <class Concerns, class Judge>
void for_each_entry(Context& context, Concerns concerns, Judge judge) {
  if (context.eds().empty()) return context.skip("there is no EDS");
  int asked = 0, silent = 0;
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    if (context.session().ended() || silent == kMostSilent) break;
    if (!concerns(entry)) continue;
    ++asked;
    context.session().forget();
    context.step();
    silent = judge(entry) == SdoAnswer::Kind::Silent ? silent + 1 : 0;
  }
  if (asked == 0) return context.skip("the EDS has no such entry");
  context.note(fmt::format("{} entries", asked));
}

void refuses_to_write_constants(Context& context) {
  for_each_entry(
      context,
      [&](const eds::EntryFacts& entry) {
        return !entry.writable() && entry.numeric() && !entry.no_read &&
               write_refusal(entry, context.settings()) == nullptr;
      },
      [&](const eds::EntryFacts& entry) {
        const SdoAnswer value = context.undo().keep(entry.index, entry.sub_index);
        if (!value.done()) return value.kind;
        const SdoAnswer answer = context.sdo().download(entry.index, entry.sub_index, value.data);
        context.expect_abort(answer, {number_of(AbortCode::ReadOnly), number_of(AbortCode::UnsupportedAccess)},
                             entry.index, entry.sub_index, "writing it");
        return answer.kind;
      });
}

void refuses_to_read_write_only(Context& context) {
  for_each_entry(
      context, [](const eds::EntryFacts& entry) { return !entry.readable() && !entry.no_read; },
      [&](const eds::EntryFacts& entry) {
        const SdoAnswer answer = context.read(entry.index, entry.sub_index);
        context.expect_abort(answer, {number_of(AbortCode::WriteOnly), number_of(AbortCode::UnsupportedAccess)},
                             entry.index, entry.sub_index, "reading it");
        return answer.kind;
      });
}

void refuses_absent_sub_indices(Context& context) {
  context.expect_abort(context.read(object::kDeviceType, 1), {number_of(AbortCode::NoSubIndex)},
                       object::kDeviceType, 1, "reading it");
}

void refuses_absent_objects(Context& context) {
  // CiA 301 reserves 1004h.
  context.expect_abort(context.read(object::kReserved), {number_of(AbortCode::NoObject)}, object::kReserved, 0,
                       "reading it");
}

void refuses_unknown_commands(Context& context) {
  constexpr std::array<std::uint8_t, 3> kUnknown{0xE0, 0xE3, 0xFF};  // client command specifier 7 is not assigned
  for (const std::uint8_t command : kUnknown) {
    context.step();
    context.expect_abort(ask(context, context.sdo().request(command, object::kDeviceType)),
                         {number_of(AbortCode::CommandSpecifierInvalid)}, object::kDeviceType, 0,
                         fmt::format("a request that begins with {:02X}h", command));
  }
}

/// Writes numbers of one, two and four bytes in a length that is @p difference bytes off.
void expect_length_abort(Context& context, int difference, AbortCode code) {
  bool any = false;
  for (const int bytes : {1, 2, 4}) {
    const int wrong = bytes + difference;
    if (wrong < 1 || wrong > 4) continue;
    const std::optional<Target> target = writable_number(context, static_cast<std::size_t>(bytes));
    if (!target) continue;
    any = true;
    std::vector<std::uint8_t> value = target->value;
    value.resize(static_cast<std::size_t>(wrong));
    context.step();
    context.expect_abort(context.write(target->index, target->sub_index, value),
                         {number_of(AbortCode::LengthMismatch), number_of(code)}, target->index, target->sub_index,
                         fmt::format("{} bytes of data instead of {}", wrong, bytes));
  }
  if (!any) context.skip("no number that may be written");
}

void refuses_too_much(Context& context) {
  expect_length_abort(context, 1, AbortCode::LengthTooHigh);
}

void refuses_too_little(Context& context) {
  expect_length_abort(context, -1, AbortCode::LengthTooLow);
}

/// The value next to @p limit, above it or below; nothing where the type has none.
std::optional<eds::Value> beyond(const eds::Value& limit, const eds::EntryFacts& entry, bool above) {
  if (limit.kind != eds::ValueKind::Signed && limit.kind != eds::ValueKind::Unsigned) return std::nullopt;
  eds::Value value = limit;
  eds::Integer& integer = value.integer;
  // Of signed types the number is between -2^(n-1) and 2^(n-1) - 1, of unsigned ones between 0 and 2^n - 1.
  const bool sign = limit.kind == eds::ValueKind::Signed;
  const std::uint64_t highest = (~std::uint64_t{0} >> (64U - entry.type->bits)) >> (sign ? 1U : 0U);
  const bool away_from_zero = integer.negative != above || integer.magnitude == 0;
  if (above && !integer.negative && integer.magnitude >= highest) return std::nullopt;
  if (!above && !sign && integer.magnitude == 0) return std::nullopt;
  if (!above && integer.negative && integer.magnitude >= highest + 1) return std::nullopt;
  integer.magnitude += away_from_zero ? 1 : std::uint64_t{0} - 1;
  if (integer.magnitude == 0) integer.negative = false;
  if (!above && limit.integer.magnitude == 0) integer.negative = true;
  return value;
}

/// Writes the number next to each limit. COB-IDs and PDO parameters have limits of their own (pdo checks).
void expect_limit_abort(Context& context, bool above) {
  const AbortCode code = above ? AbortCode::ValueTooHigh : AbortCode::ValueTooLow;
  const auto limit = [above](const eds::EntryFacts& entry) { return above ? entry.high : entry.low; };
  for_each_entry(
      context,
      [&](const eds::EntryFacts& entry) {
        return entry.writable() && entry.numeric() && limit(entry) && beyond(*limit(entry), entry, above) &&
               eds::find_cob_id(entry.index, entry.sub_index) == nullptr &&
               (entry.index < object::kRpdoParameter || entry.index >= object::kPdosEnd) &&
               write_refusal(entry, context.settings()) == nullptr;
      },
      [&](const eds::EntryFacts& entry) {
        const auto value = encode(*beyond(*limit(entry), entry, above), *entry.type, context.eds().node_id());
        if (!value) return SdoAnswer::Kind::Done;
        const SdoAnswer answer = context.write(entry.index, entry.sub_index, *value);
        context.expect_abort(
            answer, {number_of(code), number_of(AbortCode::InvalidValue)}, entry.index, entry.sub_index,
            fmt::format("{}, which is {}", hexadecimal(*value), above ? "above HighLimit" : "below LowLimit"));
        return answer.kind;
      });
}

void refuses_above_high_limits(Context& context) {
  expect_limit_abort(context, true);
}

void refuses_below_low_limits(Context& context) {
  expect_limit_abort(context, false);
}

void has_its_own_identifiers(Context& context) {
  if (!context.need(object::kSdoServer, 1)) return;
  const std::array wanted{context.sdo().request_identifier(), context.sdo().response_identifier()};
  for (std::uint8_t sub = 1; sub <= 2; ++sub) {
    const std::optional<std::uint64_t> value = context.number(object::kSdoServer, sub);
    if (value && *value != wanted[sub - 1U])
      context.fail(object::kSdoServer, sub, fmt::format("{:08X}h", wanted[sub - 1U]),
                   fmt::format("{:08X}h", *value));
    const eds::EntryFacts* const facts = context.eds().find(object::kSdoServer, sub);
    if (facts != nullptr && facts->writable())
      context.fail(object::kSdoServer, sub, "an EDS that calls it ro or const", "one that calls it writable");
  }
}

constexpr std::array kChecks{
    Check{.id = "sdo.server-1",
          .name = "1200h has 600h and 580h plus the node-ID, which cannot be written",
          .clause = "CiA 301 7.5.2.33",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = has_its_own_identifiers},
    Check{.id = "sdo.absent-object",
          .name = "An object that does not exist is refused with 06020000h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_absent_objects},
    Check{.id = "sdo.absent-sub-index",
          .name = "A sub-index that does not exist is refused with 06090011h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_absent_sub_indices},
    Check{.id = "sdo.command-specifier",
          .name = "An unknown command specifier is refused with 05040001h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_unknown_commands},
    Check{.id = "sdo.write-only",
          .name = "Reading an object that is write only is refused with 06010001h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_to_read_write_only},
    Check{.id = "sdo.read-only",
          .name = "Writing an object that is read only is refused with 06010002h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_to_write_constants},
    Check{.id = "sdo.too-long",
          .name = "Data that are too long are refused with 06070012h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_too_much},
    Check{.id = "sdo.too-short",
          .name = "Data that are too short are refused with 06070013h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_too_little},
    Check{.id = "sdo.high-limit",
          .name = "A value above the high limit of the EDS is refused with 06090031h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_above_high_limits},
    Check{.id = "sdo.low-limit",
          .name = "A value below the low limit of the EDS is refused with 06090032h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_below_low_limits},
};

}  // namespace

std::span<const Check> sdo_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
