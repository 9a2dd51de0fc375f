/// What a master that knows PROFIdrive but not the drive finds out.
#include <algorithm>
#include <set>

#include "tests/profidrive/record_unit.hpp"

namespace profidrive {
namespace {

std::string text_of(const std::string& digits) {
  const Bytes bytes = bytes_of(digits);
  return {bytes.begin(), bytes.end()};
}

TEST(Description, OfAWritableFloatingPointNumberIsWhole) {
  RecordUnit unit;

  const std::string answer = unit.record("01010201 2001 0460 0000");  // p1120

  ASSERT_EQ(answer.size(), 2 * (4 + 2 + 46U));
  EXPECT_EQ(answer.substr(0, 12), "01010201412E");
  EXPECT_EQ(answer.substr(12, 16),
            "0008"
            "0001"
            "3F800000");
  EXPECT_EQ(text_of(answer.substr(12 + 28, 32)), "RFG ramp-up time");
  EXPECT_EQ(answer.substr(12 + 60, 16),
            "00000000"
            "497423F0");  // 0 to 999999 s
}

TEST(Description, GivesItsElementsOneByOne) {
  RecordUnit unit;

  EXPECT_EQ(unit.record("01010201 2001 0460 0001"), "0101020142010008");
  EXPECT_EQ(unit.record("01010201 2001 0460 0002"), "0101020106010001");
  EXPECT_EQ(unit.record("01010201 2001 0460 0003"), "0101020108013F800000");
  EXPECT_EQ(unit.record("01010201 2001 0460 0008"), "010102014301497423F0");
  EXPECT_EQ(unit.record("01010201 2001 03B1 0001"), "0101020142014206");  // r0945: read only, an array, U16
  EXPECT_EQ(unit.record("01010201 2001 03B1 0002"), "0101020106010040");
  EXPECT_EQ(unit.record("01010201 2001 003F 000B"), "01010201060107D0");  // r0063 is relative to p2000
  EXPECT_EQ(unit.record("01010201 2001 003F 000C"), "010102014201800E");
  EXPECT_EQ(unit.record("01010201 2001 0460 000B"), "0101020106010000");
}

TEST(Description, SaysWhatIsOtherThanInANewUnit) {
  RecordUnit unit;
  ASSERT_EQ(unit.record("01020201 1001 0460 0000 0801 40400000"), "01020201");

  EXPECT_EQ(unit.record("01010201 2001 0460 0001"), "0101020142011008");
}

/// The numbers that the list of parameters @p number of drive object @p object names, with those that go on from
/// it.
std::vector<std::uint16_t> listed(RecordUnit& unit, std::uint8_t object, std::uint16_t number) {
  std::vector<std::uint16_t> numbers;
  while (number != 0) {
    const drive::DriveObject& owner = *unit.device.unit().object(object);
    const std::size_t count = drive::find_parameter(owner.kind(), number)->row->count;
    for (std::size_t i = 0; i + 1 < count; ++i)
      numbers.push_back(static_cast<std::uint16_t>(owner.read(number, i).value()));
    number = static_cast<std::uint16_t>(owner.read(number, count - 1).value());
  }
  while (!numbers.empty() && numbers.back() == 0) numbers.pop_back();
  return numbers;
}

TEST(ParameterLists, NameWhatExists) {
  RecordUnit unit{{{}, {.drive = {.kind = drive::ObjectKind::Vector}}, {.drive = {.positioner = true}}}};

  for (const std::uint8_t object : std::vector<std::uint8_t>{1, 2, 3, 4}) {
    const std::vector<std::uint16_t> numbers = listed(unit, object, 980);
    std::vector<std::uint16_t> existing;
    for (unsigned number = 1; number <= 0xFFFF; ++number)
      if (unit.device.unit().object(object)->parameter(static_cast<std::uint16_t>(number)))
        existing.push_back(static_cast<std::uint16_t>(number));
    EXPECT_EQ(numbers, existing) << int{object};
    EXPECT_GT(numbers.size(), object == 1 ? 99U : 299U);
  }
}

TEST(ParameterLists, NameWhatIsModified) {
  RecordUnit unit;
  ASSERT_EQ(listed(unit, 2, 990), std::vector<std::uint16_t>{});

  ASSERT_EQ(unit.record("01020202 1001 0460 0000 1001 0422 0000 0801 40400000 0801 40400000"), "01020202");

  EXPECT_EQ(listed(unit, 2, 990), (std::vector<std::uint16_t>{1058, 1120}));
  EXPECT_EQ(listed(unit, 1, 990), std::vector<std::uint16_t>{});
  EXPECT_EQ(unit.record("01010201 1003 03DE 0000"), "010102010603042204600000");
}

TEST(DeviceIdentification, TellsManufacturerFirmwareAndDriveObjects) {
  RecordUnit unit{std::vector<device::AxisSetup>(2)};

  for (const char* const object : {"01", "02"}) {
    const std::string head = std::string{"0101"} + object;
    EXPECT_EQ(unit.record(head + "01 1001 03C4 0000"), head + "010601002A");
    EXPECT_EQ(unit.record(head + "02 1001 03C4 0002 1001 03C4 0005"), head + "02060101E006010003");
    EXPECT_EQ(unit.record(head + "01 1001 03C5 0000"), head + "0106010329");
  }
}

}  // namespace
}  // namespace profidrive
