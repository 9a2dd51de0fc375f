#include "tools/axisctl/runs/fidelity/measured_value.hpp"

#include <algorithm>
#include <array>

#include "libcanopen/base/little_endian.hpp"

namespace runs {
namespace {

constexpr std::uint16_t kFirstParameter = 0x2000, kLastParameter = 0x470F;

double as_number(const eds::Integer& integer) noexcept {
  const auto magnitude = static_cast<double>(integer.magnitude);
  return integer.negative ? -magnitude : magnitude;
}

}  // namespace

double measured_value(const canopen::sdo::Address& object, std::span<const std::uint8_t> bytes,
                      const eds::Description& description) {
  const eds::EntryFacts* const entry = description.find(object.index, object.sub_index);
  if (entry != nullptr && entry->numeric() && entry->bytes() == bytes.size()) {
    const eds::Value value = eds::decode(bytes, *entry->type);
    return value.kind == eds::ValueKind::Real ? value.real : as_number(value.integer);
  }
  std::array<std::uint8_t, 8> padded{};
  std::ranges::copy(bytes.first(std::min(bytes.size(), padded.size())), padded.begin());
  const bool is_parameter = object.index >= kFirstParameter && object.index <= kLastParameter;
  if (is_parameter && bytes.size() == sizeof(float))
    return static_cast<double>(canopen::load<float>(padded.data()));
  const auto bits = canopen::load<std::uint64_t>(padded.data());
  return static_cast<double>(
      canopen::sign_extend(bits, static_cast<unsigned>(std::min<std::size_t>(bytes.size(), 8))));
}

}  // namespace runs
