#pragma once

#include <array>

namespace drive {

/// What inputs of the control unit bring for the unit as a whole.
struct UnitInputs {
  bool acknowledge_all = false;  ///< p2102, edge
  bool utc_ping = false;         ///< p3104, edge

  friend bool operator==(const UnitInputs&, const UnitInputs&) = default;
};

/// What inputs of the infeed bring for its sequence control.
struct InfeedInputs {
  bool on = false;               ///< p0840, 0 = OFF1
  bool no_off2 = true;           ///< p0844 and
  bool no_off2_second = true;    ///< p0845, 0 = OFF2
  bool enable_operation = true;  ///< p0852

  friend bool operator==(const InfeedInputs&, const InfeedInputs&) = default;
  /// Whether OFF2 is given, by either of its inputs.
  constexpr bool has_off2() const noexcept { return !(no_off2 && no_off2_second); }
};

/// What the digital outputs of the control unit are connected to.
struct TerminalInputs {
  std::array<bool, 8> outputs{};  ///< p0738 to p0745, DI/DO 8 to 15
};

}  // namespace drive
