#include "audit/network/known_values.hpp"

#include "libcanopen/base/object_index.hpp"

namespace audit {

namespace {

constexpr std::uint32_t key_of(std::uint16_t index, std::uint8_t sub_index) noexcept {
  return std::uint32_t{index} << 8 | sub_index;
}

constexpr bool is_of_communication(std::uint32_t key) noexcept {
  return canopen::object::is_of_communication(static_cast<std::uint16_t>(key >> 8));
}

}  // namespace

void KnownValues::learn(const canopen::sdo::Address& at, std::uint64_t value) {
  const std::uint32_t key = key_of(at.index, at.sub_index);
  if (values_.size() < kMostValues || values_.contains(key)) values_[key] = value;
}

std::optional<std::uint64_t> KnownValues::find(std::uint16_t index, std::uint8_t sub_index) const noexcept {
  const auto found = values_.find(key_of(index, sub_index));
  return found == values_.end() ? std::nullopt : std::optional{found->second};
}

void KnownValues::forget_saved(std::uint8_t sub_index) {
  constexpr std::uint8_t kAll = 1, kCommunication = 2;  // CiA 301, 7.5.2.14
  std::erase_if(saved_, [sub_index](const auto& item) {
    return sub_index == kAll || is_of_communication(item.first) == (sub_index == kCommunication);
  });
}

void KnownValues::reset(bool communication_only) {
  const auto is_reset = [communication_only](const auto& item) {
    return !communication_only || is_of_communication(item.first);
  };
  std::erase_if(values_, is_reset);
  for (const auto& item : saved_)
    if (is_reset(item) && values_.size() < kMostValues) values_.insert(item);
}

}  // namespace audit
