#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "libcanopen/od/dictionary.hpp"

namespace {

using canopen::AbortCode;
using canopen::Access;
using canopen::Dictionary;
using canopen::EntryDescription;

/// 3 000 objects over the whole range of indices: every third one a VAR, an ARRAY of three, a RECORD with a gap.
std::vector<EntryDescription> large_table() {
  std::vector<EntryDescription> table;
  for (std::uint32_t n = 0; n < 3000; ++n) {
    const auto index = static_cast<std::uint16_t>(0x1000 + n * 19);
    const std::vector<std::uint8_t> subs = n % 3 == 0   ? std::vector<std::uint8_t>{0}
                                           : n % 3 == 1 ? std::vector<std::uint8_t>{0, 1, 2, 3}
                                                        : std::vector<std::uint8_t>{0, 1, 7, 255};
    for (const std::uint8_t sub : subs) {
      table.push_back({.index = index,
                       .sub_index = sub,
                       .type = canopen::DataType::Unsigned32,
                       .access = Access::ReadWrite,
                       .initial = index << 8 | sub});
    }
  }
  return table;
}

TEST(LargeDictionary, FindsEachOfThreeThousandObjectsAndNoOther) {
  const auto table = large_table();
  const Dictionary dictionary{table, 1};

  std::size_t row = 0;
  for (std::uint32_t index = 0; index <= 0xFFFF; ++index) {
    for (std::uint32_t sub = 0; sub <= 0xFF; ++sub) {
      const auto* const found =
          dictionary.lookup(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub));
      const bool expected = row < table.size() && table[row].index == index && table[row].sub_index == sub;
      ASSERT_EQ(found != nullptr, expected) << std::hex << index << ' ' << sub;
      if (!expected) continue;
      ASSERT_EQ(found->description, &table[row]);
      ++row;
    }
  }
}

TEST(LargeDictionary, KeepsEveryValueToItself) {
  const auto table = large_table();
  Dictionary dictionary{table, 1};

  for (const auto& entry : dictionary.entries())
    ASSERT_TRUE(dictionary.write(entry, ~(entry.index << 8) & 0xFFFFFF));

  for (const auto& entry : dictionary.entries())
    ASSERT_EQ(dictionary.stored(entry), ~(entry.index << 8) & 0xFFFFFF);
}

}  // namespace
