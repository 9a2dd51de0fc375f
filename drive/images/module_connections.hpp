#pragma once

#include "drive/drive_unit.hpp"
#include "drive/images/saved_values.hpp"

namespace drive {

/// Makes the factory connections of function modules on those axes of @p unit whose parameters @p saved, which it
/// has just taken over, are from a time before the modules. An input that held another source than that of an axis
/// without them stays.
void connect_new_modules(DriveUnit& unit, const SavedValues& saved) noexcept;

}  // namespace drive
