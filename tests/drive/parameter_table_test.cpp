#include "drive/parameter_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace drive {
namespace {

using Reason = ParameterError::Reason;

AxisParameters commissioned() {
  return commissioned_parameters({}, {});
}

double value(const AxisParameters& parameters, std::uint16_t number) {
  return read(parameters, number).value();
}

TEST(ParameterTable, HasTheFactoryValuesOfTheListAndTheComputedOnesOfTheMotor) {
  const AxisParameters parameters = commissioned();

  EXPECT_EQ(value(parameters, 1120), 10.0);
  EXPECT_EQ(value(parameters, 1121), 10.0);
  EXPECT_EQ(value(parameters, 1135), 0.0);
  EXPECT_EQ(value(parameters, 1226), 20.0);
  EXPECT_EQ(value(parameters, 1227), 4.0);
  EXPECT_EQ(value(parameters, 1228), 0.01);
  EXPECT_EQ(value(parameters, 2161), 5.0);
  EXPECT_EQ(value(parameters, 2163), 90.0);
  EXPECT_EQ(value(parameters, 2164), 2.0);
  EXPECT_EQ(value(parameters, 2166), 200.0);
  EXPECT_EQ(value(parameters, 8641), 3.0);
  EXPECT_EQ(value(parameters, 8791), -1.0);
  EXPECT_EQ(value(parameters, 1082), 7200.0);
  EXPECT_EQ(value(parameters, 1520), 35.0);
  EXPECT_EQ(value(parameters, 1521), -35.0);
  EXPECT_EQ(value(parameters, 2000), 3000.0);
  EXPECT_EQ(value(parameters, 2003), 7.3);
  EXPECT_EQ(value(parameters, 333), 7.3);
  EXPECT_EQ(value(parameters, 408), 2048.0);
  EXPECT_EQ(value(parameters, 418), 11.0);
}

TEST(ParameterTable, ComputesTheSpeedControllerFromTheTotalInertia) {
  const double alone = value(commissioned(), 1460);
  const double loaded = value(commissioned_parameters({}, {.inertia = 0.00151}), 1460);

  EXPECT_NEAR(loaded, 2.0 * alone, 1e-6);
  EXPECT_GT(value(commissioned(), 1462), 5.0);
  EXPECT_LT(value(commissioned(), 1462), 50.0);
}

TEST(ParameterTable, KeepsEveryValueInSiUnits) {
  AxisParameters parameters = commissioned();

  ASSERT_TRUE(write(parameters, 1082, 3000.0));
  ASSERT_TRUE(write(parameters, 1462, 20.0));
  ASSERT_TRUE(write(parameters, 2166, 100.0));

  EXPECT_NEAR(parameters.maximum_speed, 314.159265, 1e-6);
  EXPECT_NEAR(parameters.speed_integral_time, 0.020, 1e-12);
  EXPECT_NEAR(parameters.target_off_delay, 0.1, 1e-12);
}

TEST(ParameterTable, TakesBothLimitsOfEveryWritableParameterAndNothingBeyond) {
  for (const ParameterRow& row : parameter_rows()) {
    if (row.access == Access::ReadOnly) continue;
    AxisParameters parameters = commissioned();
    const double beyond = std::max(1.0, 1e-6 * std::abs(row.maximum));

    ASSERT_TRUE(write(parameters, row.number, row.minimum)) << row.text;
    EXPECT_NEAR(value(parameters, row.number), row.minimum, 1e-6 * std::abs(row.minimum)) << row.text;
    ASSERT_TRUE(write(parameters, row.number, row.maximum)) << row.text;
    EXPECT_NEAR(value(parameters, row.number), row.maximum, 1e-6 * std::abs(row.maximum)) << row.text;
    EXPECT_EQ(write(parameters, row.number, row.minimum - beyond).error().reason, Reason::BelowMinimum)
        << row.text;
    EXPECT_EQ(write(parameters, row.number, row.maximum + beyond).error().reason, Reason::AboveMaximum)
        << row.text;
    EXPECT_NEAR(value(parameters, row.number), row.maximum, 1e-6 * std::abs(row.maximum)) << row.text;
  }
}

TEST(ParameterTable, RefusesWhatIsNoNumber) {
  AxisParameters parameters = commissioned();

  EXPECT_FALSE(write(parameters, 1120, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(write(parameters, 8791, 0.5).error().reason, Reason::NotAnInteger);
}

TEST(ParameterTable, RefusesUnknownAndReadOnlyParameters) {
  AxisParameters parameters = commissioned();

  EXPECT_EQ(read(parameters, 1119).error().reason, Reason::Unknown);
  EXPECT_EQ(write(parameters, 1119, 1.0).error().reason, Reason::Unknown);
  EXPECT_EQ(write(parameters, 333, 1.0).error().reason, Reason::ReadOnly);
}

TEST(ParameterTable, FindsParametersByTheirWrittenName) {
  ASSERT_NE(find_parameter("p1120"), nullptr);
  EXPECT_EQ(find_parameter("p1120")->number, 1120);
  ASSERT_NE(find_parameter("r0333"), nullptr);
  EXPECT_EQ(find_parameter("r0333")->number, 333);
  for (const char* text : {"1120", "p0333", "P1120", "p1120 ", "", "p99999"})
    EXPECT_EQ(find_parameter(text), nullptr);
}

TEST(ParameterTable, SaysWhatWasWrongAndWhatIsAllowed) {
  AxisParameters parameters = commissioned();

  EXPECT_EQ(message(write(parameters, 1120, 1e6).error()), "p1120: above the maximum of 999999 s");
  EXPECT_EQ(message(write(parameters, 2000, 1.0).error()), "p2000: below the minimum of 6 rpm");
  EXPECT_EQ(message(write(parameters, 8641, 1.5).error()), "p8641: expected an integer 0..3");
  EXPECT_EQ(message(write(parameters, 333, 1.0).error()), "r0333: read only");
  EXPECT_EQ(message(write(parameters, 1, 1.0).error()), "p0001: no such parameter");
}

}  // namespace
}  // namespace drive
