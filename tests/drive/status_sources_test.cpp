// Bits that status words of telegrams are made of: r0053, r0056, r1406, r2135, r2197, r2199, r3113.
#include <array>
#include <cstdint>

#include "tests/drive/wired_axis.hpp"

namespace drive {
namespace {

bool bit(const WiredAxis& wired, std::uint16_t number, unsigned place) {
  return (wired.word(number) >> place & 1U) != 0;
}

TEST(StatusSources, OfAnAxisThatStandsReadyToSwitchOn) {
  const WiredAxis wired;
  EXPECT_EQ(wired.word(53), 0x02E8u)
      << "current from 0, below p2155, not below 0, DC link below p2172, ramp ended";
  EXPECT_EQ(wired.word(2197), 0x00AAu);
  EXPECT_EQ(wired.word(2199), 0x0831u);
  EXPECT_EQ(wired.word(2135), 0u);
  EXPECT_EQ(wired.word(3113), 0u);
}

TEST(StatusSources, SpeedThreshold1HasAHysteresis) {
  WiredAxis wired;
  ASSERT_TRUE(wired.axis.write(2141, 100.0));
  ASSERT_TRUE(wired.axis.write(2142, 20.0));
  for (const auto& [rpm, reached] : {std::pair{95.0, false}, std::pair{110.0, true}, std::pair{85.0, true},
                                     std::pair{70.0, false}, std::pair{-110.0, true}}) {
    wired.turn_at(rpm);
    EXPECT_EQ(bit(wired, 2199, 1), reached) << rpm;
  }
}

TEST(StatusSources, DirectionHasAHysteresis) {
  WiredAxis wired;
  ASSERT_TRUE(wired.axis.write(2150, 50.0));
  for (const auto& [rpm, forward] : {std::pair{100.0, true}, std::pair{-40.0, true}, std::pair{-60.0, false},
                                     std::pair{-20.0, false}, std::pair{20.0, true}}) {
    wired.turn_at(rpm);
    EXPECT_EQ(bit(wired, 2197, 3), forward) << rpm;
  }
}

TEST(StatusSources, SpeedAboveItsThresholds) {
  WiredAxis wired;
  ASSERT_TRUE(wired.axis.write(1080, 50.0));
  ASSERT_TRUE(wired.axis.write(2155, 200.0));
  wired.turn_at(150.0);
  EXPECT_TRUE(bit(wired, 53, 1) && bit(wired, 53, 2) && !bit(wired, 53, 4) && bit(wired, 53, 5));
  EXPECT_TRUE(bit(wired, 2197, 1));
  wired.turn_at(300.0);
  EXPECT_TRUE(bit(wired, 53, 4) && !bit(wired, 53, 5));
  EXPECT_FALSE(bit(wired, 2197, 1));
}

TEST(StatusSources, CurrentAndLinkAtTheirThresholds) {
  WiredAxis wired;
  ASSERT_TRUE(wired.axis.write(2170, 3.0));
  EXPECT_FALSE(bit(wired, 53, 3));
  const double torque = wired.axis.read(333).value();
  wired.axis.set_load_torque(torque);
  wired.turn_at(100.0);
  EXPECT_TRUE(bit(wired, 53, 3)) << "rated torque takes 5.6 A";
  EXPECT_TRUE(bit(wired, 53, 7) && !bit(wired, 53, 8));
  ASSERT_TRUE(wired.axis.write(2172, 500.0));
  EXPECT_TRUE(!bit(wired, 53, 7) && bit(wired, 53, 8));
}

TEST(StatusSources, RampAndTarget) {
  WiredAxis wired;
  ASSERT_TRUE(wired.axis.write(1120, 2.0));
  ASSERT_TRUE(wired.axis.write(2167, 300.0));
  wired.inputs.on = true;
  wired.inputs.main_setpoint = 1800.0 * kRpm;
  wired.run(0.3);
  EXPECT_FALSE(bit(wired, 53, 9) || bit(wired, 2199, 5)) << "2 s to 7200 rpm";
  EXPECT_FALSE(bit(wired, 2199, 4));
  wired.run(0.3);
  EXPECT_TRUE(bit(wired, 53, 9) && bit(wired, 2199, 5));
  EXPECT_TRUE(bit(wired, 2197, 7));
  EXPECT_FALSE(bit(wired, 2199, 4)) << "p2167";
  wired.run(0.3);
  EXPECT_TRUE(bit(wired, 2199, 4));
}

TEST(StatusSources, AnAxisDoesNotRestBeforeTheOnDelayIsOver) {
  WiredAxis wired;
  wired.turn_at(200.0);
  ASSERT_TRUE(wired.axis.write(2167, 2000.0));
  wired.inputs.on = false;
  wired.run(1.5);
  ASSERT_FALSE(wired.axis.actual().pulses_enabled);
  EXPECT_FALSE(wired.axis.is_quiescent());
  EXPECT_FALSE(bit(wired, 2199, 4));
  wired.run(15.0);
  EXPECT_TRUE(wired.axis.is_quiescent());
  EXPECT_TRUE(bit(wired, 2199, 4));
}

TEST(StatusSources, TorqueAtItsLimitAndItsUtilisation) {
  WiredAxis wired;
  wired.turn_at(100.0);
  EXPECT_TRUE(bit(wired, 2199, 11));
  EXPECT_FALSE(bit(wired, 56, 13));
  wired.axis.set_load_torque(0.95 * wired.axis.read(1538).value());
  wired.run(0.2);
  EXPECT_FALSE(bit(wired, 2199, 11)) << "p2194 is 90 %";
  wired.axis.set_load_torque(2.0 * wired.axis.read(1538).value());
  wired.run(0.02);
  EXPECT_TRUE(bit(wired, 56, 13));
}

TEST(StatusSources, FixedStopIsInTheControlWordOfTheSpeedController) {
  WiredAxis wired;
  EXPECT_FALSE(bit(wired, 1406, 8));
  wired.axis.block<TorqueSetpoint>().inputs.travels_to_fixed_stop = true;
  EXPECT_TRUE(bit(wired, 1406, 8));
}

struct Classified {
  std::uint16_t message;
  unsigned thermal;  ///< r2135
  unsigned namur;    ///< r3113
};

TEST(StatusSources, MessagesHaveTheirBits) {
  constexpr std::array kMessages{
      Classified{7011, 0x1000, 0x0040},  Classified{7910, 0x4000, 0x0040},  Classified{7805, 0x8000, 0x0010},
      Classified{30004, 0x2000, 0x0010}, Classified{30025, 0x2000, 0x0010}, Classified{30001, 0, 0x0008},
      Classified{30002, 0, 0x0004},      Classified{30003, 0, 0x0800},      Classified{30011, 0, 0x0002},
      Classified{30015, 0, 0x0020},      Classified{30600, 0, 0x0100},      Classified{30801, 0, 0x0400},
      Classified{31116, 0, 0x0200},      Classified{1910, 0, 0x0080},       Classified{8700, 0, 0x0080},
      Classified{7860, 0, 0x8000},       Classified{7450, 0, 0x8000},
  };
  for (const Classified& row : kMessages) {
    WiredAxis wired;
    ASSERT_TRUE(wired.axis.raise(row.message, 0)) << row.message;
    EXPECT_EQ(wired.word(2135), row.thermal) << row.message;
    EXPECT_EQ(wired.word(3113), row.namur) << row.message;
  }
}

TEST(StatusSources, MessagesStandSideBySideAndAsWhatTheyWereMade) {
  WiredAxis wired;
  ASSERT_TRUE(wired.axis.write(2118, 0, 7011.0));
  ASSERT_TRUE(wired.axis.write(2119, 0, 2.0));
  ASSERT_TRUE(wired.axis.raise(7011, 0));
  EXPECT_EQ(wired.word(2135), 0x4000u) << "an alarm by p2119";
  ASSERT_TRUE(wired.axis.raise(30004, 0));
  EXPECT_EQ(wired.word(2135), 0x6000u);
  EXPECT_EQ(wired.word(3113), 0x0050u);
  wired.axis.withdraw(7011);
  EXPECT_EQ(wired.word(2135), 0x2000u);
}

}  // namespace
}  // namespace drive
