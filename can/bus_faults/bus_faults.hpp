#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "can/userbus/path.hpp"

/// The faults of the user-space bus at a path, which must be served (docs/reference/bus-faults.md).
namespace bus_faults {

/// Why something was not done.
struct Refusal {
  bool by_hub = false;  ///< the hub has understood and refused it: what was said is wrong
  std::string text;     ///< one line
};

/// Injects @p fault: an object, or a text of words ("bus.drop id=185 after=10 times=1"); its number.
tl::expected<std::uint32_t, Refusal> inject(const userbus::Path& path, const nlohmann::json& fault);
/// All faults: an array of objects with id, fault, state, events, opportunities, hits and hit_at.
tl::expected<nlohmann::json, Refusal> list(const userbus::Path& path);
/// The kinds that the hub knows: an array of objects with kind, summary, nature, event and arguments.
tl::expected<nlohmann::json, Refusal> kinds(const userbus::Path& path);
/// Takes back fault @p number, or all; how many that were.
tl::expected<std::size_t, Refusal> take_back(const userbus::Path& path, std::optional<std::uint32_t> number);

}  // namespace bus_faults
