#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/access/parameter_access.hpp"
#include "profidrive/parameter/format.hpp"

namespace profidrive {

/// The description of a parameter: its elements one behind the other.
using Description = std::array<std::uint8_t, 46>;

/// An element of a description: where it lies, and how it is transferred by itself.
struct DescriptionElement {
  std::uint8_t offset;
  std::uint8_t size;  ///< bytes
  Format format;
};

/// By their sub-indices; 0 is the whole.
inline constexpr std::array kDescriptionElements{
    DescriptionElement{0, 46, Format::Byte},         DescriptionElement{0, 2, Format::Word},  // identifier
    DescriptionElement{2, 2, Format::Unsigned16},                                             // number of indices
    DescriptionElement{4, 4, Format::FloatingPoint},                                          // factor
    DescriptionElement{8, 2, Format::Byte},                                                   // variable attribute
    DescriptionElement{10, 4, Format::Byte},                                                  // reserved
    DescriptionElement{14, 16, Format::Byte},                                                 // name
    DescriptionElement{30, 4, Format::DoubleWord},                                            // low limit
    DescriptionElement{34, 4, Format::DoubleWord},                                            // high limit
    DescriptionElement{38, 2, Format::Byte},                                                  // reserved
    DescriptionElement{40, 2, Format::Word},        // extension of the identifier
    DescriptionElement{42, 2, Format::Unsigned16},  // reference parameter
    DescriptionElement{44, 2, Format::Word},        // normalisation
};

/// The description of @p parameter, whatever its index.
Description describe(const drive::FoundParameter& parameter) noexcept;

/// The bytes of @p element of @p description.
constexpr std::span<const std::uint8_t> part_of(const Description& description,
                                                const DescriptionElement& element) noexcept {
  return std::span{description}.subspan(element.offset, element.size);
}

}  // namespace profidrive
