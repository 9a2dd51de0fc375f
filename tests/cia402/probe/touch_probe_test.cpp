#include "cia402/probe/touch_probe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <gtest/gtest.h>

#include "cia402/inputs/digital_inputs.hpp"

namespace cia402 {
namespace {

// Bits of 60B8h for probe 1; those of probe 2 are 8 higher.
constexpr unsigned kEnable = 0x01;
constexpr unsigned kContinuous = 0x02;
constexpr unsigned kIndex = 0x04;
constexpr unsigned kBy60D0h = 0x08;
constexpr unsigned kReserved = 0x0C;
constexpr unsigned kRising = 0x10;
constexpr unsigned kFalling = 0x20;

/// Two probes in cycles of 1 ms; 6064h is a tenth of the motor's increments.
struct Probing : testing::Test {
  TouchProbes probes{};
  std::array<std::int16_t, 2> sources{1, 2};
  std::uint64_t now = 5'000'000;  // µs

  void set(unsigned function, double instant = 0.0) {
    probes.set(static_cast<std::uint16_t>(function), sources, instant);
  }
  void pass(std::initializer_list<InputEvent> events) {
    probes.pass(std::vector<InputEvent>{events}, now,
                [](double position) { return static_cast<std::int32_t>(std::lround(position / 10.0)); });
    now += 1000;
  }
  static InputEvent rises(double position, Signal signal = Signal::Probe1, double instant = 0.5) {
    return {.signal = signal, .edge = Edge::Rising, .instant = instant, .position = position};
  }
  static InputEvent falls(double position, Signal signal = Signal::Probe1, double instant = 0.5) {
    return {.signal = signal, .edge = Edge::Falling, .instant = instant, .position = position};
  }
  static InputEvent pulse(double position, Signal signal) {
    return {.signal = signal, .edge = Edge::Pulse, .instant = 0.5, .position = position};
  }
  const TouchProbe& first() const { return probes.probe(0); }
  const TouchProbe& second() const { return probes.probe(1); }
};

TEST_F(Probing, IsOffAtPowerOn) {
  pass({rises(100.0), falls(200.0)});
  EXPECT_EQ(probes.status(), 0x0000);
  EXPECT_EQ(first().rising().position, 0);
  EXPECT_EQ(first().rising().count, 0);
}

TEST_F(Probing, ShowsThatItIsEnabled) {
  set(kEnable);
  EXPECT_EQ(probes.status(), 0x0001);
  set(kEnable << 8U);
  EXPECT_EQ(probes.status(), 0x0100);
  set(kEnable | kEnable << 8U);
  EXPECT_EQ(probes.status(), 0x0101);
}

TEST_F(Probing, KeepsPositionAndTimeOfTheEdge) {
  set(kEnable | kRising);
  now = 1'234'000;
  pass({rises(12345.6, Signal::Probe1, 0.789)});
  EXPECT_EQ(probes.status(), 0x0003);
  EXPECT_EQ(first().rising().position, 1235);
  EXPECT_EQ(first().rising().stamp, 1'234'789U);
  EXPECT_EQ(first().rising().count, 1);
  EXPECT_EQ(first().falling().count, 0);
}

TEST_F(Probing, HasAStampThatWraps) {
  set(kEnable | kRising);
  now = 0x1'FFFF'FFFFULL;
  pass({rises(1.0, Signal::Probe1, 0.003)});
  EXPECT_EQ(first().rising().stamp, 2U);
}

TEST_F(Probing, KeepsOnlyTheSelectedEdges) {
  set(kEnable | kFalling);
  pass({rises(10.0), falls(20.0)});
  EXPECT_EQ(probes.status(), 0x0005);
  EXPECT_EQ(first().falling().position, 2);
  EXPECT_EQ(first().rising().count, 0);

  set(kEnable);
  pass({rises(30.0), falls(40.0)});
  EXPECT_EQ(probes.status(), 0x0001);
}

TEST_F(Probing, KeepsOneOfEachSelectedEdgeInSingleMode) {
  set(kEnable | kRising | kFalling);
  pass({rises(10.0), falls(20.0), rises(30.0), falls(40.0)});
  pass({rises(50.0), falls(60.0)});
  EXPECT_EQ(probes.status(), 0x0007);
  EXPECT_EQ(first().rising().position, 1);
  EXPECT_EQ(first().falling().position, 2);
  EXPECT_EQ(first().rising().count, 1);
  EXPECT_EQ(first().falling().count, 1);
}

TEST_F(Probing, KeepsEveryEdgeInContinuousMode) {
  set(kEnable | kContinuous | kRising | kFalling);
  pass({rises(10.0)});
  EXPECT_EQ(probes.status(), 0x0043);
  pass({falls(20.0)});
  EXPECT_EQ(probes.status(), 0x00C7);
  pass({rises(30.0)});
  EXPECT_EQ(probes.status(), 0x0087);
  EXPECT_EQ(first().rising().position, 3);
  EXPECT_EQ(first().rising().count, 2);
  pass({falls(40.0), rises(50.0), falls(60.0)});
  EXPECT_EQ(probes.status(), 0x00C7) << "both have toggled: once, and twice";
  EXPECT_EQ(first().falling().position, 6);
  EXPECT_EQ(first().falling().count, 3);
}

TEST_F(Probing, DoesNotToggleInSingleMode) {
  set(kEnable | kRising);
  pass({rises(10.0)});
  EXPECT_EQ(probes.status() & 0xC0, 0);
}

TEST_F(Probing, LosesItsStatusAndKeepsItsValuesWhenItIsDisabled) {
  set(kEnable | kContinuous | kRising);
  pass({rises(10.0)});
  set(kContinuous | kRising);
  EXPECT_EQ(probes.status(), 0x0000);
  pass({rises(20.0)});
  EXPECT_EQ(first().rising().position, 1);
  EXPECT_EQ(first().rising().count, 1);
}

TEST_F(Probing, IsArmedByEnabling) {
  set(kEnable | kRising);
  pass({rises(10.0)});
  set(kRising);
  set(kEnable | kRising);
  EXPECT_EQ(probes.status(), 0x0001);
  EXPECT_EQ(first().rising().position, 1) << "until the next edge";
  pass({rises(20.0)});
  EXPECT_EQ(probes.status(), 0x0003);
  EXPECT_EQ(first().rising().position, 2);
  EXPECT_EQ(first().rising().count, 2);
}

TEST_F(Probing, IsArmedByOtherEdges) {
  set(kEnable | kRising);
  pass({rises(10.0)});
  set(kEnable | kRising | kFalling);
  EXPECT_EQ(probes.status(), 0x0001);
  pass({rises(20.0), falls(30.0)});
  EXPECT_EQ(probes.status(), 0x0007);
  EXPECT_EQ(first().rising().position, 2);
}

TEST_F(Probing, IsArmedByAnotherSource) {
  set(kEnable | kRising);
  pass({rises(10.0)});
  set(kEnable | kRising | kIndex);
  EXPECT_EQ(probes.status(), 0x0001);
  set(kEnable | kRising | kBy60D0h);
  pass({rises(20.0)});
  EXPECT_EQ(probes.status(), 0x0003);
  sources[0] = 2;
  set(kEnable | kRising | kBy60D0h);
  EXPECT_EQ(probes.status(), 0x0001);
}

TEST_F(Probing, IsNotArmedByTheSameFunction) {
  set(kEnable | kRising);
  pass({rises(10.0)});
  set(kEnable | kRising);
  sources[0] = 5;
  set(kEnable | kRising);
  EXPECT_EQ(probes.status(), 0x0003) << "60D0h is not asked";
  pass({rises(20.0)});
  EXPECT_EQ(first().rising().position, 1);
  set(kEnable | kRising | kContinuous);
  EXPECT_EQ(probes.status(), 0x0003);
  pass({rises(30.0)});
  EXPECT_EQ(first().rising().position, 3);
}

TEST_F(Probing, CountsFromTheInstantOfItsEnabling) {
  set(kEnable | kRising, 0.6);
  pass({rises(10.0, Signal::Probe1, 0.5), rises(20.0, Signal::Probe1, 0.7)});
  EXPECT_EQ(first().rising().position, 2);
  EXPECT_EQ(first().rising().count, 1);

  set(kRising);
  set(kEnable | kRising, 0.6);
  pass({});
  pass({rises(30.0, Signal::Probe1, 0.1)});
  EXPECT_EQ(first().rising().position, 3) << "the next cycle counts from its begin";
}

TEST_F(Probing, HasItsOwnInputEach) {
  set(kEnable | kRising | (kEnable | kRising) << 8U);
  pass({rises(10.0, Signal::Probe1)});
  EXPECT_EQ(probes.status(), 0x0103);
  pass({rises(20.0, Signal::Probe2)});
  EXPECT_EQ(probes.status(), 0x0303);
  EXPECT_EQ(first().rising().position, 1);
  EXPECT_EQ(second().rising().position, 2);
  EXPECT_EQ(first().rising().count, 1);
}

TEST_F(Probing, HasSecondProbeWithTheSameRules) {
  set((kEnable | kContinuous | kRising | kFalling) << 8U);
  pass({rises(10.0, Signal::Probe2), falls(20.0, Signal::Probe2), rises(30.0, Signal::Probe2)});
  EXPECT_EQ(probes.status(), 0x8700);
  EXPECT_EQ(second().rising().count, 2);
  EXPECT_EQ(second().falling().count, 1);
  EXPECT_EQ(second().falling().position, 2);
}

TEST_F(Probing, TakesTheSourceOf60D0h) {
  struct Choice {
    std::int16_t source;
    std::vector<Signal> signals;
  };
  const std::vector<Choice> choices{{1, {Signal::Probe1}}, {2, {Signal::Probe2}},       {3, {}}, {4, {}},
                                    {5, {Signal::Index}},  {6, {Signal::SoftwareZero}}, {0, {}}, {7, {}}};
  for (std::size_t probe = 0; probe < 2; ++probe)
    for (const Choice& choice : choices) {
      sources[probe] = choice.source;
      for (int i = 0; i < 7; ++i) {
        const auto signal = static_cast<Signal>(i);
        set(0);
        set((kEnable | kRising | kBy60D0h) << (8U * probe));
        const bool is_pulse = signal == Signal::Index || signal == Signal::SoftwareZero;
        pass({is_pulse ? pulse(10.0, signal) : rises(10.0, signal)});
        const bool kept = (probes.status() >> (8U * probe) & 0x02U) != 0;
        EXPECT_EQ(kept, std::ranges::count(choice.signals, signal) == 1)
            << probe << ' ' << choice.source << ' ' << i;
      }
    }
}

TEST_F(Probing, TakesTheIndexBy60B8h) {
  set(kEnable | kRising | kIndex);
  pass({rises(10.0), pulse(655360.0, Signal::Index)});
  EXPECT_EQ(probes.status(), 0x0003);
  EXPECT_EQ(first().rising().position, 65536);
}

TEST_F(Probing, TakesAPulseAsBothEdges) {
  set(kEnable | kRising | kFalling | kIndex);
  pass({pulse(655360.0, Signal::Index)});
  EXPECT_EQ(probes.status(), 0x0007);
  EXPECT_EQ(first().rising().position, first().falling().position);
}

TEST_F(Probing, HasNoSourceWithTheReservedOne) {
  set(kEnable | kRising | kReserved);
  pass({rises(10.0), pulse(20.0, Signal::Index)});
  EXPECT_EQ(probes.status(), 0x0001);
}

TEST_F(Probing, HasCountersThatWrap) {
  set(kEnable | kContinuous | kRising);
  for (int i = 0; i < 65536; ++i) pass({rises(1.0)});
  EXPECT_EQ(first().rising().count, 0);
  pass({rises(1.0)});
  EXPECT_EQ(first().rising().count, 1);
}

TEST_F(Probing, MeetsACamThatMovesThroughOneCycle) {
  TravelSwitches switches;
  switches.set(Signal::Probe1, {.from = 0.25, .to = 0.26});
  DigitalInputs inputs{switches, 65536};
  set(kEnable | kRising | kFalling | (kEnable | kRising | kBy60D0h) << 8U);
  sources[1] = 6;
  set(kEnable | kRising | kFalling | (kEnable | kRising | kBy60D0h) << 8U);
  inputs.pass({.motor_to = 65536 / 2, .load_to = 0.5}, ZeroPlace{.position = 12345.5});
  probes.pass(inputs.events(), 0,
              [](double position) { return static_cast<std::int32_t>(std::lround(position)); });
  EXPECT_EQ(probes.status(), 0x0307);
  EXPECT_EQ(first().rising().position, 16384);
  EXPECT_EQ(first().rising().stamp, 500U);
  EXPECT_EQ(first().falling().position, 17039);
  EXPECT_EQ(first().falling().stamp, 520U);
  EXPECT_EQ(second().rising().position, 12346);
}

}  // namespace
}  // namespace cia402
