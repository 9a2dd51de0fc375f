#pragma once

#include <array>
#include <cstdint>

namespace drive {

/// The fast digital inputs DI 0 to 7 of the control unit in a slice of time that has passed: their levels at its
/// end, and when they changed in it. Of several edges of one direction the last is known.
struct InputEdges {
  static constexpr unsigned kInputs = 8;
  /// In place of an instant: no such edge.
  static constexpr double kNone = -1.0;
  using Instants = std::array<double, kInputs>;

  static constexpr Instants none() noexcept {
    Instants instants{};
    instants.fill(kNone);
    return instants;
  }

  std::uint8_t levels = 0;    ///< a bit an input
  Instants rising = none();   ///< where in the slice (0 its beginning, 1 its end), kNone: not at all
  Instants falling = none();  ///< the same

  /// Whether @p input is 1 at the end of the slice.
  constexpr bool level(unsigned input) const noexcept { return (levels >> input & 1U) != 0; }
  /// Whether @p input is 1 at @p instant (0..1) of the slice.
  constexpr bool level_at(unsigned input, double instant) const noexcept {
    const double up = rising[input];
    const double down = falling[input];
    const bool rose = up >= 0.0 && up <= instant;
    const bool fell = down >= 0.0 && down <= instant;
    if (rose || fell) return rose && (!fell || up >= down);
    const bool rises = up >= 0.0;
    const bool falls = down >= 0.0;
    if (rises && falls) return down < up;
    return rises || falls ? falls : level(input);
  }

  friend bool operator==(const InputEdges&, const InputEdges&) = default;
};

}  // namespace drive
