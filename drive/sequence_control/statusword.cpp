#include "drive/sequence_control/statusword.hpp"

#include <array>
#include <cstddef>

namespace drive {
namespace {

/// Bits that a state sets or clears whatever the signals say.
struct StateBits {
  State state;
  std::uint16_t set;
  std::uint16_t clear;
};
constexpr std::array<StateBits, kStateCount> kRows{{
    {State::NotReadyToSwitchOn, 0x0000, 0xFFFF},
    {State::SwitchOnDisabled, 0x0040, 0x0000},
    {State::ReadyToSwitchOn, 0x0021, 0x0000},
    {State::SwitchedOn, 0x0023, 0x0000},
    {State::OperationEnabled, 0x0027, 0x0000},
    {State::Off1Braking, 0x0027, 0x0000},
    {State::QuickStopActive, 0x0007, 0x0020},
    {State::FaultReactionActive, 0x000F, 0x0000},
    {State::Stop2Active, 0x000F, 0x0000},
    {State::Fault, 0x0008, 0x0000},
}};
static_assert([] {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].state != static_cast<State>(i)) return false;
  return true;
}());

struct Bit {
  bool on;
  unsigned number;
};

}  // namespace

std::uint16_t statusword(State state, const StatusSignals& signals) noexcept {
  const std::array bits{
      Bit{signals.fault, 3},           Bit{signals.no_off2, 4},
      Bit{signals.no_off3, 5},         Bit{signals.alarm, 7},
      Bit{signals.free_bit_8, 8},      Bit{signals.remote, 9},
      Bit{signals.target_reached, 10}, Bit{signals.torque_limit_reached, 11},
      Bit{signals.speed_zero, 12},     Bit{signals.free_bit_14, 14},
      Bit{signals.free_bit_15, 15},
  };
  unsigned word = 0;
  for (const Bit& bit : bits) word |= static_cast<unsigned>(bit.on) << bit.number;
  const StateBits& row = kRows[static_cast<std::size_t>(state)];
  return static_cast<std::uint16_t>((word & ~static_cast<unsigned>(row.clear)) | row.set);
}

std::uint16_t with_free_bits(std::uint16_t word, const FreeStatusBits::Inputs& free) noexcept {
  unsigned result = word;
  for (const Bit& bit : {Bit{free.bit_8, 8}, Bit{free.bit_14, 14}, Bit{free.bit_15, 15}})
    result = (result & ~(1U << bit.number)) | static_cast<unsigned>(bit.on) << bit.number;
  return static_cast<std::uint16_t>(result);
}

}  // namespace drive
