// Axes that a controller leads by telegrams alone: on, ramp, OFF3, fault, acknowledgement, positions.
#include <cmath>

#include "tests/profidrive/if1_unit.hpp"

namespace profidrive {
namespace {

using Pzd = If1Unit;

constexpr std::uint16_t kOff = 0x047E, kOn = 0x047F, kOff3 = 0x047B, kAcknowledge = 0x04FE;
constexpr std::uint16_t kOperation = 0x0004, kFault = 0x0008, kOff3NotActive = 0x0020, kInhibited = 0x0040;

/// An axis whose telegram begins with STW1 and a speed, which ZSW1 and a speed answer.
struct SpeedTelegram {
  double number;
  unit::Configuration (*configuration)();
  std::size_t words;
};
class SpeedByTelegram : public testing::TestWithParam<SpeedTelegram> {
 protected:
  Words words(std::uint16_t stw1, std::uint16_t speed = 0) const {
    Words words(GetParam().words, 0);
    words[0] = stw1;
    words[1] = speed;
    return words;
  }
};

TEST_P(SpeedByTelegram, GoesThroughOnRampOff3FaultAndAcknowledgement) {
  If1Unit unit{GetParam().configuration()};
  unit.set(922, GetParam().number);
  unit.set(1120, 1.0);
  unit.set(1135, 0.5);
  if (GetParam().number == 350.0) unit.set(1552, 1.0);  // M_LIM
  unit.exchange(words(kOff), 200ms);
  ASSERT_EQ(unit.sent(1)[0] & 0x000F, 0x0001);

  const auto turn = [&] {
    unit.exchange(words(kOn), 3s);  // with the magnetisation of an induction machine
    EXPECT_TRUE((unit.sent(1)[0] & kOperation) != 0);
    unit.exchange(words(kOn, 0x1000), 4s);
    EXPECT_NEAR(unit.sent(2)[1], 0x1000, 0x80);
    EXPECT_NEAR(unit.read(63), 750.0, 25.0);
  };
  turn();

  unit.exchange(words(kOff3, 0x1000), 8ms);
  EXPECT_EQ(unit.sent(1)[0] & kOff3NotActive, 0);
  unit.exchange(words(kOff3, 0x1000), 3s);
  EXPECT_NEAR(unit.read(63), 0.0, 1.0);
  EXPECT_NE(unit.sent(1)[0] & kInhibited, 0);

  unit.exchange(words(kOff), 100ms);
  turn();
  ASSERT_TRUE(unit.runner.raise(1, 7860, 0, unit.runner.now()));
  unit.exchange(words(kOn), 100ms);
  EXPECT_NE(unit.sent(1)[0] & kFault, 0);
  EXPECT_EQ(unit.sent(1)[0] & kOperation, 0);
  unit.exchange(words(kAcknowledge), 100ms);
  EXPECT_EQ(unit.sent(1)[0] & kFault, 0);
}

INSTANTIATE_TEST_SUITE_P(Telegrams, SpeedByTelegram,
                         testing::Values(SpeedTelegram{1, &Pzd::servo, 2}, SpeedTelegram{1, &Pzd::vector, 2},
                                         SpeedTelegram{20, &Pzd::vector, 2}, SpeedTelegram{352, &Pzd::vector, 6},
                                         SpeedTelegram{353, &Pzd::servo, 2}),
                         [](const auto& param) {
                           return "Of" + std::to_string(static_cast<int>(param.param.number)) + "Case" +
                                  std::to_string(param.index);
                         });

TEST(SpeedByDoubleWords, OfTelegram102) {
  If1Unit unit;
  unit.set(922, 102.0);
  unit.set(1120, 1.0);
  unit.exchange({kOff, 0, 0, 0, 0, 0}, 200ms);
  unit.exchange({kOn, 0, 0, 0, 0, 0}, 1s);
  const Words sent = unit.exchange({kOn, 0x1000, 0x8000, 0, 0, 0}, 4s);
  EXPECT_NEAR((sent[1] << 16 | sent[2]) / 1073741824.0, 0x10008000 / 1073741824.0, 0.005);
}

/// MOMRED: 4000h takes the torque limits down by p1544.
TEST(TorqueReduction, OfTelegram102LimitsTheTorque) {
  If1Unit unit;
  unit.set(922, 102.0);
  const double full = unit.read(1538);
  unit.exchange({kOn, 0, 0, 0, 0x2000, 0}, 100ms);
  EXPECT_NEAR(unit.read(1538), full / 2.0, full * 0.01);
}

TEST(SpeedTelegram20, SendsWhatNamurAsksFor) {
  If1Unit unit{Pzd::vector()};
  unit.set(922, 20.0);
  unit.exchange({kOff, 0}, 200ms);
  unit.exchange({kOn, 0}, 3s);
  unit.exchange({kOn, 0x1000}, 12s);
  const Words sent = unit.sent(6);
  EXPECT_GT(sent[2], 0U);
  EXPECT_EQ(sent[5], 0U);
  ASSERT_TRUE(unit.runner.raise(1, 7902, 0, unit.runner.now()));
  unit.exchange({kOn, 0}, 20ms);
  EXPECT_NE(unit.sent(6)[5], 0U);
}

/// An axis with the positioner, referenced by parameter.
struct PositioningTelegram : If1Unit {
  explicit PositioningTelegram(double telegram) : If1Unit{positioner()} {
    set(922, telegram);
    set(2040, 0.0, 0, kControlUnit);
  }
  void reference() {
    set(2596, 1.0);
    passes(100ms);
    set(2596, 0.0);
  }
  double position() const { return read(2521); }
};
constexpr std::uint16_t kReady = 0x043E, kEnabled = 0x043F, kStart = 0x047F;
constexpr std::uint16_t kTargetReached = 0x0400, kReferenced = 0x0800;

std::uint16_t upper(std::uint32_t value) {
  return static_cast<std::uint16_t>(value >> 16);
}
std::uint16_t lower(std::uint32_t value) {
  return static_cast<std::uint16_t>(value);
}

TEST(PositionByTelegram, SevenRunsABlock) {
  PositioningTelegram unit{7};
  unit.exchange({kReady, 0}, 100ms);
  unit.reference();
  unit.set(2616, 5.0, 0);
  unit.set(2621, 1.0, 0);
  unit.set(2617, 20000.0, 0);
  unit.set(2618, 6000.0, 0);
  unit.exchange({kReady, 0}, 100ms);
  unit.exchange({kEnabled, 5}, 1s);
  EXPECT_NE(unit.sent(1)[0] & kReferenced, 0);
  unit.exchange({kStart, 5}, 20ms);
  EXPECT_EQ(unit.sent(1)[0] & kTargetReached, 0);
  EXPECT_EQ(unit.sent(2)[1], 5U);
  unit.exchange({kStart, 5}, 3s);
  EXPECT_NE(unit.sent(1)[0] & kTargetReached, 0);
  EXPECT_NEAR(unit.position(), 20000.0, 20.0);
}

TEST(PositionByTelegram, NineRunsMdi) {
  PositioningTelegram unit{9};
  const auto words = [](std::uint16_t stw1) {
    return Words{stw1, 0x8000, 0, upper(20000), lower(20000), upper(6000), lower(6000), 0x4000, 0x4000, 1};
  };
  unit.exchange(words(kReady), 100ms);
  unit.reference();
  unit.exchange(words(kReady), 100ms);
  unit.exchange(words(kEnabled), 1s);
  unit.exchange(words(kStart), 3s);
  EXPECT_NE(unit.sent(1)[0] & kTargetReached, 0);
  const Words sent = unit.sent(5);
  EXPECT_NEAR(sent[3] << 16 | sent[4], 20000, 20);
  EXPECT_NE(sent[1] & 0x8000, 0);
}

TEST(PositionByTelegram, HundredAndTenRunsMdiWithOverride) {
  PositioningTelegram unit{110};
  const auto words = [](std::uint16_t stw1, std::uint16_t override, std::uint16_t pos_stw = 0) {
    return Words{stw1,         0x8000,      pos_stw,     0,      override, upper(20000),
                 lower(20000), upper(6000), lower(6000), 0x4000, 0x4000,   1};
  };
  unit.exchange(words(kReady, 0), 100ms);
  unit.exchange(words(kReady, 0, 2), 100ms);
  unit.exchange(words(kEnabled, 0), 1s);
  unit.exchange(words(kStart, 0), 1s);
  EXPECT_NEAR(unit.position(), 0.0, 20.0);
  unit.exchange(words(kStart, 0x4000), 3s);
  const Words sent = unit.sent(7);
  EXPECT_NE(sent[0] & kTargetReached, 0);
  EXPECT_NEAR(sent[5] << 16 | sent[6], 20000, 20);
}

TEST(PositionByTelegram, HundredAndElevenReferencesAndRunsMdi) {
  PositioningTelegram unit{111};
  const auto words = [](std::uint16_t stw1, std::uint16_t pos_stw2, std::uint32_t target) {
    return Words{stw1,          0x8100,      pos_stw2,    0,      0x4000, upper(target),
                 lower(target), upper(6000), lower(6000), 0x4000, 0x4000, 0};
  };
  unit.exchange(words(kReady, 0, 0), 100ms);
  EXPECT_EQ(unit.sent(1)[0] & kReferenced, 0);
  unit.exchange(words(kReady, 2, 0), 100ms);
  unit.exchange(words(kReady, 0, 0), 100ms);
  EXPECT_NE(unit.sent(1)[0] & kReferenced, 0);
  unit.exchange(words(kEnabled, 0, 20000), 1s);
  unit.exchange(words(kStart, 0, 20000), 3s);
  const Words sent = unit.sent(12);
  EXPECT_NE(sent[0] & kTargetReached, 0);
  EXPECT_NEAR(sent[5] << 16 | sent[6], 20000, 20);
  EXPECT_NE(sent[1] & 0x8000, 0) << "MDI is active";
  EXPECT_EQ(sent[9], 0U);

  unit.exchange(words(kOff3, 0, 20000), 1s);
  EXPECT_NE(unit.sent(1)[0] & kInhibited, 0);
  ASSERT_TRUE(unit.runner.raise(1, 7860, 0, unit.runner.now()));
  unit.exchange(words(kReady, 0, 20000), 50ms);
  EXPECT_EQ(unit.sent(12)[9], 7860U);
  unit.exchange(words(static_cast<std::uint16_t>(kReady | 0x80), 0, 20000), 100ms);
  EXPECT_EQ(unit.sent(12)[9], 0U);
}

}  // namespace
}  // namespace profidrive
