#pragma once

#include <cstdint>

namespace drive {

/// The source of a BICO input: a parameter of a drive object with an index (connector) or a bit (binector).
struct BicoSource {
  std::uint16_t number;
  std::uint8_t object;     ///< drive object number, kOwnObject = the one that has the input
  std::uint16_t position;  ///< index of a connector or bit of a binector, 0..1023

  friend bool operator==(const BicoSource&, const BicoSource&) = default;
};

/// Stands for the drive object that has the input.
inline constexpr std::uint8_t kOwnObject = 63;

/// The two sources that are no parameter: the constants 0 and 1 (of a connector 100 %).
inline constexpr std::uint32_t kHighestConstant = 1;

/// @p source as a BICO input holds it: number in bits 16..31, drive object in 10..15, position in 0..9.
constexpr std::uint32_t pack(const BicoSource& source) noexcept {
  return std::uint32_t{source.number} << 16 | (source.object & 0x3FU) << 10 | (source.position & 0x3FFU);
}

/// The source that the value @p packed of a BICO input stands for; it is above kHighestConstant.
constexpr BicoSource unpack(std::uint32_t packed) noexcept {
  return {static_cast<std::uint16_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 10 & 0x3FU),
          static_cast<std::uint16_t>(packed & 0x3FFU)};
}

/// The value of an input that is connected to @p number of its own drive object.
constexpr double own_source(std::uint16_t number, std::uint16_t position) noexcept {
  return static_cast<double>(pack({number, kOwnObject, position}));
}

}  // namespace drive
