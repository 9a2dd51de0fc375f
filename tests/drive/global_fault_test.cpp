// Faults that stop all axes of a unit, and those of one of several.
#include <array>
#include <optional>

#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"
#include "tests/drive/test_drive_unit.hpp"

namespace drive {
namespace {

constexpr double kOff1Time = 7.2;   // 1000 rpm a second
constexpr double kOff3Time = 1.44;  // 5000 rpm a second
constexpr double kOff1Slope = 1000.0;
constexpr double kOff3Slope = 5000.0;

/// Two axes that turn at 1000 rpm, side by side on their DC link.
struct TwoAxes {
  DriveUnit unit{{.axes = {AxisConfiguration{}, AxisConfiguration{}}}};
  std::array<std::optional<Setpoints>, 2> setpoints{};

  explicit TwoAxes(std::array<int, 2> p8641 = {3, 3}) {
    for (Axis& axis : unit.axes()) {
      EXPECT_TRUE(axis.write(8641, p8641[axis.axis_number() - 1]));
      EXPECT_TRUE(axis.write(1120, 0.0));
      EXPECT_TRUE(axis.write(1121, kOff1Time));
      EXPECT_TRUE(axis.write(1135, kOff3Time));
    }
    for (const unsigned word : {0x0006U, 0x0006U, 0x0007U, 0x000FU}) send(static_cast<std::uint16_t>(word), 1);
    send(0x000F, 250);
  }
  void send(std::uint16_t controlword, int cycles) {
    setpoints.fill(Setpoints{.controlword = controlword, .speed = 1000.0 * kRpm});
    for (int i = 0; i < cycles; ++i) unit.cycle(setpoints, TestAxis::kCycle);
  }
  State state(std::size_t axis) const { return unit.axes()[axis].actual().state; }
  double rpm(std::size_t axis) const { return unit.axes()[axis].actual().speed / kRpm; }
};

TEST(GlobalFault, StopsEveryAxisAsItsOwnP8641Says) {
  struct Option {
    int value;
    State state;
    double rpm;  ///< after 100 ms; negative = it coasts
  };
  constexpr std::array kOptions{
      Option{0, State::OperationEnabled, 1000.0}, Option{1, State::FaultReactionActive, 1000.0 - kOff1Slope * 0.1},
      Option{2, State::Fault, -1.0}, Option{3, State::FaultReactionActive, 1000.0 - kOff3Slope * 0.1}};
  for (const Option& x : kOptions)
    for (const Option& y : kOptions) {
      TwoAxes two{{x.value, y.value}};

      ASSERT_TRUE(two.unit.raise(kControlUnitNumber, 8700, 2));
      two.send(0x000F, 25);

      for (const std::size_t axis : {0U, 1U}) {
        const Option& expected = axis == 0 ? x : y;
        EXPECT_EQ(two.state(axis), expected.state) << "p8641 = " << expected.value;
        if (expected.rpm >= 0.0) {
          EXPECT_NEAR(two.rpm(axis), expected.rpm, 30.0) << "p8641 = " << expected.value;
        }
        if (expected.rpm < 0.0) {
          EXPECT_GT(two.rpm(axis), 800.0);
        }
        EXPECT_EQ(two.unit.axes()[axis].messages().faults().size(), 1u);
      }
    }
}

TEST(GlobalFault, StopsBothAxesAndAnotherOneOnlyItsOwn) {
  TwoAxes two;

  ASSERT_TRUE(two.unit.raise(kFirstAxisNumber, 7220));
  two.send(0x000F, 25);
  EXPECT_EQ(two.state(0), State::FaultReactionActive);
  EXPECT_EQ(two.state(1), State::OperationEnabled);
  EXPECT_NEAR(two.rpm(1), 1000.0, 5.0);

  ASSERT_TRUE(two.unit.raise(kFirstAxisNumber + 1, 8702));
  two.send(0x000F, 25);
  for (const std::size_t axis : {0U, 1U}) EXPECT_EQ(two.state(axis), State::FaultReactionActive);
  EXPECT_NEAR(two.rpm(0), 900.0 - 500.0, 30.0) << "sharpened from OFF1 to OFF3";
  EXPECT_NEAR(two.rpm(1), 500.0, 30.0);
  two.send(0x000F, 250);

  for (const std::size_t axis : {0U, 1U}) EXPECT_EQ(two.state(axis), State::Fault);
  EXPECT_TRUE(two.unit.acknowledge());
  for (const std::size_t axis : {0U, 1U}) EXPECT_EQ(two.state(axis), State::SwitchOnDisabled);
}

}  // namespace
}  // namespace drive
