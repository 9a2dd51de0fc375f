// What the unit tells of itself and of networks that it is not on.
#include <string>

#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

double at(WiredUnit& wired, std::uint8_t object, std::uint16_t number, std::size_t index) {
  return decode(wired.unit.read(object, number, index).value());
}

TEST(DescribedUnit, HasASerialNumberForEachAxis) {
  WiredUnit wired;
  for (const std::uint8_t axis : {kX, kY}) {
    std::string text;
    for (std::size_t i = 0; i < 16; ++i) text += static_cast<char>(at(wired, axis, 7841, i));
    EXPECT_EQ(text, "AXSIM0000000000" + std::to_string(axis));
  }
}

TEST(DescribedUnit, HasThePowerOfItsSeries) {
  WiredUnit wired;
  const double rated = wired.axis(kX).context().axis.inverter.rated_current;
  ASSERT_EQ(rated, 18.0);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(at(wired, kX, 206, i), 9.7, 1e-3);
  EXPECT_EQ(wired.read(kX, 200), 10000.0);
}

TEST(DescribedUnit, HasALocallyAdministeredAddress) {
  WiredUnit wired;
  const auto first = static_cast<unsigned>(at(wired, kUnit, 8935, 0));
  EXPECT_EQ(first & 0x03U, 0x02U) << "locally administered, of one station";
}

TEST(DescribedUnit, FindsParametersOfFiveDigitsByName) {
  ASSERT_NE(find_parameter(ObjectKind::ControlUnit, "r61000"), nullptr);
  EXPECT_EQ(find_parameter(ObjectKind::ControlUnit, "r61001")->count, 4);
  EXPECT_EQ(find_parameter(ObjectKind::ControlUnit, "p61000"), nullptr);
  EXPECT_EQ(find_parameter(ObjectKind::ControlUnit, "r061000"), nullptr);
  EXPECT_EQ(find_parameter(ObjectKind::ControlUnit, "r00002"), nullptr);
  EXPECT_EQ(find_parameter(ObjectKind::ControlUnit, "r99999"), nullptr);
}

TEST(DescribedUnit, TakesOnlyValuesThatExist) {
  WiredUnit wired;
  for (const double mode : {0.0, 1.0, 4.0, 6.0, 14.0, 16.0, 26.0})
    EXPECT_EQ(wired.write(kX, 1210, mode), std::nullopt) << mode;
  for (const double mode : {2.0, 5.0, 15.0, 25.0})
    EXPECT_EQ(wired.write(kX, 1210, mode), RefusalReason::IllegalValue) << mode;
  for (const double nodes : {8.0, 12.0, 16.0, 64.0}) EXPECT_EQ(wired.write(kUnit, 8811, nodes), std::nullopt);
  EXPECT_EQ(wired.write(kUnit, 8811, 32.0), RefusalReason::IllegalValue);
  for (const double firmware : {2.0, 5.0, 99.0, 1.0}) EXPECT_EQ(wired.write(kUnit, 8835, firmware), std::nullopt);
  EXPECT_EQ(wired.write(kUnit, 8835, 6.0), RefusalReason::IllegalValue);
}

TEST(DescribedUnit, ActivatesNoAddress) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kUnit, 8921, 192.0), std::nullopt);
  for (const std::uint16_t number : {std::uint16_t{8925}, std::uint16_t{8945}}) {
    EXPECT_EQ(wired.write(kUnit, number, 2.0), std::nullopt);
    EXPECT_EQ(wired.read(kUnit, number), 0.0);
  }
  EXPECT_EQ(wired.read(kUnit, 8921), 192.0);
  EXPECT_EQ(wired.read(kUnit, 8931), 0.0);
}

TEST(DescribedUnit, ShowsTheStateOfItsBoard) {
  WiredUnit wired;
  auto& state = wired.unit.object(kUnit)->process_data().interface_state;
  state = {true, false, false};
  EXPECT_EQ(wired.read(kUnit, 8854), 5.0);
  state = {true, false, true};
  EXPECT_EQ(wired.read(kUnit, 8854), 6.0);
  state = {false, false, true};
  EXPECT_EQ(wired.read(kUnit, 8854), 255.0);
}

}  // namespace
}  // namespace drive
