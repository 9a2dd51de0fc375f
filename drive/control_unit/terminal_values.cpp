#include "drive/values/terminal_values.hpp"

#include "drive/control_unit/control_unit.hpp"

namespace drive::terminal_value {
namespace {

/// The bits of @p value that @p terminals have.
Terminals::Word bits(double value, Terminals::Word terminals) noexcept {
  return static_cast<Terminals::Word>(value) & terminals;
}

}  // namespace

double levels(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().levels();
}
double status(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().status();
}
double inverted_status(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().inverted_status();
}
double outputs(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().outputs();
}

double analog(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().analog();
}

double directions(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().directions;
}
void set_directions(ControlUnit& unit, std::size_t, double value) noexcept {
  unit.terminals().directions = bits(value, Terminals::kBidirectional);
}
double inversions(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().inversions;
}
void set_inversions(ControlUnit& unit, std::size_t, double value) noexcept {
  unit.terminals().inversions = bits(value, Terminals::kBidirectional);
}
double simulated(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().simulated;
}
void set_simulated(ControlUnit& unit, std::size_t, double value) noexcept {
  unit.terminals().simulated = bits(value, Terminals::kAll);
}
double simulation(const ControlUnit& unit, std::size_t) noexcept {
  return unit.terminals().simulation;
}
void set_simulation(ControlUnit& unit, std::size_t, double value) noexcept {
  unit.terminals().simulation = bits(value, Terminals::kAll);
}

}  // namespace drive::terminal_value
