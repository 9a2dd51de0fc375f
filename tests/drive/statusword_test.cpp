#include "drive/sequence_control/statusword.hpp"

#include <array>

#include <gtest/gtest.h>

namespace drive {
namespace {

struct Typical {
  State state;
  std::uint16_t controlword;
  std::uint16_t standing;  ///< at standstill with the setpoint zero
};

TEST(Statusword, HasItsTypicalValueInEveryState) {
  constexpr std::array kTypical{
      Typical{State::NotReadyToSwitchOn, 0x0000, 0x0000},
      Typical{State::SwitchOnDisabled, 0x0000, 0x1640},
      Typical{State::SwitchOnDisabled, 0x000F, 0x1670},
      Typical{State::ReadyToSwitchOn, 0x0006, 0x1631},
      Typical{State::SwitchedOn, 0x0007, 0x1633},
      Typical{State::OperationEnabled, 0x000F, 0x1637},
      Typical{State::Off1Braking, 0x0006, 0x1637},
      Typical{State::QuickStopActive, 0x000B, 0x1617},
      Typical{State::QuickStopActive, 0x000F, 0x1617},
      Typical{State::FaultReactionActive, 0x000F, 0x163F},
      Typical{State::Fault, 0x0006, 0x1638},
  };

  for (const Typical& expected : kTypical) {
    const StatusSignals signals{.no_off2 = (expected.controlword & 0x0002) != 0,
                                .no_off3 = (expected.controlword & 0x0004) != 0,
                                .target_reached = true,
                                .speed_zero = true};
    EXPECT_EQ(statusword(expected.state, signals), expected.standing);
  }
}

struct Masked {
  State state;
  std::uint16_t mask;
  std::uint16_t value;
};

TEST(Statusword, MatchesTheMasksOfCia402WhateverTheOtherSignalsAre) {
  constexpr std::array kMasks{
      Masked{State::NotReadyToSwitchOn, 0x4F, 0x00},
      Masked{State::SwitchOnDisabled, 0x4F, 0x40},
      Masked{State::ReadyToSwitchOn, 0x6F, 0x21},
      Masked{State::SwitchedOn, 0x6F, 0x23},
      Masked{State::OperationEnabled, 0x6F, 0x27},
      Masked{State::Off1Braking, 0x6F, 0x27},
      Masked{State::QuickStopActive, 0x6F, 0x07},
      Masked{State::FaultReactionActive, 0x4F, 0x0F},
      Masked{State::Fault, 0x4F, 0x08},
  };

  for (const Masked& expected : kMasks)
    for (unsigned signals = 0; signals < 64; ++signals) {
      const auto bit = [&](unsigned n) { return (signals >> n & 1U) != 0; };
      const StatusSignals all{bit(0), bit(1), false, bit(2), bit(3), bit(4), bit(5)};
      EXPECT_EQ(statusword(expected.state, all) & expected.mask, expected.value);
    }
}

TEST(Statusword, ShowsEachSignalInItsOwnBit) {
  const auto word = [](const StatusSignals& signals) { return statusword(State::SwitchOnDisabled, signals); };

  EXPECT_EQ(word({}), 0x0240);
  EXPECT_EQ(word({.no_off2 = true}), 0x0250);
  EXPECT_EQ(word({.no_off3 = true}), 0x0260);
  EXPECT_EQ(word({.fault = true}), 0x0248);
  EXPECT_EQ(word({.alarm = true}), 0x02C0);
  EXPECT_EQ(word({.target_reached = true}), 0x0640);
  EXPECT_EQ(word({.torque_limit_reached = true}), 0x0A40);
  EXPECT_EQ(word({.speed_zero = true}), 0x1240);
  EXPECT_EQ(word({.free_bit_8 = true}), 0x0340);
  EXPECT_EQ(word({.free_bit_14 = true}), 0x4240);
  EXPECT_EQ(word({.free_bit_15 = true}), 0x8240);
}

}  // namespace
}  // namespace drive
