#include "tests/motor/reference/reference_file.hpp"

#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace reference {
namespace {

/// The reference itself, with @p change added to the current in every row.
Table shifted(const File& file, double change) {
  Table table{{"t_s", "i_A"}};
  for (std::size_t i = 0; i < file.table.rows(); ++i)
    table.append({file.table.abscissa()[i], file.table.column("i_A")[i] + change});
  return table;
}

TEST(ReferenceFile, AgreesWithItself) {
  const File file{"i2_pm_pulse"};

  const auto deviations = compare(file, file.table);

  ASSERT_EQ(deviations.size(), 2U);
  EXPECT_EQ(deviations[1].column, "i_A");
  EXPECT_EQ(deviations[1].max_absolute, 0.0);
  EXPECT_TRUE(deviations[1].within_target);
}

TEST(ReferenceFile, MeasuresInPerCentOfTheRangeAndHoldsAgainstBothBands) {
  const File file{"i2_pm_pulse"};
  const double range = file.number("/ranges/i_A/1") - file.number("/ranges/i_A/0");

  const Deviation close = compare(file, shifted(file, 0.0009 * range)).front();
  const Deviation far = compare(file, shifted(file, 0.006 * range)).front();

  EXPECT_NEAR(close.max_percent, 0.09, 1e-9);
  EXPECT_NEAR(close.rms_percent, 0.09, 1e-9);
  EXPECT_TRUE(close.within_must);
  EXPECT_FALSE(close.within_target);
  EXPECT_FALSE(far.within_must);
}

TEST(ReferenceFile, IsNotFooledByWhatIsNotANumber) {
  const File file{"i2_pm_pulse"};

  Table ours{{"t_s", "i_A"}};
  for (std::size_t i = 0; i < file.table.rows(); ++i) {
    const double value = i == 7 ? std::numeric_limits<double>::quiet_NaN() : file.table.column("i_A")[i];
    ours.append({file.table.abscissa()[i], value});
  }

  const Deviation deviation = compare(file, ours).front();

  EXPECT_FALSE(deviation.within_must);
  EXPECT_FALSE(deviation.within_target);
}

TEST(ReferenceFile, InterpolatesBetweenOurRowsAndSortsThem) {
  const File file{"h2_im_torque_slip"};
  Table ours{{"slip", "w_M_rad_s"}};
  const double synchronous = 2.0 * std::numbers::pi * 50.0 / 2.0;
  for (const double slip : {-0.3, 1.0, 0.2}) ours.append({slip, synchronous * (1.0 - slip)});

  EXPECT_LT(compare(file, ours).front().max_percent, 1e-6);
}

TEST(ReferenceFile, RefusesUnknownColumnsAndTablesThatEndEarly) {
  const File file{"i2_pm_pulse"};
  Table unknown{{"t_s", "i_rms_A"}};
  Table early{{"t_s", "i_A"}};
  early.append({0.0, 0.0});

  EXPECT_THROW(compare(file, unknown), std::runtime_error);
  EXPECT_THROW(compare(file, early), std::runtime_error);
  EXPECT_THROW(File{"no_such_file"}, std::runtime_error);
}

}  // namespace
}  // namespace reference
