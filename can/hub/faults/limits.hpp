#pragma once

#include <optional>

#include "can/hub/medium/medium.hpp"
#include "injection/json/fault_json.hpp"
#include "injection/language/fault.hpp"

namespace hub::faults {

/// What the bus of @p medium cannot do of @p fault, one of injection::bus_kinds(): a bus has no state and sees
/// frames alone, at bit rate 0 frames take no time, and the bit rate of a bus over several hosts is not that of
/// one hub.
std::optional<injection::Problem> find_problem(const injection::Fault& fault, const Medium& medium);

}  // namespace hub::faults
