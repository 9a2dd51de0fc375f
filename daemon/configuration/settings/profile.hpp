#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace axisd {

/// Which device a unit is to its masters.
enum class Profile : std::uint8_t {
  Unit,    ///< the drive unit
  Cia402,  ///< a CiA 402 device
};

/// Their names in configuration, command line and status, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> kProfileNames{"s120", "cia402"};

constexpr std::string_view name_of(Profile profile) noexcept {
  return kProfileNames[static_cast<std::size_t>(profile)];
}

/// The profile called @p name, if there is one.
constexpr std::optional<Profile> profile_named(std::string_view name) noexcept {
  const auto* const found = std::ranges::find(kProfileNames, name);
  if (found == kProfileNames.end()) return std::nullopt;
  return static_cast<Profile>(found - kProfileNames.begin());
}

}  // namespace axisd
