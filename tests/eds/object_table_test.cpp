#include "generated/object_table.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <gtest/gtest.h>

#include "tests/eds/eds_reader.hpp"

namespace eds_test {
namespace {

using canopen::Access;
using canopen::EntryDescription;
using device::generated::kObjectTable;

const EntryDescription* find_row(std::uint16_t index, std::uint8_t sub) {
  const auto found = std::ranges::find_if(
      kObjectTable, [=](const EntryDescription& row) { return row.index == index && row.sub_index == sub; });
  return found == kObjectTable.end() ? nullptr : &*found;
}

const std::map<std::string, Access> kAccesses{{"ro", Access::ReadOnly},        {"wo", Access::WriteOnly},
                                              {"rw", Access::ReadWrite},       {"rwr", Access::ReadWriteRead},
                                              {"rww", Access::ReadWriteWrite}, {"const", Access::Constant}};

void expect_same_limit(const Section& entry, std::string_view key, const std::optional<std::int64_t>& limit) {
  const auto stated = entry.find(key);
  const bool fixed = stated != entry.end() && !stated->second.starts_with("$NODEID");
  ASSERT_EQ(limit.has_value(), fixed) << key;
  if (fixed) {
    EXPECT_EQ(limit, number(stated->second)) << key;
  }
}

void expect_same_initial(const Section& entry, const EntryDescription& row) {
  const auto stated = entry.find("DefaultValue");
  if (stated == entry.end()) return;
  if (canopen::size_of(row.type) == 0) {
    EXPECT_EQ(row.text, stated->second);
  } else {
    EXPECT_EQ(row.initial + (row.node_relative ? 5 : 0), number(stated->second, 5));
  }
}

TEST(ObjectTable, SaysOfEveryEntryWhatTheEdsSays) {
  for (const EntryDescription& row : kObjectTable) {
    SCOPED_TRACE(testing::Message() << std::hex << row.index << ":" << int{row.sub_index});
    const Section* const entry = find_entry(generated_eds(), row.index, row.sub_index);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(static_cast<int>(row.type), number_at(*entry, "DataType"));
    EXPECT_EQ(row.access, kAccesses.at(entry->at("AccessType")));
    EXPECT_EQ(row.pdo_mappable, entry->at("PDOMapping") == "1");
    EXPECT_EQ(row.name, entry->at("ParameterName"));
    expect_same_limit(*entry, "LowLimit", row.low);
    expect_same_limit(*entry, "HighLimit", row.high);
    expect_same_initial(*entry, row);
  }
}

TEST(ObjectTable, HoldsEveryEntryOfTheEds) {
  const auto entries = std::ranges::count_if(generated_eds(), [](const auto& section) {
    return section.second.find("DataType") != section.second.end();
  });

  EXPECT_EQ(static_cast<std::size_t>(entries), kObjectTable.size());
}

TEST(ObjectTable, HoldsTheStartValuesThatTheEdsLeavesOpen) {
  EXPECT_EQ(find_row(0x100A, 0)->text, "04.80.65.00");
  EXPECT_EQ(find_row(0x1018, 3)->initial, 0x00010000);
  EXPECT_EQ(find_row(0x1018, 4)->initial, 1);
  EXPECT_EQ(find_row(0x6060, 0)->initial, 3);
  EXPECT_EQ(find_row(0x6061, 0)->initial, 3);
  EXPECT_EQ(find_row(0x6502, 0)->initial, 0x0E);
  EXPECT_EQ(find_row(0x1001, 0)->initial, 0);
}

TEST(ObjectTable, LeavesExactlyTheCobIdsAndTheErrorFieldToTheirOwners) {
  const auto is_judged_by_owner = [](const EntryDescription& row) {
    const bool pdo = (row.index & 0xFF00) == 0x1400 || (row.index & 0xFF00) == 0x1800;
    const bool error_count = row.index == 0x1003 && row.sub_index == 0;
    return error_count || row.index == 0x1005 || row.index == 0x1014 || (pdo && row.sub_index == 1);
  };
  for (const EntryDescription& row : kObjectTable)
    EXPECT_EQ(row.limit_check == canopen::LimitCheck::Owner, is_judged_by_owner(row))
        << std::hex << row.index << ":" << int{row.sub_index};
}

}  // namespace
}  // namespace eds_test
