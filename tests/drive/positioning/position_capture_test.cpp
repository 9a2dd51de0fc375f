// Zero marks and measuring probes (p2508 to p2511, p0488 to p0495, r2523).
#include <gtest/gtest.h>

#include "tests/drive/positioning/sensed_axis.hpp"

namespace drive {
namespace {

constexpr unsigned kInput = 3;
constexpr std::int32_t kTerminal = 4;  // n is DI n-1

TEST(ZeroMark, IsMeasuredExactly) {
  SensedAxis axis;
  axis.turn(300);
  axis.position.inputs.search_mark[0] = true;
  axis.stay();
  EXPECT_EQ(axis.position.status(), 0x0003);
  axis.turn(699);
  EXPECT_TRUE(axis.position.referencing_active());
  axis.turn(250);
  EXPECT_EQ(axis.position.status(), 0x0005);
  EXPECT_EQ(axis.position.measured_shown(), 1000);
  axis.turn(3000);
  EXPECT_EQ(axis.position.measured_shown(), 1000) << "the first one";
  axis.position.inputs.search_mark[0] = false;
  axis.stay();
  EXPECT_EQ(axis.position.status(), 0x0001);
  EXPECT_FALSE(axis.position.interrupted());
}

TEST(ZeroMark, IsMeasuredInEitherDirection) {
  SensedAxis axis;
  axis.turn(300);
  axis.position.correct(5000);
  axis.position.inputs.search_mark[0] = true;
  axis.stay();
  axis.turn(-301);
  EXPECT_TRUE(axis.position.measured_valid());
  EXPECT_EQ(axis.position.measured(), 5000.0);
}

TEST(ZeroMark, IsNotTheOneThatTheAxisStandsOn) {
  SensedAxis axis;
  axis.turn(1000);
  axis.position.inputs.search_mark[0] = true;
  axis.stay();
  axis.turn(-999);
  EXPECT_TRUE(axis.position.referencing_active());
  axis.turn(-1);
  EXPECT_EQ(axis.position.measured_shown(), 0);
}

TEST(ZeroMark, LiesAtTheZeroOfTheDisc) {
  motor::EncoderData data = SensedAxis::encoder();
  data.start_position = 0.75;
  SensedAxis axis{data};
  axis.position.inputs.search_mark[0] = true;
  axis.stay();
  axis.turn(400);
  EXPECT_EQ(axis.position.measured_shown(), 250);
}

TEST(ZeroMark, CountsWithTheBacklashThatIsLeft) {
  SensedAxis axis;
  axis.position.settings.backlash = 50;
  axis.turn(1020);
  axis.slice.is_referenced = true;
  axis.position.inputs.search_mark[0] = true;
  axis.stay();
  axis.turn(-100);
  EXPECT_EQ(axis.shown(), 970);
  EXPECT_EQ(axis.position.measured_shown(), 1020) << "20 of 50 LU of play were used";
}

TEST(ZeroMark, CountsOnlyWhileItsTerminalIsSet) {
  SensedAxis axis;
  axis.position.settings.mark_selection[0] = kTerminal;
  axis.position.inputs.search_mark[0] = true;
  axis.turn(500);
  axis.turn(1000);
  EXPECT_TRUE(axis.position.referencing_active());
  axis.edge(kInput, true, 0.6);
  axis.turn(1000);  // the mark lies at 0.5
  EXPECT_TRUE(axis.position.referencing_active());
  axis.edge(kInput, false, 0.6);
  axis.turn(1000);
  EXPECT_EQ(axis.position.measured_shown(), 3000);
}

TEST(EquivalentMark, IsARisingEdge) {
  for (const bool second : {false, true}) {
    SensedAxis axis;
    (second ? axis.position.settings.equivalent_mark_2 : axis.position.settings.equivalent_mark)[0] = kTerminal;
    axis.position.inputs.search_mark[0] = true;
    axis.turn(400);
    axis.turn(3000);
    EXPECT_TRUE(axis.position.referencing_active()) << "no zero mark of the encoder counts";
    axis.edge(kInput, true, 0.25);
    axis.turn(200);
    EXPECT_EQ(axis.position.measured_shown(), 3450);
  }
}

TEST(Probe, IsMeasuredWhereItsEdgeLiesInTheSlice) {
  SensedAxis axis;
  axis.position.settings.units_per_load = 333;
  axis.position.settings.probe_terminal_1[0] = kTerminal;
  axis.position.inputs.evaluate_probe[0] = true;
  axis.turn(1000);
  axis.edge(kInput, true, 0.5);
  axis.turn(3);
  EXPECT_TRUE(axis.position.measured_valid());
  EXPECT_NEAR(axis.position.measured(), 333.4995, 1e-9);
  EXPECT_EQ(axis.position.measured_shown(), 333);
  EXPECT_EQ(axis.position.measured_of(0), 333.0);
}

TEST(Probe, IsTheOneOfItsSelectionAndEdge) {
  SensedAxis axis;
  axis.position.settings.direct_probe_2 = kTerminal;
  axis.position.inputs.second_probe[0] = axis.position.inputs.falling_edge[0] = true;
  axis.position.inputs.evaluate_probe[0] = true;
  axis.stay();
  axis.position.inputs.second_probe[0] = axis.position.inputs.falling_edge[0] = false;
  axis.edge(kInput, true, 0.5);
  axis.turn(100);
  EXPECT_TRUE(axis.position.referencing_active()) << "the edge is that of the beginning";
  axis.edge(kInput, false, 0.5);
  axis.turn(100);
  EXPECT_EQ(axis.position.measured_shown(), 150);
}

TEST(Probe, IsMeasuredOnceARequest) {
  SensedAxis axis;
  axis.position.settings.probe_terminal_1[0] = kTerminal;
  axis.position.inputs.evaluate_probe[0] = true;
  axis.stay();
  for (int i = 0; i < 2; ++i) {
    axis.edge(kInput, true, 1.0);
    axis.turn(100);
  }
  EXPECT_EQ(axis.position.measured_shown(), 100);
  axis.position.inputs.evaluate_probe[0] = false;
  axis.stay();
  axis.position.inputs.evaluate_probe[0] = true;
  axis.stay();
  axis.edge(kInput, true, 1.0);
  axis.turn(100);
  EXPECT_EQ(axis.position.measured_shown(), 300);
}

TEST(Probe, NeedsATerminal) {
  struct Case {
    std::int32_t direct;
    double value;
  };
  for (const Case& bad : {Case{0, 6.0}, Case{11, 50001.0}, Case{18, 50001.0}, Case{9, 4100.0}, Case{51, 4100.0}}) {
    SensedAxis axis;
    axis.position.settings.direct_probe_1 = bad.direct;
    axis.position.inputs.evaluate_probe[0] = true;
    axis.stay();
    EXPECT_TRUE(axis.position.probe_impossible()) << bad.direct;
    EXPECT_EQ(axis.position.probe_refusal(), bad.value);
    EXPECT_FALSE(axis.position.referencing_active());
    axis.position.inputs.evaluate_probe[0] = false;
    axis.stay();
    EXPECT_FALSE(axis.position.probe_impossible());
  }
}

TEST(Capture, IsInterruptedByWhatMakesThePositionUnknown) {
  using Disturb = void (*)(SensedAxis&);
  for (const Disturb disturb :
       {Disturb{[](SensedAxis& axis) { axis.slice.encoder_faulty = true; }},
        Disturb{[](SensedAxis& axis) { axis.position.inputs.set_position[0] = true; }},
        Disturb{[](SensedAxis& axis) { axis.position.inputs.evaluate_probe[0] = true; }}}) {
    SensedAxis axis;
    axis.position.settings.probe_terminal_1[0] = kTerminal;
    axis.turn(500);
    axis.position.inputs.search_mark[0] = true;
    axis.stay();
    disturb(axis);
    axis.stay();
    EXPECT_TRUE(axis.position.interrupted());
    EXPECT_FALSE(axis.position.referencing_active());
    axis.turn(1000);
    EXPECT_FALSE(axis.position.measured_valid());
    axis.position.inputs.search_mark[0] = axis.position.inputs.evaluate_probe[0] = false;
    axis.stay();
    EXPECT_FALSE(axis.position.interrupted());
  }
}

TEST(Capture, ThatIsTakenBackIsToldForACycle) {
  SensedAxis axis;
  axis.position.inputs.search_mark[0] = true;
  axis.stay();
  axis.position.inputs.search_mark[0] = false;
  axis.stay();
  axis.stay();
  EXPECT_TRUE(axis.position.interrupted());
  axis.position.begin_cycle();
  axis.stay();
  EXPECT_FALSE(axis.position.interrupted());
}

TEST(InputEdges, TellTheLevelAtAnInstant) {
  InputEdges edges;
  EXPECT_FALSE(edges.level_at(0, 0.5));
  edges.rising[0] = 0.3;
  edges.levels = 1;
  EXPECT_FALSE(edges.level_at(0, 0.2));
  EXPECT_TRUE(edges.level_at(0, 0.3));
  edges.falling[0] = 0.7;
  edges.levels = 0;
  EXPECT_FALSE(edges.level_at(0, 0.2));
  EXPECT_TRUE(edges.level_at(0, 0.5));
  EXPECT_FALSE(edges.level_at(0, 0.8));
  edges.rising[0] = 0.9;
  edges.levels = 1;
  EXPECT_TRUE(edges.level_at(0, 0.6)) << "it fell later";
  EXPECT_FALSE(edges.level_at(0, 0.8));
  EXPECT_TRUE(edges.level_at(0, 0.95));
}

}  // namespace
}  // namespace drive
