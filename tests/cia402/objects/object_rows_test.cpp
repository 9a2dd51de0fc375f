#include "cia402/objects/object_rows.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "cia402/objects/object_index.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "tests/eds/rules/served_rows.hpp"

/// The dictionary of one to eight axes against the EDS files of as many.
namespace cia402 {
namespace {

using canopen::EntryDescription;
using eds_test::EdsFile;

const EdsFile& eds_of(std::size_t axes) {
  return eds_test::generated_eds(axes == 1 ? "axisd-cia402.eds"
                                           : "axisd-cia402-" + std::to_string(axes) + "-axes.eds");
}

const EntryDescription& row_at(const std::vector<EntryDescription>& rows, std::uint16_t index, std::uint8_t sub) {
  return *std::ranges::find_if(rows, [=](const auto& row) { return row.index == index && row.sub_index == sub; });
}

class Cia402Rows : public testing::TestWithParam<std::size_t> {};

TEST_P(Cia402Rows, SayOfEveryEntryWhatTheEdsSays) {
  eds_test::expect_rows_in_eds(object_rows(GetParam()), eds_of(GetParam()));
}

TEST_P(Cia402Rows, HoldEveryEntryOfTheEds) {
  EXPECT_EQ(eds_test::count_entries(eds_of(GetParam())), object_rows(GetParam()).size());
}

TEST_P(Cia402Rows, MakeADictionary) {
  const std::vector<EntryDescription> rows = object_rows(GetParam());

  const canopen::Dictionary dictionary{rows, 5};

  EXPECT_EQ(dictionary.stored(object::kDeviceType, 0), GetParam() == 1 ? 0x00020192 : 0xFFFF0192);
  EXPECT_EQ(dictionary.stored(object::kRpdoParameter, 1), 0x205);
}

INSTANTIATE_TEST_SUITE_P(Axes, Cia402Rows, testing::Range<std::size_t>(1, 9));

TEST(Cia402RowsOfOneAxis, BeginWithNothingWhatTheEdsLeavesOpen) {
  const std::vector<EntryDescription> rows = object_rows(1);

  for (const EntryDescription& row : rows) {
    if (eds_test::find_entry(eds_of(1), row.index, row.sub_index)->contains("DefaultValue")) continue;
    EXPECT_EQ(row.initial, row.index == object::kIdentity ? 1 : 0) << std::hex << row.index;
    EXPECT_EQ(row.text, "") << std::hex << row.index;
  }
}

TEST(Cia402RowsOfOneAxis, LeaveTheErrorFieldAloneToItsOwner) {
  for (const EntryDescription& row : object_rows(1))
    EXPECT_EQ(row.limit_check == canopen::LimitCheck::Owner,
              row.index == object::kErrorField && row.sub_index == 0)
        << std::hex << row.index << ":" << int{row.sub_index};
}

TEST(Cia402RowsOfSeveralAxes, HaveTheObjectsOfEachAxisAtItsPlace) {
  const std::vector<EntryDescription> rows = object_rows(8);

  for (std::size_t axis = 1; axis <= 8; ++axis) {
    EXPECT_EQ(row_at(rows, object::index_on_axis(object::kControlword, axis), 0).name, "Controlword");
    EXPECT_EQ(row_at(rows, object::index_on_axis(object::kTpdoMapping, axis), 1).initial,
              0x60410010 + 0x08000000LL * static_cast<std::int64_t>(axis - 1));
  }
  EXPECT_EQ(row_at(rows, 0x15C7, 1).initial, 0x80000000);
  EXPECT_FALSE(row_at(rows, 0x1440, 1).node_relative);
}

TEST(Cia402RowsOfSeveralAxes, AreRefusedForAnyOtherNumberThanOneToEight) {
  EXPECT_THROW(static_cast<void>(object_rows(0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(object_rows(9)), std::invalid_argument);
}

}  // namespace
}  // namespace cia402
