#pragma once

#include <array>

#include "tests/device/wired_device.hpp"

namespace device {

struct Command {
  std::uint16_t input;
  std::uint16_t bit;
};
inline constexpr std::array kCommands{Command{840, 0}, Command{844, 1}, Command{848, 2}, Command{852, 3},
                                      Command{2103, 7}};

inline void expect_commands_at(const WiredDevice& unit, std::uint16_t word, std::size_t axis = 1) {
  for (const Command& command : kCommands)
    EXPECT_EQ(unit.parameter(command.input, 0, axis), own(word, command.bit)) << 'p' << command.input;
}

}  // namespace device
