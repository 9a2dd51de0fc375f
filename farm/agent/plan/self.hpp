#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "farm/documents/place.hpp"

namespace farm::agent {

/// Who an agent is.
struct Self {
  std::string host{};
  std::uint64_t instance = 0;  ///< at random, for the life of the process
  std::string version{};
  std::string since{};            ///< when it was started, UTC in the form of ISO 8601
  std::uint32_t capacity = 1;     ///< units that are its fair share
  std::set<std::string> buses{};  ///< whose units it takes; empty: those of all

  /// Whether @p place is its own.
  [[nodiscard]] bool has(const Place& place) const noexcept {
    return place.host == host && place.instance == instance;
  }
};

}  // namespace farm::agent
