#include "libcanopen/od/dictionary.hpp"

#include <bit>
#include <string>

#include <gtest/gtest.h>

#include "tests/libcanopen/fixture/test_table.hpp"

namespace {

using canopen::AbortCode;
using canopen::Access;
using canopen::DataType;
using canopen::Dictionary;
using canopen::Entry;
using canopen::EntryDescription;
using canopen::Result;

class DictionaryTest : public testing::Test {
 protected:
  const Entry& entry(std::uint16_t index, std::uint8_t sub_index = 0) const {
    return *dictionary.find(index, sub_index).value();
  }
  /// Writes as a master would; 0 or the abort code.
  std::uint32_t write(std::uint16_t index, std::int64_t value) {
    const auto written = dictionary.write(entry(index), value);
    return written ? 0 : static_cast<std::uint32_t>(written.error());
  }
  std::string text(std::uint16_t index) const {
    const auto bytes = dictionary.text(entry(index));
    return {bytes.begin(), bytes.end()};
  }

  Dictionary dictionary{test_table(), 5};
};

TEST_F(DictionaryTest, FindsEveryRowOfItsTable) {
  ASSERT_EQ(dictionary.entries().size(), test_table().size());
  for (const EntryDescription& row : test_table()) {
    const auto found = dictionary.find(row.index, row.sub_index);

    ASSERT_TRUE(found) << std::hex << row.index;
    EXPECT_EQ((*found)->description, &row);
  }
}

TEST_F(DictionaryTest, TellsAnAbsentObjectFromAnAbsentSubIndex) {
  EXPECT_EQ(dictionary.find(0x1001, 0).error(), AbortCode::NoObject);
  EXPECT_EQ(dictionary.find(0xFFFF, 255).error(), AbortCode::NoObject);
  EXPECT_EQ(dictionary.find(0x1018, 5).error(), AbortCode::NoSubIndex);
  EXPECT_EQ(dictionary.find(0x1000, 255).error(), AbortCode::NoSubIndex);
}

TEST_F(DictionaryTest, FindsTheSubIndicesBesideAGap) {
  EXPECT_EQ(dictionary.stored(entry(0x2025, 2)), 2);
  EXPECT_EQ(dictionary.stored(entry(0x2025, 5)), 5);
  EXPECT_EQ(dictionary.find(0x2025, 1).error(), AbortCode::NoSubIndex);
  EXPECT_EQ(dictionary.find(0x2025, 3).error(), AbortCode::NoSubIndex);
}

TEST_F(DictionaryTest, AddsTheNodeIdToRelativeValues) {
  EXPECT_EQ(dictionary.stored(entry(0x1014)), 0x85);
  EXPECT_EQ(dictionary.stored(entry(0x1800, 1)), 0x40000185);
}

TEST_F(DictionaryTest, RefusesATableThatIsNotInOrder) {
  const std::array swapped{EntryDescription{.index = 0x2001}, EntryDescription{.index = 0x2000}};
  const std::array twice{EntryDescription{.index = 0x2000}, EntryDescription{.index = 0x2000}};

  EXPECT_THROW((Dictionary{swapped, 1}), std::invalid_argument);
  EXPECT_THROW((Dictionary{twice, 1}), std::invalid_argument);
}

TEST_F(DictionaryTest, ReadsAndWritesOnlyWhatTheAccessAllows) {
  EXPECT_EQ(dictionary.read(entry(0x2020)).error(), AbortCode::WriteOnly);
  EXPECT_EQ(dictionary.write(entry(0x2021), 1).error(), AbortCode::ReadOnly);
  EXPECT_EQ(dictionary.write(entry(0x2022), 1).error(), AbortCode::ReadOnly);
  EXPECT_EQ(dictionary.write_text(entry(0x1008), {}).error(), AbortCode::ReadOnly);
  EXPECT_EQ(dictionary.read(entry(0x2021)), 0x1234);
}

constexpr std::uint32_t kTooHigh = 0x06090031;
constexpr std::uint32_t kTooLow = 0x06090032;
std::int64_t real(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

TEST_F(DictionaryTest, ChecksTheLimitsOfEveryType) {
  struct Row {
    std::uint16_t index;
    std::int64_t value;
    std::uint32_t abort;
  };
  const Row rows[] = {
      {0x2000, -10, 0},
      {0x2000, -11, kTooLow},
      {0x2000, 10, 0},
      {0x2000, 11, kTooHigh},
      {0x2001, 5, 0},
      {0x2001, 4, kTooLow},
      {0x2001, 201, kTooHigh},
      {0x2002, -1001, kTooLow},
      {0x2002, 1001, kTooHigh},
      {0x2003, 0, kTooLow},
      {0x2003, 0xFFF1, kTooHigh},
      {0x2004, -70001, kTooLow},
      {0x2004, 70001, kTooHigh},
      {0x2005, 0, kTooLow},
      {0x2005, 0xFFFFFFF1, kTooHigh},
      {0x2005, 0xFFFFFFF0, 0},
      {0x2006, -(1LL << 40) - 1, kTooLow},
      {0x2006, (1LL << 40) + 1, kTooHigh},
      {0x2006, 1LL << 40, 0},
      {0x2007, 15, kTooLow},
      {0x2007, 16, 0},
      {0x2007, INT64_MIN, 0},  // 8000000000000000h
      {0x2007, -17, 0},
      {0x2007, -16, kTooHigh},
      {0x2008, real(-0.75F), 0},
      {0x2008, real(0.75F), 0},
      {0x2008, real(-1.5F), kTooLow},
      {0x2008, real(1.5F), kTooHigh},
      {0x2008, real(-0.0F), 0},
      {0x2009, std::bit_cast<std::int64_t>(-1.5), 0},
      {0x2009, std::bit_cast<std::int64_t>(-2.5), kTooLow},
      {0x2009, std::bit_cast<std::int64_t>(2.5), kTooHigh},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(write(row.index, row.value), row.abort) << std::hex << row.index << " := " << row.value;
  }
}

TEST_F(DictionaryTest, KeepsTheOldValueWhenItRefusesTheNew) {
  EXPECT_EQ(write(0x2000, 11), kTooHigh);

  EXPECT_EQ(dictionary.stored(entry(0x2000)), -9);
}

TEST_F(DictionaryTest, KeepsNeighboursApart) {
  ASSERT_EQ(write(0x2010, 1), 0U);  // BOOLEAN
  for (std::uint16_t index = 0x2011; index < 0x2020; ++index) ASSERT_EQ(write(index, -1), 0U);
  for (std::uint16_t index = 0x2010; index < 0x2020; index += 2) ASSERT_EQ(write(index, 0), 0U);

  for (std::uint16_t index = 0x2010; index < 0x2020; index += 2) {
    EXPECT_EQ(dictionary.stored(entry(index)), 0) << std::hex << index;
    const Entry& next = entry(static_cast<std::uint16_t>(index + 1));
    const auto all_ones = next.is_signed ? -1 : static_cast<std::int64_t>(canopen::byte_mask(next.size));
    EXPECT_EQ(dictionary.stored(next), all_ones) << std::hex << next.index;
  }
}

TEST_F(DictionaryTest, TakesOnlyZeroAndOneForBoolean) {
  EXPECT_EQ(write(0x2010, 1), 0U);
  EXPECT_EQ(write(0x2010, 2), static_cast<std::uint32_t>(AbortCode::ValueTooHigh));
  EXPECT_EQ(write(0x2010, 0), 0U);
}

TEST_F(DictionaryTest, HoldsTextsUpToTheirCapacity) {
  const std::string longest = "12345678901234567890";
  const auto bytes = [](const std::string& s) {
    return std::span{reinterpret_cast<const std::uint8_t*>(s.data()), s.size()};
  };

  EXPECT_EQ(text(0x2023), "abc");
  EXPECT_EQ(text(0x2024), "");
  EXPECT_TRUE(dictionary.write_text(entry(0x2023), bytes(longest)));
  EXPECT_EQ(text(0x2023), longest);
  EXPECT_EQ(dictionary.write_text(entry(0x2023), bytes(longest + "1")).error(), AbortCode::LengthMismatch);
  EXPECT_EQ(text(0x2023), longest);
  EXPECT_TRUE(dictionary.write_text(entry(0x2023), {}));
  EXPECT_EQ(text(0x2023), "");
}

TEST_F(DictionaryTest, RestoresOnlyTheObjectsAskedFor) {
  write(0x2000, 3);
  write(0xA000, 3);
  write(0x1014, 0x90);

  dictionary.restore(0x2000, 0x9FFF);

  EXPECT_EQ(dictionary.stored(entry(0x2000)), -9);
  EXPECT_EQ(dictionary.stored(entry(0xA000)), 3);
  EXPECT_EQ(dictionary.stored(entry(0x1014)), 0x90);
  dictionary.restore(0x1000, 0x1FFF);
  EXPECT_EQ(dictionary.stored(entry(0x1014)), 0x85);
}

class EvenNumbersOnly final : public canopen::EntryOwner {
 public:
  Result<std::int64_t> read(const Entry&, std::int64_t stored) override { return stored + 100; }
  Result<void> write(const Entry&, std::int64_t value) override {
    ++writes;
    return value % 2 == 0 ? Result<void>{} : canopen::refuse(AbortCode::LocalControl);
  }
  int writes = 0;
};

TEST_F(DictionaryTest, AsksTheOwnerOfAnEntryAfterItsOwnChecks) {
  EvenNumbersOnly owner;
  dictionary.own_read(0x2000, 0, owner);
  dictionary.own_write(0x2000, 0, owner);

  EXPECT_EQ(write(0x2000, 4), 0U);
  EXPECT_EQ(write(0x2000, 5), 0x08000021U);
  EXPECT_EQ(write(0x2000, 11), kTooHigh);

  EXPECT_EQ(owner.writes, 2);
  EXPECT_EQ(dictionary.stored(entry(0x2000)), 4);
  EXPECT_EQ(dictionary.read(entry(0x2000)), 104);
}

TEST_F(DictionaryTest, RefusesOwnersAndCellsOfAbsentEntries) {
  EvenNumbersOnly owner;

  EXPECT_THROW(dictionary.own_write(0x1234, 0, owner), std::out_of_range);
  EXPECT_THROW((void)dictionary.cell<std::uint16_t>(0x1234, 0), std::out_of_range);
  EXPECT_THROW((void)dictionary.cell<std::uint32_t>(0x6040, 0), std::invalid_argument);
}

TEST_F(DictionaryTest, SharesAValueBetweenCellAndEntry) {
  auto controlword = dictionary.cell<std::uint16_t>(0x6040, 0);

  EXPECT_EQ(controlword.get(), 1);
  controlword.set(0xABCD);
  EXPECT_EQ(dictionary.read(entry(0x6040)), 0xABCD);
}

TEST_F(DictionaryTest, MapsEntriesByAccessAndDirection) {
  struct Row {
    std::uint16_t index;
    bool receives, transmits;
  };
  const Row rows[] = {
      {0x2011, true, true},    // rw
      {0x2020, true, false},   // wo
      {0x2021, false, true},   // ro
      {0x2022, false, false},  // const
      {0x6040, true, false},   // rww
      {0x606C, false, true},   // rwr
      {0x2000, false, false},  // rw, not mappable
      {0x1008, false, false},  // text
  };
  for (const Row& row : rows) {
    EXPECT_EQ(entry(row.index).receive_mappable, row.receives) << std::hex << row.index;
    EXPECT_EQ(entry(row.index).transmit_mappable, row.transmits) << std::hex << row.index;
  }
}

}  // namespace
