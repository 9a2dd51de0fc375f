#include "device/converters.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "drive/connectors.hpp"
#include "drive/scaling.hpp"

namespace device {
namespace {

constexpr std::uint16_t kFirstBits = 8880;    // BI, a word each
constexpr std::uint16_t kInvertBits = 8888;   // by word
constexpr std::uint16_t kWordsOfBits = 8889;  // CO/BO
constexpr std::uint16_t kFirstWord = 8894;    // CO/BO
constexpr std::uint16_t kSecondWord = 8895;   // CO/BO
constexpr std::uint16_t kInvertWords = 8898;  // by word
constexpr std::uint16_t kWordSources = 8899;  // CI
constexpr std::size_t kBits = 16;
constexpr std::array kConverters{kWordsOfBits, kFirstWord, kSecondWord};

std::uint32_t parameter(const drive::DriveObject& object, std::uint16_t number, std::size_t index) noexcept {
  return static_cast<std::uint32_t>(object.read(number, index).value_or(0.0));
}

/// What an input of a converter is connected to; 0 in place of a converter.
std::uint32_t input(const drive::DriveObject& object, std::uint16_t number, std::size_t index) noexcept {
  const std::uint32_t packed = parameter(object, number, index);
  const bool converter = packed > drive::kHighestConstant &&
                         std::ranges::find(kConverters, drive::unpack(packed).number) != kConverters.end();
  return converter ? 0 : packed;
}

std::uint32_t word_of_bits(const drive::DriveUnit& unit, const drive::DriveObject& object,
                           std::size_t index) noexcept {
  const auto number = static_cast<std::uint16_t>(kFirstBits + index);
  std::uint32_t word = 0;
  for (std::size_t bit = 0; bit < kBits; ++bit)
    word |= (drive::connected_bit(unit, object, input(object, number, bit)) ? 1U : 0U) << bit;
  return word ^ parameter(object, kInvertBits, index);
}

std::uint32_t word(const drive::DriveUnit& unit, const drive::DriveObject& object, std::size_t index) noexcept {
  constexpr double kFull = 0x4000;
  const double value = drive::connected_value(unit, object, input(object, kWordSources, index), kFull);
  const auto bits = static_cast<std::uint32_t>(drive::saturated<std::int32_t>(value));
  return (bits ^ parameter(object, kInvertWords, index)) & 0xFFFFU;
}

}  // namespace

std::optional<double> converter_value(const drive::DriveUnit& unit, const ParameterPlace& place) noexcept {
  switch (place.row.number) {
    case kWordsOfBits:
      return word_of_bits(unit, place.object, place.index);
    case kFirstWord:
    case kSecondWord:
      return word(unit, place.object, place.row.number - kFirstWord);
    default:
      return std::nullopt;
  }
}

}  // namespace device
