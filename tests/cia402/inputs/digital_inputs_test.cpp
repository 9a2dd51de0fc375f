#include "cia402/inputs/digital_inputs.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cia402 {
namespace {

constexpr std::uint32_t kTurn = 65536;
constexpr double kEndless = std::numeric_limits<double>::infinity();

/// One switch, of H.
TravelSwitches home(double from, double to, bool inverted = false) {
  TravelSwitches switches;
  switches.set(Signal::Home, {.from = from, .to = to, .inverted = inverted});
  return switches;
}

/// The motor turns as the load does, between two places (revolutions).
CycleMotion between(double from, double to) {
  return {.motor_from = std::llround(from * kTurn),
          .motor_to = std::llround(to * kTurn),
          .load_from = from,
          .load_to = to};
}

/// Only switches: "H+^" is a rising edge of H met upwards.
std::string told(const DigitalInputs& inputs) {
  static constexpr char kNames[] = "NPH12IZ";
  std::string text;
  for (const InputEvent& event : inputs.events()) {
    text += kNames[static_cast<std::size_t>(event.signal)];
    text += event.edge == Edge::Pulse ? '|' : event.edge == Edge::Rising ? '+' : '-';
    text += event.is_upward ? '^' : 'v';
    text += ' ';
  }
  return text;
}

TEST(DigitalInputs, HaveTheirLevelsAtPowerOn) {
  TravelSwitches switches = home(-0.5, 0.5);
  switches.set(Signal::NegativeLimit, {.from = -kEndless, .to = -1.0});
  switches.set(Signal::PositiveLimit, {.from = -kEndless, .to = 1.0, .inverted = true});
  switches.set(Signal::Probe2, {.from = 0.0, .to = 1.0});
  const DigitalInputs inputs{switches, kTurn};

  EXPECT_EQ(inputs.levels().word(), 0x0002'0004U);
  EXPECT_TRUE(inputs.events().empty());
}

TEST(DigitalInputs, ShowEachLevelInItsBitOf60FDh) {
  const std::vector<std::uint32_t> bits{1U << 0U, 1U << 1U, 1U << 2U, 1U << 16U, 1U << 17U};
  for (std::size_t i = 0; i < bits.size(); ++i) {
    TravelSwitches switches;
    switches.set(TravelSwitches::kSignals[i], {.from = 1.0, .to = 2.0});
    DigitalInputs inputs{switches, kTurn};
    EXPECT_EQ(inputs.levels().word(), 0U);
    inputs.pass(between(0.0, 1.5));
    EXPECT_EQ(inputs.levels().word(), bits[i]);
  }
}

TEST(DigitalInputs, HaveAnEdgeWhereItLiesNotWhereTheCycleEnds) {
  DigitalInputs inputs{home(0.75, 2.0), kTurn};
  inputs.pass({.motor_from = 3 * 32768, .motor_to = 3 * 65535, .load_from = 0.5, .load_to = 65535.0 / 65536.0});

  ASSERT_EQ(told(inputs), "I|^ H+^ ");  // three revolutions of the motor in one of the load
  EXPECT_EQ(inputs.events()[0].position, 2.0 * kTurn);
  EXPECT_NEAR(inputs.events()[1].position, 3 * 49152.0, 1e-9);
  EXPECT_NEAR(inputs.events()[1].instant, 16384.0 / 32767.0, 1e-12);
}

TEST(DigitalInputs, SeeEveryEdgeOfANarrowCamInOneCycle) {
  DigitalInputs inputs{home(0.25, 0.26), kTurn};
  inputs.pass(between(0.125, 0.375));
  ASSERT_EQ(told(inputs), "H+^ H-^ ");
  EXPECT_NEAR(inputs.events()[0].position, 0.25 * kTurn, 1e-9);
  EXPECT_NEAR(inputs.events()[1].position, 0.26 * kTurn, 1e-9);
  EXPECT_FALSE(inputs.levels().at(Signal::Home));

  inputs.pass(between(0.375, 0.125));
  ASSERT_EQ(told(inputs), "H+v H-v ");
  EXPECT_NEAR(inputs.events()[0].position, 0.26 * kTurn, 1e-9);
  EXPECT_NEAR(inputs.events()[1].position, 0.25 * kTurn, 1e-9);
}

TEST(DigitalInputs, TurnTheEdgesOfAnInvertedSwitchRound) {
  DigitalInputs inputs{home(0.25, 0.5, true), kTurn};
  EXPECT_TRUE(inputs.levels().at(Signal::Home));
  inputs.pass(between(0.125, 0.375));
  EXPECT_EQ(told(inputs), "H-^ ");
  EXPECT_FALSE(inputs.levels().at(Signal::Home));
  inputs.pass(between(0.375, 0.75));
  EXPECT_EQ(told(inputs), "H+^ ");
  inputs.pass(between(0.75, 0.25));
  EXPECT_EQ(told(inputs), "H-v ") << "its lower end belongs to it";
  inputs.pass(between(0.25, 0.125));
  EXPECT_EQ(told(inputs), "H+v ");
}

TEST(DigitalInputs, HaveEventsInTheOrderOfTime) {
  TravelSwitches switches = home(0.5, 0.875);
  switches.set(Signal::NegativeLimit, {.from = -kEndless, .to = 0.75});
  switches.set(Signal::Probe1, {.from = 0.25, .to = 0.625});
  DigitalInputs inputs{switches, kTurn};
  inputs.pass(between(0.125, 1.125), ZeroPlace{.position = 0.6875 * kTurn});
  EXPECT_EQ(told(inputs), "1+^ H+^ 1-^ Z|^ N-^ H-^ I|^ ");
  for (std::size_t i = 1; i < inputs.events().size(); ++i)
    EXPECT_GT(inputs.events()[i].instant, inputs.events()[i - 1].instant);

  inputs.pass(between(1.125, 0.125), ZeroPlace{.position = 0.6875 * kTurn});
  EXPECT_EQ(told(inputs), "I|v H+v N+v Z|v 1+v H-v 1-v ");
}

TEST(DigitalInputs, HaveASwitchBeforeThePulseAtItsPlace) {
  for (const double gear : {1.0, 3.0, 7.0}) {
    DigitalInputs inputs{home(2.0, 3.0), kTurn};
    const double turn = gear * kTurn;
    for (const double from : {1.9, 1.99, 1.999}) {
      const CycleMotion up{.motor_from = std::llround(from * turn),
                           .motor_to = std::llround(2.001 * turn),
                           .load_from = static_cast<double>(std::llround(from * turn)) / turn,
                           .load_to = static_cast<double>(std::llround(2.001 * turn)) / turn};
      inputs.pass(up);
      ASSERT_GE(inputs.events().size(), 2U);
      const auto last = inputs.events().last(2);
      EXPECT_EQ(last[0].signal, Signal::Home) << gear << ' ' << from;
      EXPECT_EQ(last[1].signal, Signal::Index) << gear << ' ' << from;
      inputs.pass({.motor_from = up.motor_to,
                   .motor_to = up.motor_from,
                   .load_from = up.load_to,
                   .load_to = up.load_from});
      EXPECT_EQ(inputs.events()[0].signal, Signal::Home) << gear << ' ' << from;
    }
  }
}

TEST(DigitalInputs, HaveOneIndexInEachRevolutionOfTheMotor) {
  DigitalInputs inputs{{}, kTurn};
  std::vector<double> found;
  std::int64_t at = -200'000;
  inputs.pass({.motor_to = at});
  for (; at < 200'000; at += 1234) {
    inputs.pass({.motor_from = at, .motor_to = at + 1234});
    for (const InputEvent& event : inputs.events()) found.push_back(event.position / kTurn);
  }
  EXPECT_EQ(found, (std::vector<double>{-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}));
  for (found.clear(); at > -200'000; at -= 777) {
    inputs.pass({.motor_from = at, .motor_to = at - 777});
    for (const InputEvent& event : inputs.events()) found.push_back(event.position / kTurn);
  }
  EXPECT_EQ(found, (std::vector<double>{3.0, 2.0, 1.0, 0.0, -1.0, -2.0, -3.0}));
}

TEST(DigitalInputs, PassAPlaceOnceWhereverTheCyclesEnd) {
  DigitalInputs inputs{{}, kTurn};
  inputs.pass({.motor_from = -5, .motor_to = 0});
  EXPECT_EQ(told(inputs), "I|^ ");
  inputs.pass({.motor_from = 0, .motor_to = 0});
  EXPECT_EQ(told(inputs), "");
  inputs.pass({.motor_from = 0, .motor_to = 5});
  EXPECT_EQ(told(inputs), "");
  inputs.pass({.motor_from = 5, .motor_to = 0});
  EXPECT_EQ(told(inputs), "");
  inputs.pass({.motor_from = 0, .motor_to = -5});
  EXPECT_EQ(told(inputs), "I|v ");
}

TEST(DigitalInputs, HaveASoftwareZeroInEachTurnOfARange) {
  DigitalInputs inputs{{}, 1'000'000'000};
  const ZeroPlace zero{.position = 100.5, .period = 1000.0 / 3.0};
  std::vector<double> found;
  for (std::int64_t at = -500; at < 1000; at += 13) {
    inputs.pass({.motor_from = at, .motor_to = at + 13}, zero);
    for (const InputEvent& event : inputs.events())
      if (event.signal == Signal::SoftwareZero) found.push_back(event.position);
  }
  ASSERT_EQ(found.size(), 4U);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], 100.5 + (static_cast<double>(i) - 1.0) * 1000.0 / 3.0, 1e-9);
}

TEST(DigitalInputs, TakeAnyJumpOfTheEncoder) {
  TravelSwitches switches;
  for (const Signal signal : TravelSwitches::kSignals) switches.set(signal, {.from = 1.0, .to = 2.0});
  DigitalInputs inputs{switches, 1};
  inputs.pass({.motor_to = 1'000'000, .load_to = 10.0}, ZeroPlace{.position = 1.0, .period = 1.0});
  EXPECT_LE(inputs.events().size(), DigitalInputs::kMostEvents);
  EXPECT_EQ(inputs.levels().word(), 0U);
}

/// Any motion: the edges lead from the levels before to those behind, lie in the cycle and at the places of
/// switches.
TEST(DigitalInputs, HaveEdgesThatExplainTheirLevels) {
  constexpr unsigned kSeed = 20270211;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random{kSeed};
  std::uniform_real_distribution<double> place{-3.0, 3.0};
  constexpr double kGear = 2.5;
  for (int round = 0; round < 2000; ++round) {
    TravelSwitches switches;
    for (const Signal signal : TravelSwitches::kSignals) {
      const double from = place(random);
      switches.set(signal,
                   {.from = from, .to = from + std::abs(place(random)) / 3.0, .inverted = (random() & 1U) != 0});
    }
    DigitalInputs inputs{switches, kTurn};
    InputLevels levels = inputs.levels();
    std::int64_t at = 0;
    for (int cycle = 0; cycle < 20; ++cycle) {
      const std::int64_t next = std::llround(place(random) * kGear * kTurn);
      inputs.pass({.motor_from = at,
                   .motor_to = next,
                   .load_from = static_cast<double>(at) / kGear / kTurn,
                   .load_to = static_cast<double>(next) / kGear / kTurn});
      double instant = 0.0;
      for (const InputEvent& event : inputs.events()) {
        ASSERT_GE(event.instant, instant);
        ASSERT_EQ(event.is_upward, next > at);
        instant = event.instant;
        if (event.edge == Edge::Pulse) continue;
        ASSERT_NE(levels.at(event.signal), event.edge == Edge::Rising);
        levels.set(event.signal, event.edge == Edge::Rising);
        const TravelSwitch& fitted = *switches.of(event.signal);
        const bool lower = event.is_upward == ((event.edge == Edge::Rising) != fitted.inverted);
        ASSERT_NEAR(event.position, (lower ? fitted.from : fitted.to) * kGear * kTurn, 1e-6);
      }
      ASSERT_LE(instant, 1.0);
      ASSERT_EQ(levels, inputs.levels());
      at = next;
    }
  }
}

}  // namespace
}  // namespace cia402
