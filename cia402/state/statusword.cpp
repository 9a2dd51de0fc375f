#include "cia402/state/statusword.hpp"

#include <array>

namespace cia402 {
namespace {

struct Bit {
  bool on;
  unsigned number;
};

}  // namespace

std::uint16_t statusword(State state, const StatusSignals& signals) noexcept {
  const bool shows_mode = state == State::OperationEnabled || signals.keeps_mode_bits;
  const ModeBits mode = shows_mode ? signals.mode : ModeBits{};
  const std::array bits{
      Bit{signals.has_voltage, 4}, Bit{signals.has_warning, 7}, Bit{signals.is_remote, 9},
      Bit{mode.bit_10, 10},        Bit{signals.is_limited, 11}, Bit{mode.bit_12, 12},
      Bit{mode.bit_13, 13},        Bit{signals.is_homed, 15},
  };
  unsigned word = row_of(state).bits;
  for (const Bit& bit : bits) word |= static_cast<unsigned>(bit.on) << bit.number;
  return static_cast<std::uint16_t>(word);
}

}  // namespace cia402
