#include "libcanopen/pdo/mapping.hpp"

namespace canopen {
namespace {

/// The entry that a mapping word names, if it may be mapped that way.
Result<const Entry*> mapped_entry(const Dictionary& dictionary, std::uint32_t mapped,
                                  Direction direction) noexcept {
  const auto entry =
      dictionary.find(static_cast<std::uint16_t>(mapped >> 16), static_cast<std::uint8_t>(mapped >> 8));
  if (!entry) return entry;
  const bool allowed = direction == Direction::Receive ? (*entry)->receive_mappable : (*entry)->transmit_mappable;
  if (!allowed || (mapped & 0xFF) != 8U * (*entry)->size) return refuse(AbortCode::NotMappable);
  return entry;
}

}  // namespace

bool MappingPlan::append(std::uint32_t offset, std::uint8_t size) noexcept {
  if (length_ + size > 8) return false;
  values_[count_++] = Value{
      .mask = byte_mask(size), .offset = offset, .size = size, .shift = static_cast<std::uint8_t>(8 * length_)};
  length_ = static_cast<std::uint8_t>(length_ + size);
  return true;
}

Result<void> check_mapping_entry(const Dictionary& dictionary, std::uint32_t mapped,
                                 Direction direction) noexcept {
  if (mapped == 0) return {};
  return mapped_entry(dictionary, mapped, direction).map([](const Entry*) {});
}

Result<MappingPlan> compile_mapping(const Dictionary& dictionary, std::uint16_t index, std::uint8_t count,
                                    Direction direction) noexcept {
  MappingPlan plan;
  for (std::uint8_t sub = 1; sub <= count; ++sub) {
    const auto row = dictionary.find(index, sub);
    if (!row) return refuse(AbortCode::PdoLengthExceeded);
    const auto mapped = static_cast<std::uint32_t>(dictionary.stored(**row));
    if (mapped == 0) return refuse(AbortCode::NotMappable);
    const auto entry = mapped_entry(dictionary, mapped, direction);
    if (!entry) return refuse(entry.error());
    if (!plan.append((*entry)->offset, (*entry)->size)) return refuse(AbortCode::PdoLengthExceeded);
  }
  return plan;
}

}  // namespace canopen
