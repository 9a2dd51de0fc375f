#pragma once

#include <cstddef>

namespace drive {
class ControlUnit;
}

/// What parameters show and set of the clock of the unit; times are ms of the day at even indices, days at odd
/// ones.
namespace drive::clock_value {

/// r2114.
double runtime(const ControlUnit& unit, std::size_t index) noexcept;
/// p3100.
double mode(const ControlUnit& unit, std::size_t index) noexcept;
void set_mode(ControlUnit& unit, std::size_t index, double value) noexcept;
/// p3101: as last written; index 0 sets the clock.
double given(const ControlUnit& unit, std::size_t index) noexcept;
void set_given(ControlUnit& unit, std::size_t index, double value) noexcept;
/// r3102; 0 without UTC.
double utc(const ControlUnit& unit, std::size_t index) noexcept;
/// p3103.
double method(const ControlUnit& unit, std::size_t index) noexcept;
void set_method(ControlUnit& unit, std::size_t index, double value) noexcept;
/// r3107: before and after.
double violation(const ControlUnit& unit, std::size_t index) noexcept;
/// r3108: last correction, last violation (ms).
double deviation(const ControlUnit& unit, std::size_t index) noexcept;

}  // namespace drive::clock_value
