#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "can/hub/medium/medium.hpp"

namespace sim {

/// Who is called @p name at the bus, and is known there by the number @p process: faults name their members so.
inline hub::Identity identity_named(std::string_view name, std::int32_t process = 0) noexcept {
  hub::Identity identity{.process = process};
  std::ranges::copy(name.substr(0, identity.name.size() - 1), identity.name.begin());
  return identity;
}

/// By which faults know unit @p number.
constexpr std::int32_t process_of_unit(std::size_t number) noexcept {
  return static_cast<std::int32_t>(number) + 1;
}

}  // namespace sim
