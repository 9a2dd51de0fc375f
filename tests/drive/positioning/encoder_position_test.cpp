// What encoder 1 has by itself: index 1 of p2508 to p2516 and r2521 to r2523, r2527.
#include <numbers>

#include <gtest/gtest.h>

#include "tests/drive/positioning/sensed_axis.hpp"

namespace drive {
namespace {

TEST(EncoderPosition, HasInputsOfItsOwn) {
  SensedAxis axis;
  axis.position.inputs.offset[1] = 5.0;
  axis.position.inputs.correction[1] = 100.0;
  axis.position.inputs.correct[1] = true;
  axis.position.settings.probe_terminal_1[0] = 1;
  axis.position.inputs.evaluate_probe[1] = true;
  axis.turn(10);
  EXPECT_EQ(axis.shown(), 10);
  EXPECT_EQ(axis.position.shown_of(1), 115.0);
  EXPECT_EQ(axis.position.encoder_status(0), 0x0003);
  EXPECT_EQ(axis.position.status(), 0x0001);
  axis.edge(0, true, 0.5);
  axis.turn(10);
  EXPECT_EQ(axis.position.measured_of(1), 120.0);
  EXPECT_EQ(axis.position.measured_of(0), 0.0);
  EXPECT_EQ(axis.position.encoder_status(0), 0x0005);
  EXPECT_EQ(axis.position.encoder_status(1), 0);
  axis.position.inputs.set_position[1] = true;
  axis.position.inputs.setting_value[1] = -7.0;
  axis.turn(10);
  EXPECT_EQ(axis.position.shown_of(1), -7.0);
  EXPECT_TRUE(axis.position.encoder_1_held());
  EXPECT_FALSE(axis.position.is_held());
}

TEST(EncoderPosition, GoesOnWithoutAPositionControl) {
  SensedAxis axis;
  axis.position.settings.encoder = 0;
  axis.slice.modulo_range = 360;
  axis.slice.speed = 2.0 * std::numbers::pi;
  axis.turn(370);
  EXPECT_EQ(axis.position.shown_of(1), 10.0);
  EXPECT_EQ(axis.position.velocity_of(0), 0.0);
  EXPECT_NEAR(axis.position.velocity_of(1), 1000.0, 1e-9);
  EXPECT_EQ(axis.position.encoder_status(0), 0x0001);
  axis.slice.encoder_faulty = true;
  axis.stay();
  EXPECT_TRUE(axis.position.encoder_1_faulty());
  EXPECT_FALSE(axis.position.encoder_faulty()) << "it has none";
}

TEST(EncoderPosition, SaysWhatItsProbeLacks) {
  SensedAxis axis;
  axis.position.inputs.evaluate_probe[1] = true;
  axis.stay();
  EXPECT_TRUE(axis.position.encoder_1_probe_impossible());
  EXPECT_EQ(axis.position.encoder_1_probe_refusal(), 6.0);
  axis.position.inputs.search_mark[1] = true;
  axis.position.inputs.evaluate_probe[1] = false;
  axis.stay();
  axis.position.inputs.search_mark[1] = false;
  axis.stay();
  EXPECT_TRUE(axis.position.encoder_1_interrupted());
  EXPECT_FALSE(axis.position.interrupted());
}

}  // namespace
}  // namespace drive
