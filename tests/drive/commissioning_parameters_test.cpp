// Parameters that commissioning notes name beside those of motor and control.
#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/wired_axis.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

struct Listed {
  std::uint16_t number;
  DataType type;
  Range limits;
  double factory;
};
constexpr std::array kListed{
    Listed{205, DataType::I16, {0.0, 7.0}, 0.0},           Listed{344, DataType::F32, {0.0, 50000.0}, 0.0},
    Listed{353, DataType::F32, {0.0, 1000000.0}, 0.0},     Listed{500, DataType::I16, {100.0, 102.0}, 100.0},
    Listed{1216, DataType::F32, {0.0, 10000.0}, 100.0},    Listed{1217, DataType::F32, {0.0, 10000.0}, 100.0},
    Listed{1967, DataType::F32, {1.0, 400.0}, 100.0},      Listed{2098, DataType::U16, {0.0, 65535.0}, 0.0},
    Listed{2900, DataType::F32, {-10000.0, 10000.0}, 0.0}, Listed{2901, DataType::F32, {-10000.0, 10000.0}, 0.0},
};

TEST(CommissioningParameters, AreThereWithTypeLimitsAndFactoryValue) {
  const Axis axis{{}};
  for (const Listed& listed : kListed) {
    SCOPED_TRACE(listed.number);
    const PlacedRow* const placed = find_parameter(ObjectKind::Servo, listed.number);
    ASSERT_NE(placed, nullptr);
    EXPECT_EQ(placed->row->type, listed.type);
    EXPECT_EQ(placed->row->range, listed.limits);
    EXPECT_EQ(axis.read(listed.number).value(), listed.factory);
  }
}

TEST(EncoderType, IsTheNumberOfTheListOrThatOfAnotherOne) {
  struct Case {
    motor::EncoderData encoder;
    double code;
  };
  for (const Case& c :
       {Case{{}, 2002.0}, Case{{.pulses = 1024}, 9999.0}, Case{{.type = motor::EncoderType::None}, 0.0},
        Case{{.type = motor::EncoderType::Absolute}, 2051.0},
        Case{{.type = motor::EncoderType::Absolute, .revolutions = 1}, 9999.0}}) {
    AxisConfiguration configuration{};
    configuration.machine.encoder = c.encoder;
    const Axis axis{configuration};
    EXPECT_EQ(axis.read(400, 0).value(), c.code);
    EXPECT_EQ(axis.read(400, 1).value(), 0.0) << "no second encoder";
  }
}

/// An axis with a holding brake whose parameters are not its own times.
struct BrakedAxis : WiredAxis {
  BrakedAxis()
      : WiredAxis{[] {
          AxisConfiguration configuration{};
          configuration.load.brake = {.torque = 20.0, .opening_time = 0.2, .closing_time = 0.06};
          return configuration;
        }()} {}
  /// How long the pulses stay on after the shaft has come to rest (s).
  double held() {
    inputs.on = true;
    run(1.0);
    EXPECT_EQ(state(), State::OperationEnabled);
    inputs.on = false;
    double time = 0.0;
    for (; axis.actual().pulses_enabled && time < 5.0; time += kCycle) cycles(1);
    return time;
  }
};

TEST(BrakeTimes, OfANewAxisAreThoseOfItsBrake) {
  const BrakedAxis test;
  EXPECT_EQ(test.axis.read(1216).value(), 200.0);
  EXPECT_EQ(test.axis.read(1217).value(), 60.0);
}

TEST(BrakeTimes, AreForHowLongTheMotorHoldsAndTheSetpointWaits) {
  BrakedAxis test;
  const double before = test.held();
  ASSERT_TRUE(test.axis.write(1217, 560.0));
  EXPECT_NEAR(test.held() - before, 0.5, 2 * WiredAxis::kCycle);

  ASSERT_TRUE(test.axis.write(1216, 1000.0));
  test.inputs.on = true;
  test.inputs.main_setpoint = 100.0 * kRpm;
  test.run(0.9);
  EXPECT_EQ(test.word(2), 15U) << "the brake opens";
  EXPECT_EQ(test.axis.actual().speed_demand, 0.0);
  test.run(0.5);
  EXPECT_NEAR(test.rpm(), 100.0, 1.0);
}

TEST(FixedValues, AreSourcesInPercent) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 2900, 50.0), std::nullopt);
  ASSERT_EQ(wired.write(kUnit, 2901, -25.0), std::nullopt);
  wired.wire(kX, 1070, {2900, kOwnObject, 0});
  wired.wire(kX, 1155, {2901, kUnit, 0});
  wired.wire(kX, 1513, {2902, kOwnObject, 9});
  wired.cycles(2);
  const double speed = wired.read(kX, 2000) * kRpm;
  EXPECT_NEAR(inputs_of(wired.axis(kX)).main_setpoint, 0.5 * speed, 1e-6 * speed);
  EXPECT_NEAR(inputs_of(wired.axis(kX)).speed_setpoint_1, -0.25 * speed, 1e-6 * speed);
  EXPECT_NEAR(inputs_of(wired.axis(kX)).supplementary_torque_2, -0.1 * wired.read(kX, 2003), 1e-6);
  ASSERT_EQ(wired.write(kX, 2900, 200.0), std::nullopt);
  wired.cycles(2);
  EXPECT_NEAR(inputs_of(wired.axis(kX)).main_setpoint, 2.0 * speed, 1e-6 * speed);
  EXPECT_EQ(wired.read(kX, 2902, 14), -200.0);
}

}  // namespace
}  // namespace drive
