#include "eds/description/dictionary.hpp"

#include <string>
#include <vector>

#include "libcanopen/base/object_index.hpp"

namespace eds {
namespace {

constexpr std::uint8_t kShortestNumber = 8;  // bits; BOOLEAN has fewer

/// @p number as a row of a dictionary holds it.
Value value_of(std::int64_t number, const DataTypeRow& type) {
  return decode(little_endian(static_cast<std::uint64_t>(number), type.bits / 8U), type);
}

/// What the number @p entry begins with.
Value initial_of(const canopen::Dictionary& dictionary, const canopen::Entry& entry, const DataTypeRow& type) {
  if (!canopen::object::is_of_communication(entry.index)) return value_of(dictionary.initial(entry), type);
  return value_of(dictionary.read(entry).value_or(dictionary.initial(entry)), type);
}

EntryFacts facts_of(const canopen::Dictionary& dictionary, const canopen::Entry& entry) {
  const canopen::EntryDescription& row = *entry.description;
  const DataTypeRow* const found = find_data_type(static_cast<std::uint64_t>(row.type));
  EntryFacts facts{.index = row.index,
                   .sub_index = row.sub_index,
                   .name = std::string{row.name},
                   .type = found,
                   .access = row.access,
                   .mappable = row.pdo_mappable};
  if (found == nullptr || found->bits < kShortestNumber) return facts;
  if (row.low) facts.low = value_of(*row.low, *found);
  if (row.high) facts.high = value_of(*row.high, *found);
  facts.initial = initial_of(dictionary, entry, *found);
  return facts;
}

}  // namespace

Description describe(const canopen::Dictionary& dictionary) {
  Description description{dictionary.node_id()};
  for (const canopen::Entry& entry : dictionary.entries()) description.add(facts_of(dictionary, entry));
  return description;
}

}  // namespace eds
