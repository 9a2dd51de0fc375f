#pragma once

#include <cstddef>

namespace drive {
class DriveObject;
}

/// What parameters show and do of any drive object.
namespace drive::object_value {

/// A command reads as 0.
double no_value(const DriveObject& object, std::size_t index) noexcept;
/// r2902 (%).
double fixed_value(const DriveObject& object, std::size_t index) noexcept;
/// p3981: 1 acknowledges the faults.
void acknowledge(DriveObject& object, std::size_t index, double value) noexcept;

}  // namespace drive::object_value
