#include "libcanopen/pdo/mapping.hpp"

namespace canopen {
namespace {

constexpr std::uint8_t kPayloadBits = 64;

/// A mapping entry taken apart.
struct MappingWord {
  explicit constexpr MappingWord(std::uint32_t word) noexcept
      : index{static_cast<std::uint16_t>(word >> 16)},
        sub_index{static_cast<std::uint8_t>(word >> 8)},
        bits{static_cast<std::uint8_t>(word)} {}

  std::uint16_t index;
  std::uint8_t sub_index;
  std::uint8_t bits;
};

constexpr std::uint64_t bit_mask(std::uint8_t bits) noexcept {
  return ~std::uint64_t{0} >> (kPayloadBits - bits);
}
static_assert(bit_mask(1) == 1 && bit_mask(24) == 0xFFFFFF && bit_mask(64) == UINT64_MAX);

constexpr std::uint8_t bits_of(DataType type) noexcept {
  return type == DataType::Boolean ? std::uint8_t{1} : static_cast<std::uint8_t>(8 * size_of(type));
}

bool is_dummy(const MappingRules& rules, MappingWord word) noexcept {
  constexpr auto kLastDummy = static_cast<std::uint16_t>(DataType::Unsigned32);
  return word.index != 0 && word.index <= kLastDummy && (rules.dummy_types >> word.index & 1) != 0;
}

Result<const Entry*> mapped_dummy(const MappingRules& rules, MappingWord word) noexcept {
  if (word.sub_index != 0) return refuse(AbortCode::NoSubIndex);
  const bool fits = rules.direction == Direction::Receive && word.bits == bits_of(DataType{word.index});
  if (!fits) return refuse(AbortCode::NotMappable);
  return nullptr;
}

/// The entry that a mapping word names, if it may be mapped that way; nullptr for a dummy object.
Result<const Entry*> mapped_entry(const MappingRules& rules, MappingWord word) noexcept {
  if (is_dummy(rules, word)) return mapped_dummy(rules, word);
  const auto entry = rules.dictionary.find(word.index, word.sub_index);
  if (!entry) return entry;
  const bool allowed =
      rules.direction == Direction::Receive ? (*entry)->receive_mappable : (*entry)->transmit_mappable;
  if (!allowed || word.bits != (*entry)->bits) return refuse(AbortCode::NotMappable);
  return entry;
}

}  // namespace

bool MappingPlan::append(std::uint32_t offset, std::uint8_t bits) noexcept {
  const std::uint8_t shift = bits_;
  if (count_ == room_ || !skip(bits)) return false;
  values_[count_++] = {.mask = bit_mask(bits), .offset = offset, .shift = shift};
  return true;
}

bool MappingPlan::skip(std::uint8_t bits) noexcept {
  if (bits_ + bits > kPayloadBits) return false;
  bits_ = static_cast<std::uint8_t>(bits_ + bits);
  length_ = static_cast<std::uint8_t>((bits_ + 7) / 8);
  return true;
}

Result<void> check_mapping_entry(const MappingRules& rules, std::uint32_t mapped) noexcept {
  if (mapped == 0) return {};
  return mapped_entry(rules, MappingWord{mapped}).map([](const Entry*) {});
}

Result<void> compile_mapping(const MappingRules& rules, std::uint16_t index, std::uint8_t count,
                             MappingPlan& plan) noexcept {
  plan.clear();
  for (unsigned sub = 1; sub <= count; ++sub) {
    const auto row = rules.dictionary.find(index, static_cast<std::uint8_t>(sub));
    if (!row) return refuse(AbortCode::PdoLengthExceeded);
    const auto mapped = static_cast<std::uint32_t>(rules.dictionary.stored(**row));
    if (mapped == 0) return refuse(AbortCode::NotMappable);
    const MappingWord word{mapped};
    const auto entry = mapped_entry(rules, word);
    if (!entry) return refuse(entry.error());
    const bool fits = *entry != nullptr ? plan.append((*entry)->offset, word.bits) : plan.skip(word.bits);
    if (!fits) return refuse(AbortCode::PdoLengthExceeded);
  }
  return {};
}

}  // namespace canopen
