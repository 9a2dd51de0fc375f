#pragma once

#include "daemon/control/handler.hpp"
#include "daemon/control/parameters/parameter_name.hpp"

namespace axisd {

/// Writes @p value to the parameter of @p target, whatever its bit, as somebody at the control socket, and tells
/// those who listen to the unit.
Taken<void> write_and_tell(const Call& call, const ParameterTarget& target, double value);

}  // namespace axisd
