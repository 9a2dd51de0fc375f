#include "tests/eds/rules/served_rows.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace eds_test {
namespace {

using canopen::Access;
using canopen::EntryDescription;

constexpr std::int64_t kAnyNode = 5;

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
    EXPECT_EQ(row.initial + (row.node_relative ? kAnyNode : 0), number(stated->second, kAnyNode));
  }
}

void expect_row(const Section& entry, const EntryDescription& row) {
  EXPECT_EQ(static_cast<int>(row.type), number_at(entry, "DataType"));
  EXPECT_EQ(row.access, kAccesses.at(entry.at("AccessType")));
  EXPECT_EQ(row.pdo_mappable, entry.at("PDOMapping") == "1");
  EXPECT_EQ(row.name, entry.at("ParameterName"));
  expect_same_limit(entry, "LowLimit", row.low);
  expect_same_limit(entry, "HighLimit", row.high);
  expect_same_initial(entry, row);
}

}  // namespace

void expect_rows_in_eds(std::span<const EntryDescription> rows, const EdsFile& file) {
  for (const EntryDescription& row : rows) {
    SCOPED_TRACE(testing::Message() << std::hex << row.index << ":" << int{row.sub_index});
    const Section* const entry = find_entry(file, row.index, row.sub_index);
    ASSERT_NE(entry, nullptr);
    expect_row(*entry, row);
  }
}

std::size_t count_entries(const EdsFile& file) {
  return static_cast<std::size_t>(
      std::ranges::count_if(file, [](const auto& section) { return section.second.contains("DataType"); }));
}

}  // namespace eds_test
