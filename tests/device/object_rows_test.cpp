#include "device/objects/object_rows.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/eds/rules/served_rows.hpp"

/// The dictionary of one to eight axes against the EDS files of as many.
namespace device {
namespace {

using canopen::EntryDescription;
using eds_test::EdsFile;

std::vector<EntryDescription> rows_of(std::size_t axes) {
  return object_rows(std::vector<drive::ObjectKind>(axes, drive::ObjectKind::Servo));
}

const EntryDescription& row_at(const std::vector<EntryDescription>& rows, std::uint16_t index, std::uint8_t sub) {
  return *std::ranges::find_if(rows, [=](const auto& row) { return row.index == index && row.sub_index == sub; });
}

const EdsFile& eds_of(std::size_t axes) {
  return eds_test::generated_eds(axes == 1 ? "axisd.eds" : "axisd-" + std::to_string(axes) + "-axes.eds");
}

class ObjectRows : public testing::TestWithParam<std::size_t> {};

TEST_P(ObjectRows, SayOfEveryEntryWhatTheEdsSays) {
  eds_test::expect_rows_in_eds(rows_of(GetParam()), eds_of(GetParam()));
}

TEST_P(ObjectRows, HoldEveryEntryOfTheEds) {
  EXPECT_EQ(eds_test::count_entries(eds_of(GetParam())), rows_of(GetParam()).size());
}

INSTANTIATE_TEST_SUITE_P(Axes, ObjectRows, testing::Range<std::size_t>(1, 9));

TEST(ObjectRowsOfOneAxis, HoldTheStartValuesThatTheEdsLeavesOpen) {
  const std::vector<EntryDescription> rows = rows_of(1);

  EXPECT_EQ(row_at(rows, 0x100A, 0).text, "04.80.65.00");
  EXPECT_EQ(row_at(rows, 0x1018, 3).initial, 0x00010000);
  EXPECT_EQ(row_at(rows, 0x1018, 4).initial, 1);
  EXPECT_EQ(row_at(rows, 0x1027, 0).initial, 1);
  EXPECT_EQ(row_at(rows, 0x6060, 0).initial, 3);
  EXPECT_EQ(row_at(rows, 0x6061, 0).initial, 3);
  EXPECT_EQ(row_at(rows, 0x6502, 0).initial, 0x0E);
  EXPECT_EQ(row_at(rows, 0x1001, 0).initial, 0);
}

TEST(ObjectRowsOfOneAxis, LeaveExactlyTheCobIdsAndTheErrorFieldToTheirOwners) {
  const auto is_judged_by_owner = [](const EntryDescription& row) {
    const bool pdo = (row.index & 0xFF00) == 0x1400 || (row.index & 0xFF00) == 0x1800;
    const bool sdo = (row.index == 0x1201 || row.index == 0x1202) && row.sub_index != 0;
    const bool error_count = row.index == 0x1003 && row.sub_index == 0;
    return error_count || row.index == 0x1005 || row.index == 0x1014 || sdo || (pdo && row.sub_index == 1);
  };
  for (const EntryDescription& row : rows_of(1))
    EXPECT_EQ(row.limit_check == canopen::LimitCheck::Owner, is_judged_by_owner(row))
        << std::hex << row.index << ":" << int{row.sub_index};
}

TEST(ObjectRowsOfSeveralAxes, TellServoFromVectorAxes) {
  const auto rows =
      object_rows(std::array{drive::ObjectKind::Servo, drive::ObjectKind::Vector, drive::ObjectKind::Servo});

  EXPECT_EQ(row_at(rows, 0x1027, 0).initial, 3);
  EXPECT_EQ(row_at(rows, 0x1027, 1).initial, 0x000B);
  EXPECT_EQ(row_at(rows, 0x1027, 2).initial, 0x010C);
  EXPECT_EQ(row_at(rows, 0x1027, 3).initial, 0x020B);
  EXPECT_EQ(row_at(rows, 0x67FF, 0).initial, 0x00020192);
  EXPECT_EQ(row_at(rows, 0x6FFF, 0).initial, 0x02010192);
  EXPECT_EQ(row_at(rows, 0x77FF, 0).initial, 0x00020192);
}

TEST(ObjectRowsOfSeveralAxes, AreRefusedForAnyOtherNumberThanOneToEight) {
  EXPECT_THROW(static_cast<void>(rows_of(0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(rows_of(9)), std::invalid_argument);
}

}  // namespace
}  // namespace device
