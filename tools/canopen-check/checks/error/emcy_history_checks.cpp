#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/told_error.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint32_t kNoData = 0x08000024, kInvalidValue = 0x06090030, kTooHigh = 0x06090031;
constexpr std::uint64_t kCodeBits = 0xFFFF;

void logs_the_newest_first(Context& context) {
  if (!context.need(object::kErrorField) || !context.need(object::kErrorField, 1)) return;
  const ToldError* const told = told_error(context);
  if (told == nullptr) return;
  const std::uint16_t code = code_of(told->message);
  const std::optional<std::uint64_t> newest = context.number_in(told->history.at(1), object::kErrorField, 1);
  if (newest && (*newest & kCodeBits) != code)
    context.fail(object::kErrorField, 1, fmt::format("error code {:04X}h, the newest, in the low word", code),
                 fmt::format("{:08X}h", *newest));
}

void counts_its_entries(Context& context) {
  if (!context.need(object::kErrorField)) return;
  const ToldError* const told = told_error(context);
  if (told == nullptr) return;
  const std::optional<std::uint64_t> count = context.number_in(told->history.at(0), object::kErrorField);
  if (!count) return;
  if (*count == 0) return context.fail(object::kErrorField, 0, "1 or more after an error", "0");
  for (std::size_t sub = 1; sub < told->history.size(); ++sub)
    (void)context.number_in(told->history[sub], object::kErrorField, static_cast<std::uint8_t>(sub));
}

void refuses_empty_entries(Context& context) {
  constexpr int kMostTried = 20;
  if (!context.need(object::kErrorField)) return;
  const std::optional<std::uint64_t> count = context.number(object::kErrorField);
  if (!count) return;
  int tried = 0;
  for (const eds::EntryFacts& entry : context.eds().entries_of(object::kErrorField)) {
    if (entry.sub_index <= *count) continue;
    if (++tried > kMostTried) break;
    context.step();
    context.expect_abort(context.read(object::kErrorField, entry.sub_index), {kNoData}, object::kErrorField,
                         entry.sub_index, "reading it while it is empty");
  }
  if (tried == 0) context.skip("1003h has no empty entry");
}

/// The value is not put back: writing it is the order to delete the history.
SdoAnswer order(Context& context, std::uint8_t value) {
  context.step();
  return context.sdo().download(object::kErrorField, 0, std::array{value});
}

void is_deleted_by_0(Context& context) {
  if (!context.need(object::kErrorField)) return;
  const std::optional<Provoked> provoked = provoke(context, kWays);
  if (!provoked) return;
  end(context, *provoked);
  const SdoAnswer answer = order(context, 0);
  if (!answer.done()) return context.fail(object::kErrorField, 0, "0 can be written", to_text(answer));
  const std::optional<std::uint64_t> count = context.number(object::kErrorField);
  if (count && *count != 0)
    context.fail(object::kErrorField, 0, "0 after 0 was written, which deletes the history",
                 fmt::format("{}", *count));
}

void refuses_other_values(Context& context) {
  constexpr std::uint8_t kOther = 1;
  if (!context.need(object::kErrorField)) return;
  context.expect_abort(order(context, kOther), {kInvalidValue, kTooHigh}, object::kErrorField, 0,
                       "writing 1 to it");
}

void register_agrees(Context& context) {
  constexpr std::uint64_t kGenericError = 1;
  const std::optional<std::uint64_t> now = context.number(object::kErrorRegister);
  if (!now) return;
  if (*now != 0 && (*now & kGenericError) == 0)
    return context.fail(object::kErrorRegister, 0, "bit 0, generic error, while any other bit is set",
                        fmt::format("{:02X}h", *now));
  const bool has_history = context.eds().empty() || context.eds().has(object::kErrorField);
  const SdoAnswer count = has_history ? context.read(object::kErrorField) : SdoAnswer{};
  if (count.done() && count.number() == 0 && *now != 0)
    context.fail(object::kErrorRegister, 0, "00h while 1003h says that there was no error",
                 fmt::format("{:02X}h", *now));
}

constexpr std::array kStateChecks{
    Check{.id = "emcy.register-without-error",
          .name = "The error register is 00h without an error, and has bit 0 set with any",
          .clause = "CiA 301 7.5.2.2",
          .group = Group::Emcy,
          .mode = Mode::ReadOnly,
          .run = register_agrees},
    Check{.id = "emcy.history-empty-entry",
          .name = "Reading an empty entry of the error history is refused",
          .clause = "CiA 301 7.5.2.4",
          .group = Group::Emcy,
          .mode = Mode::ReadOnly,
          .run = refuses_empty_entries},
};

constexpr std::array kChecks{
    Check{.id = "emcy.history-newest",
          .name = "The newest error is at sub-index 1 of the error history, with its code in the low word",
          .clause = "CiA 301 7.5.2.4",
          .group = Group::Emcy,
          .run = logs_the_newest_first},
    Check{.id = "emcy.history-count",
          .name = "Sub-index 0 of the error history counts its entries",
          .clause = "CiA 301 7.5.2.4",
          .group = Group::Emcy,
          .run = counts_its_entries},
    Check{.id = "emcy.history-deleted",
          .name = "Writing 0 to 1003h deletes the error history, for good",
          .clause = "CiA 301 7.5.2.4",
          .group = Group::Emcy,
          .stores = true,
          .run = is_deleted_by_0},
    Check{.id = "emcy.history-other-values",
          .name = "1003h:00 refuses other values than 0",
          .clause = "CiA 301 7.5.2.4",
          .group = Group::Emcy,
          .stores = true,
          .run = refuses_other_values},
};

}  // namespace

std::span<const Check> error_state_checks() noexcept {
  return kStateChecks;
}

std::span<const Check> emcy_history_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
