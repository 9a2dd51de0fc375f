#include <gtest/gtest.h>

#include "tests/drive/test_drive_unit.hpp"

namespace drive {
namespace {

/// A layer above that keeps what it is asked and can refuse it.
struct RecordingHost final : ParameterHost {
  std::optional<Refusal> answer;
  std::uint16_t number = 0;
  double value = 0.0;

  std::optional<Refusal> on_parameter(const DriveObject&, const ParameterRow& row, std::size_t,
                                      double asked) noexcept override {
    number = row.number;
    value = asked;
    return answer;
  }
  std::optional<double> value_of(const DriveObject& object, const ParameterRow& row,
                                 std::size_t index) const noexcept override {
    if (row.number != shown) return std::nullopt;
    return 100.0 * object.number() + static_cast<double>(index);
  }

  std::uint16_t shown = 0;
};

TEST(DriveUnit, AsksTheLayerAboveForWhatThatAnswersFor) {
  RecordingHost host;
  TestUnit test{&host};

  EXPECT_FALSE(test.write(kUnit, 8699, 50.0));
  EXPECT_EQ(host.number, 8699);
  EXPECT_EQ(test.read(kUnit, 8699), 50.0);

  host.answer = Refusal::NotNow;
  EXPECT_EQ(test.write(kUnit, 8699, 60.0), Refusal::NotNow);
  EXPECT_EQ(test.read(kUnit, 8699), 50.0);

  host.answer.reset();
  EXPECT_FALSE(test.write(kUnit, 977, 1.0));
  EXPECT_EQ(host.number, 977);
  EXPECT_EQ(host.value, 1.0);
  EXPECT_EQ(test.read(kUnit, 977), 0.0);
  test.unit.object(kUnit)->bring_in(8601, 0, 0x91);
  EXPECT_EQ(test.read(kUnit, 8601), 145.0);
}

TEST(DriveUnit, ShowsWhatTheLayerAboveSaysOfAParameterAndKeepsWhatWasWritten) {
  RecordingHost host;
  TestUnit test{&host};
  ASSERT_FALSE(test.write(kX, 8700, 5.0, 1));

  host.shown = 8700;
  EXPECT_EQ(test.read(kX, 8700, 1), 201.0);
  EXPECT_EQ(test.unit.object(kX)->kept_value(8700, 1).value(), 5.0);
  EXPECT_EQ(test.unit.object(kX)->kept_value(8700, 2).error().reason, Refusal::NoIndex);

  host.shown = 1120;  // not the layer above's to say
  EXPECT_EQ(test.read(kX, 1120), 10.0);
}

}  // namespace
}  // namespace drive
