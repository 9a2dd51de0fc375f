#pragma once

#include <cstdint>

namespace profidrive {

/// What p8839 assigns to an interface.
enum class Hardware : std::uint8_t {
  None = 0,
  Onboard = 1,
  CommBoard = 2,  ///< in the option slot, where the CANopen board is
  Automatic = 99,
};
constexpr bool is_hardware(double value) noexcept {
  return value == 0.0 || value == 1.0 || value == 2.0 || value == 99.0;
}

/// Which interfaces exchange process data.
struct Assignment {
  bool if1 = true;       ///< PROFIdrive, onboard
  bool if2 = true;       ///< the CAN bus, on the board in the option slot
  bool is_valid = true;  ///< otherwise A08550

  friend bool operator==(const Assignment&, const Assignment&) = default;
};

/// What p8839[0] = @p first and p8839[1] = @p second come to with the CANopen board: automatic for both is IF1
/// onboard and IF2 on the board. A single automatic counts as none, the same hardware twice or the board as IF1
/// makes both none.
constexpr Assignment assignment_of(Hardware first, Hardware second) noexcept {
  const bool first_automatic = first == Hardware::Automatic, second_automatic = second == Hardware::Automatic;
  if (first_automatic && second_automatic) return {};
  if (first == Hardware::CommBoard || (first == second && first != Hardware::None)) return {false, false, false};
  return {first == Hardware::Onboard, second == Hardware::CommBoard, !first_automatic && !second_automatic};
}
static_assert(assignment_of(Hardware::Automatic, Hardware::CommBoard) == Assignment{false, true, false});

}  // namespace profidrive
