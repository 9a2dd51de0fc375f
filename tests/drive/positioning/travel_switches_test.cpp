// Switches beside the way of a load, and the digital inputs that they feed.
#include "drive/positioning/switches/travel_switches.hpp"

#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr double kNone = InputEdges::kNone;

TravelSwitchList list_of(std::initializer_list<TravelSwitch> rows) {
  TravelSwitchList list;
  for (const TravelSwitch& row : rows) list.add(row);
  return list;
}

/// A switch at DI 2 from 1 to 3 load revolutions.
struct OneSwitch {
  TravelSwitches switches;
  InputEdges inputs{};

  explicit OneSwitch(bool inverted = false)
      : switches{list_of({{.input = 2, .from = 1.0, .to = 3.0, .inverted = inverted}})} {}

  bool at(double place) {
    switches.move(place, inputs);
    return inputs.level(2);
  }
};

TEST(TravelSwitches, AreOnFromAPlaceToAnother) {
  OneSwitch cam;
  EXPECT_EQ(cam.switches.inputs(), 0x04);
  EXPECT_FALSE(cam.at(0.0));
  EXPECT_FALSE(cam.at(0.999));
  EXPECT_TRUE(cam.at(1.0));
  EXPECT_TRUE(cam.at(2.999));
  EXPECT_FALSE(cam.at(3.0));
  EXPECT_TRUE(cam.at(2.0));
  EXPECT_FALSE(cam.at(-7.0));
}

TEST(TravelSwitches, TellWhereInASliceTheirEdgesLie) {
  OneSwitch cam;
  cam.at(0.5);
  EXPECT_TRUE(cam.at(2.5));
  EXPECT_DOUBLE_EQ(cam.inputs.rising[2], 0.25);
  EXPECT_EQ(cam.inputs.falling[2], kNone);
  EXPECT_TRUE(cam.at(2.0));
  EXPECT_EQ(cam.inputs.rising[2], kNone);
  EXPECT_EQ(cam.inputs.falling[2], kNone);
  EXPECT_FALSE(cam.at(0.0));
  EXPECT_EQ(cam.inputs.rising[2], kNone);
  EXPECT_DOUBLE_EQ(cam.inputs.falling[2], 0.5);
}

TEST(TravelSwitches, AreRunOverInOneSlice) {
  for (const bool inverted : {false, true}) {
    OneSwitch cam{inverted};
    EXPECT_EQ(cam.at(4.0), inverted);
    const auto& entered = inverted ? cam.inputs.falling : cam.inputs.rising;
    const auto& left = inverted ? cam.inputs.rising : cam.inputs.falling;
    EXPECT_DOUBLE_EQ(entered[2], 0.25);
    EXPECT_DOUBLE_EQ(left[2], 0.75);
    EXPECT_EQ(cam.at(0.0), inverted);
    EXPECT_DOUBLE_EQ(entered[2], 0.25);
    EXPECT_DOUBLE_EQ(left[2], 0.75);
  }
}

TEST(TravelSwitches, HaveOneEdgeEachWayOverTheirEnd) {
  OneSwitch cam;
  cam.at(1.0);
  EXPECT_DOUBLE_EQ(cam.inputs.rising[2], 1.0);
  cam.at(1.0);
  EXPECT_EQ(cam.inputs.rising[2], kNone) << "it stands at the edge";
  cam.at(0.75);
  EXPECT_DOUBLE_EQ(cam.inputs.falling[2], 0.0);
  EXPECT_FALSE(cam.inputs.level(2));
}

TEST(TravelSwitches, LeaveOtherInputsAlone) {
  OneSwitch cam;
  cam.inputs.levels = 0xFF;
  cam.inputs.rising[5] = 0.5;
  cam.at(0.5);
  EXPECT_EQ(cam.inputs.levels, 0xFB);
  EXPECT_EQ(cam.inputs.rising[5], 0.5);
}

/// The terminals with a switch at DI 2 that is on, or off, at the end of a slice.
struct FedTerminals {
  static constexpr Terminals::Word kFed = 0x04;
  Terminals terminals{};

  void pass(bool on, double edge = kNone) {
    InputEdges switches{};
    switches.levels = on ? 0x04 : 0x00;
    (on ? switches.rising : switches.falling)[2] = edge;
    terminals.pass_slice(switches, kFed);
  }
};

TEST(FedTerminals, FollowTheirSwitch) {
  FedTerminals fed;
  fed.pass(true, 0.3);
  EXPECT_EQ(fed.terminals.levels(), 0x04U);
  EXPECT_EQ(fed.terminals.status(), 0x04U);
  EXPECT_EQ(fed.terminals.edges().rising[2], 0.3);
  EXPECT_TRUE(fed.terminals.edges().level(2));
  fed.pass(true);
  EXPECT_EQ(fed.terminals.edges().rising[2], kNone);
}

TEST(FedTerminals, StayForcedAgainstTheirSwitch) {
  FedTerminals fed;
  fed.terminals.apply(2, true);
  fed.pass(false, 0.4);
  EXPECT_EQ(fed.terminals.status(), 0x04U);
  EXPECT_EQ(fed.terminals.edges().rising[2], 0.0) << "at the beginning of the slice";
  EXPECT_EQ(fed.terminals.edges().falling[2], kNone);
  fed.pass(true, 0.4);
  EXPECT_EQ(fed.terminals.edges().rising[2], kNone);
  fed.terminals.apply(2, false);
  fed.pass(true);
  EXPECT_EQ(fed.terminals.status(), 0x00U);
  EXPECT_EQ(fed.terminals.edges().falling[2], 0.0);
}

TEST(FedTerminals, AreSimulatedInPlaceOfTheirSwitch) {
  FedTerminals fed;
  fed.terminals.simulated = fed.terminals.simulation = 0x04;
  fed.pass(false, 0.4);
  EXPECT_EQ(fed.terminals.levels(), 0x00U);
  EXPECT_TRUE(fed.terminals.edges().level(2));
  EXPECT_EQ(fed.terminals.edges().rising[2], 0.0);
}

TEST(FedTerminals, HaveEdgesOfOtherInputsAtTheBeginning) {
  FedTerminals fed;
  fed.terminals.apply(6, true);
  fed.pass(false);
  EXPECT_EQ(fed.terminals.edges().rising[6], 0.0);
  fed.pass(false);
  EXPECT_EQ(fed.terminals.edges().rising[6], kNone);
}

/// A unit of two axes, the second with gear 2:1 and switches at DI 0 and 1.
struct SwitchedUnit {
  static UnitConfiguration configuration() {
    UnitConfiguration unit = two_axes();
    unit.axes[1].mechanics = {.gear_motor = 2, .gear_load = 1};
    unit.axes[1].switches = list_of({{.input = 0, .from = 1.0, .to = 2.0}, {.input = 1, .from = -1.0, .to = 1.5}});
    return unit;
  }

  DriveUnit unit{configuration()};
  std::array<std::optional<Setpoints>, 2> setpoints{Setpoints{}, Setpoints{}};

  Axis& axis() { return unit.axes()[1]; }
  Terminals::Word inputs() const { return unit.control_unit().terminals().status() & 0xFFU; }
  void send(std::uint16_t controlword, double rpm) {
    setpoints[1] = Setpoints{.controlword = controlword, .speed = rpm * kRpm};
    unit.cycle(setpoints, kCycle);
  }
};

TEST(SwitchedUnit, HasItsInputsAsTheLoadStandsAtPowerOn) {
  const SwitchedUnit switched;
  EXPECT_EQ(switched.inputs(), 0x02U);
}

TEST(SwitchedUnit, FeedsItsInputsAsTheLoadTurns) {
  SwitchedUnit switched;
  for (const std::uint16_t word : std::initializer_list<std::uint16_t>{0x0006, 0x0006, 0x0007, 0x000F})
    switched.send(word, 0.0);
  double last = 0.0;
  for (int i = 0; i < 2000 && last < 2.5; ++i) {
    switched.send(0x000F, 120.0);
    last = switched.axis().load_place();
    const unsigned expected = (last >= 1.0 && last < 2.0 ? 1U : 0U) | (last < 1.5 ? 2U : 0U);
    ASSERT_EQ(switched.inputs(), expected) << last;
  }
  EXPECT_GE(last, 2.5);
  EXPECT_NEAR(last, static_cast<double>(switched.axis().actual().encoder_counts) / (2048 << 11) / 2.0, 1e-3)
      << "load revolutions behind the gear";
}

}  // namespace
}  // namespace drive
