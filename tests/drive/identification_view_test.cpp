// The measurements of a motor as a person looks at them.
#include "drive/explain/views/identification_view.hpp"

#include <algorithm>

#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

const IdentifiedValue& result(const IdentificationView& view, std::uint16_t number) {
  static const IdentifiedValue kNone{};
  const auto found = std::ranges::find_if(
      view.results, [=](const IdentifiedValue& value) { return value.row->number == number; });
  if (found != view.results.end()) return *found;
  ADD_FAILURE() << "no result r" << number;
  return kNone;
}

TEST(TheIdentification, GoesFromNothingOverMeasuringToResults) {
  MeasuringAxis drive{real_axis("1fk7063", kOther)};
  IdentificationView view = identification_of(drive.axis);
  EXPECT_EQ(view.phase, IdentificationPhase::Idle);
  EXPECT_EQ(view.selected, "none");
  EXPECT_TRUE(view.results.empty());

  ASSERT_TRUE(drive.axis.write(kP1900, 1.0));
  view = identification_of(drive.axis);
  EXPECT_EQ(view.phase, IdentificationPhase::Waiting);
  EXPECT_EQ(view.selected, "standstill (p1910), rotating (p1960)");
  EXPECT_EQ(view.text, "the next ON measures the motor at standstill");

  drive.on();
  double progress = 0.0;
  int measuring = 0;
  drive.run_until(
      [&](const Axis& axis) {
        const IdentificationView now = identification_of(axis);
        if (now.phase != IdentificationPhase::Measuring) return measuring > 0;
        ++measuring;
        EXPECT_GE(now.progress, progress) << now.text;
        EXPECT_LE(now.progress, 100.0);
        progress = now.progress;
        return false;
      },
      MeasuringAxis::kLongest);
  EXPECT_GT(progress, 50.0);
  view = identification_of(drive.axis);
  EXPECT_EQ(view.phase, IdentificationPhase::Waiting) << "for the rotating one";
  EXPECT_EQ(view.selected, "rotating (p1960)");
  EXPECT_NEAR(result(view, 1912).deviation().value(), 20.0, 3.0);
  EXPECT_NEAR(result(view, 1932).deviation().value(), -15.0, 3.0);
  EXPECT_NEAR(result(view, 1934).deviation().value(), 15.0, 3.0);
  EXPECT_FALSE(result(view, 1984).data_sheet.has_value());

  drive.on();
  drive.run_until([](const Axis& axis) { return identification_of(axis).phase == IdentificationPhase::Done; },
                  MeasuringAxis::kLongest);
  view = identification_of(drive.axis);
  EXPECT_EQ(view.selected, "none");
  EXPECT_NEAR(result(view, 1937).deviation().value(), -10.0, 3.0);
  EXPECT_GT(result(view, 1969).value, 0.0);
}

TEST(TheIdentification, ComparesAnInductionMachineByTheCircuitThatIsMeasured) {
  MeasuringAxis exact{real_axis("1ph8131")};
  exact.measure(kP1910);
  const IdentificationView view = identification_of(exact.axis);
  EXPECT_EQ(view.phase, IdentificationPhase::Done);
  for (const std::uint16_t number : std::array<std::uint16_t, 5>{1912, 1914, 1927, 1936, 1913})
    EXPECT_NEAR(result(view, number).deviation().value(), 0.0, 5.0) << number;
}

TEST(TheIdentification, SaysThatItHasFailed) {
  MeasuringAxis drive{real_axis("1fk7063")};
  ASSERT_TRUE(drive.axis.raise(7990, 4));
  EXPECT_EQ(identification_of(drive.axis).phase, IdentificationPhase::Failed);
  EXPECT_EQ(name_of(IdentificationPhase::Failed), "failed");
}

}  // namespace
}  // namespace drive
