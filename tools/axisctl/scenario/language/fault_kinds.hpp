#pragma once

#include <span>
#include <string_view>

#include "injection/language/fault.hpp"

namespace scenario {

/// What can be injected: into units and into the bus.
[[nodiscard]] std::span<const injection::Kind> fault_kinds();
/// Whether faults of @p kind are faults of the bus.
[[nodiscard]] bool is_bus_kind(std::string_view kind) noexcept;

}  // namespace scenario
