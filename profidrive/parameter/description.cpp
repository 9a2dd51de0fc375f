#include "profidrive/parameter/description.hpp"

#include <algorithm>
#include <string_view>

#include "profidrive/parameter/big_endian.hpp"

namespace profidrive {
namespace {

// Bits of the identifier, beside the format of the values in the lowest ones.
constexpr std::uint32_t kReadOnly = 1U << 9;
constexpr std::uint32_t kIsNotFactory = 1U << 12;
constexpr std::uint32_t kIsArray = 1U << 14;

/// The elements that are filled in, by their sub-indices; the others are 0.
enum Place : std::size_t {
  kIdentifier = 1,
  kIndices,
  kFactor,
  kName = 6,
  kLow,
  kHigh,
  kReference = 11,
  kNormalisation
};

/// 100 % is bit 14, and this is valid.
constexpr std::uint32_t kNormalised = 1U << 15 | 14U;

std::span<std::uint8_t> place_in(Description& description, Place place) noexcept {
  const DescriptionElement& element = kDescriptionElements[place];
  return std::span{description}.subspan(element.offset, element.size);
}

std::uint32_t identifier(const drive::FoundParameter& parameter) noexcept {
  const drive::ParameterRow& row = parameter.row();
  const bool is_modified = row.is_writable() && !parameter.object.is_as_delivered(parameter.placed);
  return static_cast<std::uint32_t>(format_of(row.type)) | (row.is_writable() ? 0 : kReadOnly) |
         (is_modified ? kIsNotFactory : 0) | (row.count > 1 ? kIsArray : 0);
}

/// What a connector is relative to in process data; 0 = nothing.
std::uint16_t reference(const drive::ParameterRow& row) noexcept {
  if (row.output == drive::Output::No || row.type != drive::DataType::F32) return 0;
  return drive::reference_of(drive::row_of(row.unit).quantity);
}

void put_name(std::span<std::uint8_t> place, std::string_view name) noexcept {
  std::ranges::fill(place, std::uint8_t{' '});
  const std::string_view begin = name.substr(0, place.size());
  std::ranges::transform(begin, place.begin(), [](char letter) { return static_cast<std::uint8_t>(letter); });
}

}  // namespace

Description describe(const drive::FoundParameter& parameter) noexcept {
  const drive::ParameterRow& row = parameter.row();
  const drive::Range limits = drive::limits_of(row);
  const std::uint16_t relative_to = reference(row);
  Description description{};
  const auto put = [&](Place place, std::uint32_t number) { put_number(place_in(description, place), number); };
  put(kIdentifier, identifier(parameter));
  put(kIndices, row.count);
  put(kFactor, drive::encode(drive::DataType::F32, 1.0).bits);
  put_name(place_in(description, kName), row.name);
  put(kLow, drive::encode(row.type, limits.minimum).bits);
  put(kHigh, drive::encode(row.type, limits.maximum).bits);
  put(kReference, relative_to);
  put(kNormalisation, relative_to != 0 ? kNormalised : 0);
  return description;
}

}  // namespace profidrive
