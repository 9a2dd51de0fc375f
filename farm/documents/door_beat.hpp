#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "farm/naming/unit_name.hpp"

namespace farm {

/// A unit that is reached at a door.
struct DoorUnit {
  UnitName name;
  bool is_on = true;
  std::uint32_t axes = 1;
  std::string profile{};
  std::uint32_t node_id = 0;

  friend bool operator==(const DoorUnit&, const DoorUnit&) = default;
};

/// What the door of a host tells: which units are reached there; in parts if there are many.
struct DoorBeat {
  std::string host{};
  std::uint64_t instance = 0;  ///< tells it from others that use the name of the host
  std::string version{};       ///< of the program
  std::vector<DoorUnit> units{};
  std::uint32_t part = 1;  ///< 1..parts
  std::uint32_t parts = 1;

  friend bool operator==(const DoorBeat&, const DoorBeat&) = default;
};

/// Reads @p text, which came at @p subject; the error is one line.
[[nodiscard]] tl::expected<DoorBeat, std::string> parse_door_beat(std::string_view subject, std::string_view text);
[[nodiscard]] std::string text_of(const DoorBeat& beat);

}  // namespace farm
