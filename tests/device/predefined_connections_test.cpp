#include <array>

#include <gtest/gtest.h>

#include "tests/device/process_data_unit.hpp"

namespace device {
namespace {

constexpr std::int64_t kInvalid = 0x80000000;
constexpr double kPredefined = 1.0, kFree = 2.0;

std::vector<std::int64_t> pdo_parameters(ProcessDataUnit& unit) {
  std::vector<std::int64_t> values;
  for (const canopen::Entry& entry : unit.dictionary.entries())
    if (pdo::record_of(entry.index)) values.push_back(unit.dictionary.stored(entry));
  return values;
}

/// The PDOs of axis @p axis in another way than the predefined one.
void rearrange(ProcessDataUnit& unit, std::uint16_t axis) {
  const auto on_axis = [=](unsigned index) { return static_cast<std::uint16_t>(index + 0x40U * (axis - 1U)); };
  const std::int64_t mode = axis == 1 ? 0x60610008 : 0x68610008;
  ASSERT_EQ(unit.write(on_axis(0x1400), 1, kInvalid), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1600), 0, 0), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1404), 1, 0x420 + axis), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1803), 1, kInvalid), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1803), 2, 1), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1803), 3, 100), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1A03), 0, 0), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1A03), 1, mode), 0U);
  ASSERT_EQ(unit.write(on_axis(0x1A03), 0, 1), 0U);
}

TEST(PredefinedConnections, AreTakenOverAgain) {
  ProcessDataUnit unit{2};
  unit.start();
  const auto initial = pdo_parameters(unit);
  rearrange(unit, 1);
  rearrange(unit, 2);
  ASSERT_NE(pdo_parameters(unit), initial);

  EXPECT_TRUE(unit.set_parameter(2, 8741, 0, 1.0));
  EXPECT_NE(pdo_parameters(unit), initial) << "axis 2 is not concerned";
  EXPECT_TRUE(unit.set_parameter(3, 8741, 0, 1.0));
  EXPECT_EQ(pdo_parameters(unit), initial);
  EXPECT_EQ(unit.write(0x1604, 1, 0x58000010), 0U);
  EXPECT_EQ(unit.read(0x1604, 0), 1) << "the count follows the entries as in a new unit";
}

TEST(PredefinedConnections, LeaveAFreeMappingAlone) {
  ProcessDataUnit unit{1};
  unit.start();
  rearrange(unit, 1);
  const auto free = pdo_parameters(unit);

  ASSERT_TRUE(unit.set_parameter(2, 8744, 0, kFree));
  EXPECT_TRUE(unit.set_parameter(2, 8741, 0, 1.0));
  EXPECT_EQ(pdo_parameters(unit), free);
  ASSERT_TRUE(unit.set_parameter(2, 8744, 0, kPredefined));
  EXPECT_EQ(pdo_parameters(unit), free) << "p8744 alone changes nothing";
}

TEST(PredefinedConnections, AreNotTakenOverInOperational) {
  ProcessDataUnit unit{1};
  unit.start();
  rearrange(unit, 1);
  const auto free = pdo_parameters(unit);
  unit.command(canopen::NmtCommand::Start);

  EXPECT_FALSE(unit.set_parameter(2, 8741, 0, 1.0));
  EXPECT_EQ(pdo_parameters(unit), free);
  EXPECT_EQ(unit.alarms(), std::vector<std::uint16_t>{8754});
}

TEST(PredefinedConnections, LeaveAPdoInvalidWhoseIdentifierAnotherAxisHas) {
  ProcessDataUnit unit{2};
  unit.start();
  ASSERT_EQ(unit.write(0x1401, 1, kInvalid), 0U);
  ASSERT_EQ(unit.write(0x1440, 1, 0x305), 0U);

  EXPECT_FALSE(unit.set_parameter(2, 8741, 0, 1.0));
  EXPECT_EQ(unit.read(0x1400, 1), 0x205);
  EXPECT_NE(unit.read(0x1401, 1) & kInvalid, 0);
  EXPECT_EQ(unit.read(0x1402, 1), 0x405);
}

TEST(PdoLimit, MakesWhatNoMasterHasWrittenInvalidInTheOrderOfNumbers) {
  ProcessDataUnit unit{8};
  for (std::uint16_t axis = 0; axis < 8; ++axis)
    for (std::uint16_t place = 0; place < 8; ++place)
      unit.dictionary.set(**unit.dictionary.find(static_cast<std::uint16_t>(0x1400 + 0x40 * axis + place), 1),
                          0x210 + 8 * axis + place);

  unit.unit_process_data.take_over(UnitProcessData::WiredBy::Before);
  unit.start();

  std::vector<std::uint16_t> valid;
  for (std::uint16_t number = 0; number < 0x200; ++number)
    if (unit.dictionary.contains(static_cast<std::uint16_t>(0x1400 + number)) &&
        (unit.read(static_cast<std::uint16_t>(0x1400 + number), 1) & kInvalid) == 0)
      valid.push_back(number);
  EXPECT_EQ(valid.size(), 25U);
  EXPECT_EQ(valid.back(), 0xC0) << "eight each of three axes and one of the fourth";
  EXPECT_EQ(unit.alarms(), std::vector<std::uint16_t>{8758});
  EXPECT_EQ(unit.parameter(1, 8742, 0), 0.0);
}

TEST(PdoAlarms, EndWithP2111OfAnyDriveObject) {
  constexpr std::array<std::uint8_t, 3> kObjects{1, 2, 3};
  for (const std::uint8_t object : kObjects) {
    ProcessDataUnit unit{2};
    unit.start();
    ASSERT_EQ(unit.write(0x1600, 1, 0x60400010), 0x08000022U);
    ASSERT_EQ(unit.alarms(), std::vector<std::uint16_t>{8757});

    EXPECT_FALSE(unit.unit.write(object, 2111, 0, {drive::DataType::U16, 1}));
    EXPECT_EQ(unit.alarms(), std::vector<std::uint16_t>{8757});
    EXPECT_TRUE(unit.unit.write(object, 2111, 0, {drive::DataType::U16, 0}));
    for (const std::uint8_t each : kObjects) EXPECT_TRUE(unit.unit.object(each)->messages().alarms().empty());
  }
}

}  // namespace
}  // namespace device
