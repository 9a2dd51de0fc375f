#pragma once

#include "libcanopen/sdo/command.hpp"
#include "libcanopen/sdo/sdo_view.hpp"

namespace canopen::sdo {

/// Longest value of an object of the application, in bytes.
inline constexpr std::size_t kLongestViewedValue = 8;

/// An object of the application, as one server shows it (see SdoView).
struct ViewedObject {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint8_t server = 0;

  constexpr Address address() const noexcept { return {index, sub_index}; }
  Result<std::size_t> read(SdoView& view, std::span<std::uint8_t, kLongestViewedValue> value) const noexcept {
    return view.read(server, index, sub_index, value);
  }
  Result<void> write(SdoView& view, std::span<const std::uint8_t> value, bool sized) const noexcept {
    return view.write(server, index, sub_index, value, sized);
  }
};

}  // namespace canopen::sdo
