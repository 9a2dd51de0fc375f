#pragma once

#include <array>

namespace drive {

/// What inputs of the control unit bring for the unit as a whole.
struct UnitInputs {
  bool acknowledge_all = false;  ///< p2102, edge
};

/// What the digital outputs of the control unit are connected to.
struct TerminalInputs {
  std::array<bool, 8> outputs{};  ///< p0738 to p0745, DI/DO 8 to 15
};

}  // namespace drive
