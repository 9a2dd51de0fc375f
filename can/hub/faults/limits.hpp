#pragma once

#include <cstdint>
#include <optional>

#include "injection/json/fault_json.hpp"
#include "injection/language/fault.hpp"

namespace hub::faults {

/// What a bus cannot do of @p fault, one of injection::bus_kinds(): a bus has no state and sees frames alone, and
/// at @p bit_rate 0 frames take no time.
std::optional<injection::Problem> find_problem(const injection::Fault& fault, std::uint32_t bit_rate);

}  // namespace hub::faults
