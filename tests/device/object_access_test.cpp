#include <algorithm>
#include <array>
#include <vector>

#include "device/objects/object_rows.hpp"
#include "tests/device/test_unit.hpp"

namespace device {
namespace {

using canopen::Access;
using canopen::EntryDescription;

constexpr std::uint32_t kReadOnly = 0x06010002;

const std::vector<EntryDescription> kRows = object_rows(std::array{drive::ObjectKind::Servo});

std::string name_of(const EntryDescription& row) {
  return fakes::candump({.id = row.index, .length = 1, .data = {row.sub_index}}) + " " + std::string{row.name};
}

std::size_t expected_size(const EntryDescription& row) {
  const std::size_t size = canopen::size_of(row.type);
  return size != 0 ? size : row.text.size();
}

unsigned download_size(const EntryDescription& row) {
  const unsigned size = canopen::size_of(row.type);
  return size != 0 ? size : 4;
}

TEST(ObjectsOfTheCatalogue, CanAllBeReadWithTheSizeOfTheirType) {
  TestUnit unit;
  unit.start();

  for (const EntryDescription& row : kRows) {
    const Upload upload = unit.upload(row.index, row.sub_index);
    EXPECT_EQ(upload.abort_code, 0U) << name_of(row);
    EXPECT_EQ(upload.bytes.size(), expected_size(row)) << name_of(row);
  }
}

TEST(ObjectsOfTheCatalogue, StartWithTheirInitialValues) {
  TestUnit unit;
  unit.start();

  for (const EntryDescription& row : kRows) {
    const bool limits_speed = (row.index == 0x6046 || row.index == 0x6048) && row.sub_index != 0;
    const bool is_ramp = row.index >= 0x6083 && row.index <= 0x6085;
    const bool lives = row.index == 0x6041 || limits_speed || is_ramp;
    if (lives || canopen::size_of(row.type) == 0) continue;
    const auto mask = (std::uint64_t{1} << (8 * canopen::size_of(row.type))) - 1;
    const auto initial = static_cast<std::uint64_t>(row.initial + (row.node_relative ? 5 : 0)) & mask;
    EXPECT_EQ(unit.upload(row.index, row.sub_index).number(), initial) << name_of(row);
  }
}

TEST(ObjectsOfTheCatalogue, RefuseToBeWrittenWhereTheyAreReadOnly) {
  TestUnit unit;
  unit.start();

  int refused = 0;
  for (const EntryDescription& row : kRows) {
    if (row.access != Access::ReadOnly && row.access != Access::Constant) continue;
    EXPECT_EQ(unit.download(row.index, row.sub_index, 0, download_size(row)), kReadOnly) << name_of(row);
    ++refused;
  }
  EXPECT_GT(refused, 100);  // most of them are those of 1003h
}

TEST(ObjectsOfTheCatalogue, RefuseEveryOtherLength) {
  TestUnit unit;
  unit.start();

  for (const EntryDescription& row : kRows) {
    if (row.access == Access::ReadOnly || row.access == Access::Constant) continue;
    for (unsigned size = 1; size <= 4; ++size) {
      if (size == canopen::size_of(row.type)) continue;
      EXPECT_EQ(unit.download(row.index, row.sub_index, 0, size), 0x06070010U) << name_of(row) << ", " << size;
    }
  }
}

TEST(ObjectsOfTheCatalogue, AreAllThatExists) {
  TestUnit unit;
  unit.start();

  for (std::uint32_t index = 0; index <= 0xFFFF; ++index) {
    const auto known = std::ranges::find(kRows, index, &EntryDescription::index);
    const bool opens_the_window = index == 0x41B6;  // p8630
    if (known != kRows.end() || opens_the_window) continue;
    ASSERT_EQ(unit.upload(static_cast<std::uint16_t>(index)).abort_code, 0x06020000U) << std::hex << index;
  }
  EXPECT_EQ(unit.upload(0x1003, 0x53).abort_code, 0x06090011U);
  EXPECT_EQ(unit.upload(0x1400, 3).abort_code, 0x06090011U);
  EXPECT_EQ(unit.upload(0x6040, 1).abort_code, 0x06090011U);
}

}  // namespace
}  // namespace device
