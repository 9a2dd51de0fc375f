#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

#include "tools/axisctl/connection/whole_answer.hpp"

namespace axisctl {

/// A resource of a unit: what stands behind /api/v1/units/BUS/NODE/ in the HTTP API, and how the control socket is
/// asked for the same.
struct Resource {
  /// Whether a path stands for one resource, or for one a drive object; {axis} in the path is then its number.
  enum class Per : std::uint8_t { Unit, Axis, DriveObject };

  std::string_view path;
  std::string_view method;
  Per per = Per::Unit;
  std::string_view key{};  ///< a parameter of the method beside `axis`; empty: none
  std::string_view value{};
};
/// All that a page has of a unit, the most important first.
[[nodiscard]] std::span<const Resource> resources() noexcept;

/// What a unit has answered.
struct Snapshot {
  nlohmann::json resources = nlohmann::json::object();  ///< by path
  std::optional<Failure> cut_off{};                     ///< why the rest was not asked for
};
/// Asks for all resources; long lists are put together. What the unit does not have or refuses is left out; if it
/// answers no more, so is all that follows.
[[nodiscard]] Snapshot take_snapshot(const Ask& ask);

}  // namespace axisctl
