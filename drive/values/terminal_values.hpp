#pragma once

#include <cstddef>

namespace drive {
class ControlUnit;
}

/// What parameters show and make of the terminals of the control unit, a bit each of the digital ones.
namespace drive::terminal_value {

/// r0721, r0722, r0723 and r0747.
double levels(const ControlUnit& unit, std::size_t index) noexcept;
double status(const ControlUnit& unit, std::size_t index) noexcept;
double inverted_status(const ControlUnit& unit, std::size_t index) noexcept;
double outputs(const ControlUnit& unit, std::size_t index) noexcept;

/// r0752 (V).
double analog(const ControlUnit& unit, std::size_t index) noexcept;

/// p0728: DI/DO that are outputs; p0748: outputs that are inverted; p0795 and p0796: inputs that are simulated,
/// and as what. Bits that no terminal of the kind has stay 0.
double directions(const ControlUnit& unit, std::size_t index) noexcept;
void set_directions(ControlUnit& unit, std::size_t index, double value) noexcept;
double inversions(const ControlUnit& unit, std::size_t index) noexcept;
void set_inversions(ControlUnit& unit, std::size_t index, double value) noexcept;
double simulated(const ControlUnit& unit, std::size_t index) noexcept;
void set_simulated(ControlUnit& unit, std::size_t index, double value) noexcept;
double simulation(const ControlUnit& unit, std::size_t index) noexcept;
void set_simulation(ControlUnit& unit, std::size_t index, double value) noexcept;

}  // namespace drive::terminal_value
