#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "injection/wire/actions.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/object_index.hpp"

namespace injection::actions {
namespace {

/// Values as a PDO carries them, one behind the other.
struct Values {
  struct Value {
    std::uint64_t bits;
    unsigned size;
  };
  std::array<Value, 64> items{};
  std::size_t count = 0;
};

constexpr unsigned kPayload = 64;

constexpr std::uint64_t mask_of(unsigned size) noexcept {
  return size >= kPayload ? ~std::uint64_t{0} : (std::uint64_t{1} << size) - 1;
}

Values values_in(const canopen::Frame& frame, const canopen::Dictionary& dictionary,
                 std::uint16_t mapping) noexcept {
  constexpr std::uint32_t kSize = 0xFF;  // the lowest byte of a mapping entry
  Values values;
  unsigned from = 0;
  const auto payload = canopen::load<std::uint64_t>(frame.data.data());
  const auto count = static_cast<std::size_t>(dictionary.stored(mapping, 0).value_or(0));
  while (values.count < std::min(count, values.items.size()) && from < kPayload) {
    const auto entry = dictionary.stored(mapping, static_cast<std::uint8_t>(values.count + 1)).value_or(0);
    const unsigned size = static_cast<std::uint32_t>(entry) & kSize;
    values.items[values.count++] = {payload >> from & mask_of(size), size};
    from += size;
  }
  return values;
}

std::uint64_t payload_of(const Values& values) noexcept {
  std::uint64_t payload = 0;
  unsigned from = 0;
  for (std::size_t i = 0; i < values.count && from < kPayload; from += values.items[i++].size)
    payload |= values.items[i].bits << from;
  return payload;
}

}  // namespace

/// Values of different sizes move those between them.
void swap_values(Passing& passing, Loaded& loaded, const device::Device& device) noexcept {
  const auto mapping = static_cast<std::uint16_t>(canopen::object::kTpdoMapping + passing.role.number - 1);
  Values values = values_in(passing.frame, device.dictionary(), mapping);
  const std::size_t first = loaded.value(Argument::First).value_or(1) - 1;
  const std::size_t second = loaded.value(Argument::Second).value_or(2) - 1;
  if (std::max(first, second) >= values.count) return;
  std::swap(values.items[first], values.items[second]);
  canopen::store(passing.frame.data.data(), payload_of(values));
}

}  // namespace injection::actions
