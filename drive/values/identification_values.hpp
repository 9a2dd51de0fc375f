#pragma once

#include <cstddef>

namespace drive {
class Axis;
}

/// What parameters show and select of the motor identification of an axis, each in the unit of its parameter.
namespace drive::identification_value {

double progress(const Axis& axis, std::size_t index) noexcept;

double both(const Axis& axis, std::size_t index) noexcept;
double standstill(const Axis& axis, std::size_t index) noexcept;
double rotating(const Axis& axis, std::size_t index) noexcept;
void select_both(Axis& axis, std::size_t index, double value) noexcept;
void select_standstill(Axis& axis, std::size_t index, double value) noexcept;
void select_rotating(Axis& axis, std::size_t index, double value) noexcept;

// What was found last; 0 as long as nothing was.
double d_inductance(const Axis& axis, std::size_t index) noexcept;
double inertia(const Axis& axis, std::size_t index) noexcept;
double leakage(const Axis& axis, std::size_t index) noexcept;
double magnetising_inductance(const Axis& axis, std::size_t index) noexcept;
double pole_position(const Axis& axis, std::size_t index) noexcept;
double q_inductance(const Axis& axis, std::size_t index) noexcept;
double rotor_resistance(const Axis& axis, std::size_t index) noexcept;
double rotor_time_constant(const Axis& axis, std::size_t index) noexcept;
double stator_resistance(const Axis& axis, std::size_t index) noexcept;
double threshold_voltage(const Axis& axis, std::size_t index) noexcept;
double torque_constant(const Axis& axis, std::size_t index) noexcept;

}  // namespace drive::identification_value
