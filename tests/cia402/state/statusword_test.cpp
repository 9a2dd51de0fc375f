#include "cia402/state/statusword.hpp"

#include <array>

#include <gtest/gtest.h>

namespace cia402 {
namespace {

using enum State;

constexpr StatusSignals kAll{.has_voltage = true,
                             .has_warning = true,
                             .is_remote = true,
                             .is_limited = true,
                             .is_homed = true,
                             .mode = {.bit_10 = true, .bit_12 = true, .bit_13 = true}};

struct Row {
  State state;
  std::uint16_t bits;
  std::uint16_t mask;
};
constexpr std::array<Row, kStateCount> kRows{{
    {NotReadyToSwitchOn, 0x00, 0x4F},
    {SwitchOnDisabled, 0x40, 0x4F},
    {ReadyToSwitchOn, 0x21, 0x6F},
    {SwitchedOn, 0x23, 0x6F},
    {OperationEnabled, 0x27, 0x6F},
    {QuickStopActive, 0x07, 0x6F},
    {FaultReactionActive, 0x0F, 0x4F},
    {Fault, 0x08, 0x4F},
}};

TEST(Statusword, TellsTheStateWhateverTheSignalsAre) {
  for (const Row& row : kRows)
    for (const StatusSignals& signals : {StatusSignals{}, kAll}) {
      const std::uint16_t word = statusword(row.state, signals);
      EXPECT_EQ(word & row.mask, row.bits) << name_of(row.state);
      for (const Row& other : kRows)
        EXPECT_EQ((word & other.mask) == other.bits, other.state == row.state) << name_of(other.state);
    }
}

TEST(Statusword, HasABitForEverySignal) {
  for (const Row& row : kRows) {
    const unsigned none = statusword(row.state, {});
    const auto added = [&](const StatusSignals& signals) { return statusword(row.state, signals) ^ none; };
    EXPECT_EQ(none & 0xFF90U, 0U);
    EXPECT_EQ(added({.has_voltage = true}), 0x0010U);
    EXPECT_EQ(added({.has_warning = true}), 0x0080U);
    EXPECT_EQ(added({.is_remote = true}), 0x0200U);
    EXPECT_EQ(added({.is_limited = true}), 0x0800U);
    EXPECT_EQ(added({.is_homed = true}), 0x8000U);
    EXPECT_EQ(statusword(row.state, kAll) & 0x4100U, 0U);
  }
}

TEST(Statusword, ShowsTheBitsOfTheModeInOperationEnabledOrWhereTheModeKeepsThem) {
  for (const Row& row : kRows)
    for (const bool keeps : {false, true}) {
      const auto shown = [&](const ModeBits& bits) {
        return statusword(row.state, {.mode = bits, .keeps_mode_bits = keeps}) & 0x3400U;
      };
      const bool shows = keeps || row.state == OperationEnabled;
      EXPECT_EQ(shown({.bit_10 = true}), shows ? 0x0400U : 0U);
      EXPECT_EQ(shown({.bit_12 = true}), shows ? 0x1000U : 0U);
      EXPECT_EQ(shown({.bit_13 = true}), shows ? 0x2000U : 0U);
    }
}

TEST(States, AreNamedAsCia402PrintsThem) {
  EXPECT_EQ(name_of(SwitchOnDisabled), "Switch on disabled");
  EXPECT_EQ(name_of(FaultReactionActive), "Fault reaction active");
}

}  // namespace
}  // namespace cia402
