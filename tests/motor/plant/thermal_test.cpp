#include "motor/plant/machine/thermal.hpp"

#include <gtest/gtest.h>

#include "motor/plant/power_unit.hpp"

namespace motor {
namespace {

constexpr ThermalData kData{};

TEST(MotorThermal, BeginsAtTheTemperatureOfTheAir) {
  const MotorThermal motor{kData};

  EXPECT_EQ(motor.winding(), 20.0);
  EXPECT_EQ(motor.frame(), 20.0);
}

TEST(MotorThermal, EndsWhereTheHeatThatComesInGoesOut) {
  MotorThermal motor{kData};

  motor.step(100.0 * 3600.0, 100.0, 20.0);

  EXPECT_NEAR(motor.frame(), 20.0 + 120.0 / kData.frame_to_ambient, 1e-9);
  EXPECT_NEAR(motor.winding(), motor.frame() + 100.0 / kData.winding_to_frame, 1e-9);
}

TEST(MotorThermal, TakesTheHeatThatDoesNotLeaveIt) {
  MotorThermal motor{kData};

  motor.step(0.01, 1000.0, 500.0);

  const double stored =
      kData.winding_capacity * (motor.winding() - 20.0) + kData.frame_capacity * (motor.frame() - 20.0);
  EXPECT_NEAR(stored, 15.0, 1e-3);
}

TEST(MotorThermal, CoolsForAnHourInOneStepAsInMany) {
  MotorThermal once{kData};
  MotorThermal often{kData};
  once.start(120.0);
  often.start(120.0);

  once.step(3600.0, 0.0, 0.0);
  for (int i = 0; i < 360'000; ++i) often.step(0.01, 0.0, 0.0);

  EXPECT_NEAR(once.winding(), often.winding(), 1e-7);
  EXPECT_NEAR(once.frame(), often.frame(), 1e-7);
}

TEST(OverloadModel, ReachesItsRiseUnderTheReferenceCurrent) {
  OverloadModel model{{.reference_current = 8.0, .time_constant = 2400.0, .rise = 80.0, .ambient = 20.0}};

  model.step(2400.0, 64.0);
  EXPECT_NEAR(model.utilisation(), 0.6321, 1e-4);
  model.step(100.0 * 3600.0, 64.0);

  EXPECT_NEAR(model.utilisation(), 1.0, 1e-12);
  EXPECT_NEAR(model.temperature(), 100.0, 1e-9);
}

TEST(PowerUnit, LosesNothingWithThePulsesOff) {
  const PowerUnit unit{InverterData{}};

  EXPECT_EQ(unit.losses(9.0, false), 0.0);
  EXPECT_DOUBLE_EQ(unit.losses(9.0, true), 30.0 + 6.0 * 9.0 + 0.08 * 81.0);
}

TEST(PowerUnit, TakesItsDropsFromTheVoltageOfEachPhase) {
  EXPECT_TRUE(PowerUnit{InverterData{}}.inverter().is_ideal());
  const PowerUnit unit{{.dead_time = 1.5e-6, .forward_voltage = 0.8, .pulse_frequency = 8e3}};
  EXPECT_FALSE(unit.inverter().is_ideal());

  // Phase U against V and W: 2/3 (d + d/2 + d/2).
  const double drop = 1.5e-6 * 8e3 * 560.0 + 0.8;
  EXPECT_NEAR(unit.inverter().distortion({5.0, 0.0}, 560.0).re, 4.0 / 3.0 * drop, 1e-12);
  EXPECT_NEAR(unit.inverter().distortion({5.0, 0.0}, 560.0).im, 0.0, 1e-12);
  EXPECT_EQ(unit.inverter().distortion({}, 560.0), SpaceVector{});
}

TEST(PowerUnit, IsOverloadedSoonerTheHigherTheCurrent) {
  const InverterData data{};
  PowerUnit unit{data};

  // Twice the rated current: 1 = 4 (1 - e^(-t/12 s)) after 3.45 s.
  unit.step(3.4, 4.0 * data.rated_current * data.rated_current);
  EXPECT_LT(unit.overload(), 1.0);
  unit.step(0.1, 4.0 * data.rated_current * data.rated_current);

  EXPECT_GT(unit.overload(), 1.0);
}

TEST(PowerUnit, HasItsHottestPlaceInTheChip) {
  const InverterData data{};
  PowerUnit unit{data};

  unit.step(10.0 * 3600.0, data.rated_current * data.rated_current);

  EXPECT_NEAR(unit.heat_sink_temperature(), data.ambient + data.heat_sink_rise, 1e-9);
  EXPECT_NEAR(unit.chip_temperature(), data.ambient + data.heat_sink_rise + data.chip_rise, 1e-9);
}

}  // namespace
}  // namespace motor
