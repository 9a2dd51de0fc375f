#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/finding_limit.hpp"

namespace conformance {
namespace {

using enum canopen::AbortCode;

/// CiA 301's code for sub-indices that are locked until sub-index 0 is 0.
constexpr std::uint32_t kLockedBySub0 = 0x06010003;
/// Removed from CiA 301 with version 4: exists nowhere.
constexpr MappedObject kMissing{0x1004, 0, 8};

/// True if @p pdo is invalid and its mapping empty now; else the check is skipped.
bool clear(Context& context, const Pdo& pdo) {
  if (!disable(context, pdo)) return false;
  const SdoAnswer answer = context.write_number(pdo.mapping(), 0, 0);
  if (!answer.done()) context.skip(fmt::format("the mapping of {} is fixed: {}", pdo.name(), to_text(answer)));
  return answer.done();
}

/// The objects that @p pdo can carry.
std::vector<MappedObject> carried(Context& context, const Pdo& pdo) {
  return pdo.direction == PdoDirection::Receive ? receivable(context) : transmittable(context);
}

/// Maps an object into every PDO of test_pdos() that has one; without any the check is skipped.
std::vector<Pdo> mapped_pdos(Context& context) {
  std::vector<Pdo> pdos = test_pdos(context);
  std::erase_if(pdos, [&](const Pdo& pdo) {
    const std::vector<MappedObject> objects = carried(context, pdo);
    return objects.empty() || !clear(context, pdo) || !map_objects(context, pdo, {objects.front()}).done();
  });
  if (!pdos.empty()) {
    context.unskip();
  } else if (!context.skipped()) {
    context.skip("no object is known that a PDO can carry");
  }
  return pdos;
}

void expect_locked(Context& context, const SdoAnswer& answer, std::uint16_t index, std::uint8_t sub_index,
                   const std::string& request) {
  context.expect_abort(
      answer, {number_of(UnsupportedAccess), kLockedBySub0, number_of(NotMappable), number_of(DeviceState)}, index,
      sub_index, request);
}

void locks_entries_behind_sub_0(Context& context) {
  for (const Pdo& pdo : mapped_pdos(context)) {
    // Of the same length: what stands in the entries behind it may count again.
    const std::vector<MappedObject> objects = carried(context, pdo);
    const auto other = std::find_if(objects.begin() + 1, objects.end(), [&](const MappedObject& object) {
      return object.bits == objects.front().bits;
    });
    const MappedObject& object = other == objects.end() ? objects.front() : *other;
    context.step();
    expect_locked(context, context.write_number(pdo.mapping(), 1, object.entry()), pdo.mapping(), 1,
                  "an entry while sub-index 0 is not 0");
  }
}

void locks_the_mapping_of_valid_pdos(Context& context) {
  for (const Pdo& pdo : mapped_pdos(context)) {
    if (!set_up(context, pdo, {})) return;
    context.step();
    expect_locked(context, context.write_number(pdo.mapping(), 0, 0), pdo.mapping(), 0,
                  "0 while the PDO is valid");
  }
}

void refuses_more_than_64_bits(Context& context) {
  constexpr std::size_t kMostBits = 64;
  int tried = 0;
  for (const Pdo& pdo : mapped_pdos(context)) {
    std::vector<MappedObject> objects = carried(context, pdo);
    const MappedObject longest = *std::ranges::max_element(objects, {}, &MappedObject::bits);
    const std::size_t needed = kMostBits / longest.bits + 1, bits = needed * longest.bits;
    std::erase_if(objects, [&](const MappedObject& object) { return object.bits != longest.bits; });
    objects.resize(needed, longest);
    const bool room = context.eds().find(pdo.mapping(), static_cast<std::uint8_t>(needed)) != nullptr;
    if (!room || !clear(context, pdo)) continue;
    ++tried;
    context.step();
    context.expect_abort(map_objects(context, pdo, objects),
                         {number_of(PdoLengthExceeded), number_of(NotMappable), number_of(NoObject)},
                         pdo.mapping(), 0, fmt::format("{} bits", bits));
  }
  if (tried == 0 && !context.skipped()) context.skip("the entries of the mapping cannot hold more than 64 bits");
}

void refuses_too_many_entries(Context& context) {
  int tried = 0;
  for (const Pdo& pdo : mapped_pdos(context)) {
    const auto entries = context.eds().entries_of(pdo.mapping());
    constexpr std::uint8_t kMostEntries = 0x40;
    if (entries.empty() || entries.back().sub_index > kMostEntries || !clear(context, pdo)) continue;
    ++tried;
    const unsigned count = entries.back().sub_index + 1U;
    context.step();
    context.expect_abort(
        context.write_number(pdo.mapping(), 0, count),
        {number_of(PdoLengthExceeded), number_of(InvalidValue), number_of(ValueTooHigh), number_of(NotMappable)},
        pdo.mapping(), 0, fmt::format("{} entries, one more than there are", count));
  }
  if (tried == 0 && !context.skipped()) context.skip("the EDS has no mapping with fewer than 65 entries");
}

/// Expects that @p object is not taken into @p pdo, with @p entry or with sub-index 0.
void expect_refused(Context& context, const Pdo& pdo, const MappedObject& object,
                    std::initializer_list<std::uint32_t> codes, const std::string& what) {
  if (!clear(context, pdo)) return;
  context.step();
  context.expect_abort(map_objects(context, pdo, {object}), codes, pdo.mapping(), 1,
                       fmt::format("{:08X}h, {}", object.entry(), what));
}

void refuses_missing_objects(Context& context) {
  for (const Pdo& pdo : test_pdos(context))
    expect_refused(context, pdo, kMissing, {number_of(NoObject), number_of(NotMappable)},
                   "an object that does not exist");
}

void refuses_unmappable_objects(Context& context) {
  const auto entries = context.eds().entries();
  const auto entry = std::ranges::find_if(entries, [](const eds::EntryFacts& each) {
    return !each.mappable && each.numeric() && each.bytes() <= 4 && each.type->bits % 8 == 0 &&
           each.access == canopen::Access::ReadWrite;
  });
  if (entry == entries.end()) return context.skip("the EDS has no rw object that is not mappable");
  const MappedObject object{entry->index, entry->sub_index, static_cast<std::uint8_t>(entry->type->bits)};
  for (const Pdo& pdo : test_pdos(context))
    expect_refused(context, pdo, object, {number_of(NotMappable), number_of(NoObject)},
                   "an object that is not mappable");
}

/// A mappable object that cannot go the way of @p pdo.
std::optional<MappedObject> of_other_direction(Context& context, const Pdo& pdo) {
  const bool receive = pdo.direction == PdoDirection::Receive;
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    if (!entry.mappable || !entry.numeric()) continue;
    const bool wrong =
        receive ? entry.access == canopen::Access::ReadOnly || entry.access == canopen::Access::ReadWriteRead
                : entry.access == canopen::Access::WriteOnly || entry.access == canopen::Access::ReadWriteWrite;
    if (wrong) return MappedObject{entry.index, entry.sub_index, static_cast<std::uint8_t>(entry.type->bits)};
  }
  return std::nullopt;
}

void refuses_the_wrong_direction(Context& context) {
  int tried = 0;
  for (const Pdo& pdo : test_pdos(context))
    if (const auto object = of_other_direction(context, pdo)) {
      ++tried;
      expect_refused(context, pdo, *object, {number_of(NotMappable), number_of(NoObject)},
                     "an object that goes the other way");
    }
  if (tried == 0 && !context.skipped()) context.skip("the EDS has no object that can be mapped one way only");
}

void refuses_wrong_lengths(Context& context) {
  for (const Pdo& pdo : mapped_pdos(context)) {
    MappedObject object = carried(context, pdo).front();
    object.bits = object.bits == 8 ? 16 : 8;
    expect_refused(context, pdo, object,
                   {number_of(NotMappable), number_of(InvalidValue), number_of(PdoLengthExceeded)},
                   "an object with a wrong length");
  }
}

/// Data type and length of the dummy objects that fill whole bytes.
constexpr std::array<MappedObject, 6> kDummies{MappedObject{2, 0, 8},  MappedObject{3, 0, 16},
                                               MappedObject{4, 0, 32}, MappedObject{5, 0, 8},
                                               MappedObject{6, 0, 16}, MappedObject{7, 0, 32}};

void keeps_to_its_dummies(Context& context) {
  if (context.eds().empty()) return context.skip("without an EDS the dummy objects are not known");
  FindingLimit findings{context};
  for (const Pdo& pdo : test_pdos(context))
    for (const MappedObject& dummy : kDummies) {
      const bool allowed = pdo.direction == PdoDirection::Receive &&
                           (unsigned{context.eds().device().dummy_types} >> dummy.index & 1U) != 0;
      if (!allowed) {
        expect_refused(context, pdo, dummy, {number_of(NotMappable), number_of(NoObject)}, "a dummy object");
        continue;
      }
      if (!clear(context, pdo)) return;
      context.step();
      if (const SdoAnswer answer = map_objects(context, pdo, {dummy}); !answer.done())
        findings.fail({pdo.mapping(), std::uint8_t{1}},
                      fmt::format("the dummy object {:04X}h can be mapped, as DummyUsage says", dummy.index),
                      to_text(answer));
    }
}

void stays_empty_after_a_refusal(Context& context) {
  for (const Pdo& pdo : test_pdos(context)) {
    if (!clear(context, pdo)) return;
    context.step();
    const std::size_t mark = context.session().mark();
    if (map_objects(context, pdo, {kMissing}).done()) return context.skip("the mapping is not refused");
    const auto count = context.number(pdo.mapping(), 0);
    if (count && *count != 0)
      context.fail(pdo.mapping(), 0, "0 after a mapping that was refused", fmt::format("{}", *count));
    context.session().pass(std::chrono::milliseconds{20});
    if (!frames_since(context, mark, context.session().identifier(0x80)).empty())
      context.note(pdo.name() + ": an emergency message tells of the refused mapping");
  }
}

constexpr auto row(std::string_view id, std::string_view name, void (*run)(Context&)) {
  return Check{.id = id, .name = name, .clause = "CiA 301 7.5.2.36, 7.5.2.38", .group = Group::Pdo, .run = run};
}

constexpr std::array kChecks{
    row("pdo.mapping-entry-lock", "Entries of a mapping can be written while its sub-index 0 is 0 only",
        locks_entries_behind_sub_0),
    row("pdo.mapping-valid-lock", "The mapping of a valid PDO cannot be changed", locks_the_mapping_of_valid_pdos),
    row("pdo.mapping-length", "A mapping of more than 64 bits is refused", refuses_more_than_64_bits),
    row("pdo.mapping-count", "More entries than the mapping has are refused", refuses_too_many_entries),
    row("pdo.mapping-missing-object", "An object that does not exist is refused", refuses_missing_objects),
    row("pdo.mapping-unmappable", "An object that is not mappable is refused", refuses_unmappable_objects),
    row("pdo.mapping-direction", "An object that goes the other way is refused", refuses_the_wrong_direction),
    row("pdo.mapping-bits", "An object with a wrong length is refused", refuses_wrong_lengths),
    row("pdo.mapping-dummy", "Dummy objects can be mapped as DummyUsage says, into RPDOs", keeps_to_its_dummies),
    row("pdo.mapping-refused", "A refused mapping is empty", stays_empty_after_a_refusal),
};

}  // namespace

std::span<const Check> pdo_mapping_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
