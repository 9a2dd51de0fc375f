#include <cstdlib>
#include <iostream>
#include <random>

#include "tests/fakes/candump.hpp"
#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

constexpr std::uint32_t kUnmappable = 0x06040041;
constexpr std::uint32_t kTooLong = 0x06040042;

/// The mapping word of boolean @p number, 1..64.
constexpr std::uint32_t boolean(unsigned number) {
  return 0x21000001U | number << 8;
}

/// AXISD_TEST_SEED repeats a run.
std::uint64_t seed() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

class PdoMapping : public PdoTest {
 protected:
  void SetUp() override { start(); }
};

TEST_F(PdoMapping, PutsBitsAndBytesOneAfterTheOther) {
  map(0x1804, 0x40000455, 1, {boolean(1), boolean(2), 0x60410010, boolean(3), 0x20110008});
  operate();
  store_value(0x2100, 1, 1);
  store_value(0x2100, 3, 1);
  store_value(0x6041, 0, 0x1234);
  store_value(0x2011, 0, -1);

  // 1, 0, 0001001000110100, 1, 11111111 from the lowest bit on: 27 bits in four bytes
  EXPECT_EQ(says("080#").back(), "455#D148FC07");
}

TEST_F(PdoMapping, TakesBitsAndBytesFromWhereTheyAre) {
  map(0x1404, 0x00000505, 255, {boolean(1), boolean(2), 0x60400010, boolean(3), 0x20110008});
  operate();

  says("505#D148FC07");

  EXPECT_EQ(value_of(0x2100, 1), 1);
  EXPECT_EQ(value_of(0x2100, 2), 0);
  EXPECT_EQ(value_of(0x6040), 0x1234);
  EXPECT_EQ(value_of(0x2100, 3), 1);
  EXPECT_EQ(value_of(0x2011), -1);

  says("505#00000000");
  EXPECT_EQ(value_of(0x2100, 1), 0);
  EXPECT_EQ(value_of(0x2011), 0);
}

TEST_F(PdoMapping, HoldsSixtyFourBits) {
  std::vector<std::uint32_t> words;
  for (unsigned number = 1; number <= 64; ++number) words.push_back(boolean(number));
  map(0x1404, 0x00000505, 255, words);
  map(0x1804, 0x40000455, 1, words);
  operate();

  says("505#0180FF00A55A3C81");

  EXPECT_EQ(value_of(0x2100, 1), 1);
  EXPECT_EQ(value_of(0x2100, 2), 0);
  EXPECT_EQ(value_of(0x2100, 16), 1);
  EXPECT_EQ(value_of(0x2100, 64), 1);
  EXPECT_EQ(says("080#").back(), "455#0180FF00A55A3C81");
}

TEST_F(PdoMapping, HoldsNoSixtyFifthBit) {
  ASSERT_EQ(writes_u32(0x1A04, 1, 0x20180020), 0U);
  ASSERT_EQ(writes_u32(0x1A04, 2, 0x20190020), 0U);
  ASSERT_EQ(writes_u32(0x1A04, 3, boolean(1)), 0U);
  EXPECT_EQ(writes_u8(0x1A04, 0, 3), kTooLong);
  EXPECT_EQ(writes_u8(0x1A04, 0, 2), 0U);
  EXPECT_EQ(writes_u8(0x1A04, 0, 65), kTooLong) << "more objects than any PDO has";
  EXPECT_EQ(writes_u8(0x1A04, 0, 255), kTooLong);
}

TEST_F(PdoMapping, AsksForTheLengthOfTheObjectInBits) {
  EXPECT_EQ(writes_u32(0x1A04, 1, 0x21000108), kUnmappable) << "a BOOLEAN is one bit long";
  EXPECT_EQ(writes_u32(0x1A04, 1, 0x21000100), kUnmappable);
  EXPECT_EQ(writes_u32(0x1A04, 1, 0x20110007), kUnmappable);
  EXPECT_EQ(writes_u32(0x1A04, 1, 0x2016000F), kUnmappable);
}

TEST_F(PdoMapping, LeavesBooleansAtOneBitWhateverTheApplicationPutsThere) {
  map(0x1804, 0x40000455, 1, {boolean(1), boolean(2)});
  operate();
  store_value(0x2100, 1, 6);

  EXPECT_EQ(says("080#").back(), "455#00");
}

TEST_F(PdoMapping, SkipsDummyObjectsOfRpdos) {
  // BOOLEAN, INTEGER8, INTEGER16, UNSIGNED32, then something real
  map(0x1404, 0x00000505, 255, {0x00010001, 0x00020008, 0x00030010, 0x00070020, boolean(1)});
  operate();

  says("505#FFFFFFFFFFFFFF00");
  EXPECT_EQ(value_of(0x2100, 1), 0);
  says("505#0000000000000002");
  EXPECT_EQ(value_of(0x2100, 1), 1) << "bit 57";
}

TEST_F(PdoMapping, JudgesDummyObjects) {
  EXPECT_EQ(writes_u32(0x1604, 1, 0x00050008), 0U);
  EXPECT_EQ(writes_u32(0x1604, 2, 0x00060010), 0U);
  EXPECT_EQ(writes_u32(0x1604, 3, 0x00040020), 0U);
  EXPECT_EQ(writes_u32(0x1604, 4, 0x00050010), kUnmappable) << "another length";
  EXPECT_EQ(writes_u32(0x1604, 4, 0x00010008), kUnmappable) << "a BOOLEAN";
  EXPECT_EQ(writes_u32(0x1604, 4, 0x00050108), 0x06090011U) << "sub-index 1";
  EXPECT_EQ(writes_u32(0x1604, 4, 0x00080020), 0x06020000U) << "REAL32 is no dummy";
  EXPECT_EQ(writes_u32(0x1A04, 1, 0x00050008), kUnmappable) << "in a TPDO";
}

TEST_F(PdoMapping, LeavesAnRpdoOfNothingButDummiesInUse) {
  map(0x1404, 0x00000505, 255, {0x00050008});
  operate();
  application.told.clear();

  says("505#12");

  EXPECT_EQ(application.told, (Lines{"RPDO 4"}));
}

TEST_F(PdoMapping, CarriesRandomValuesUnchanged) {
  const std::uint64_t seed_used = seed();
  std::cout << "AXISD_TEST_SEED=" << seed_used << '\n';
  std::mt19937_64 random{seed_used};
  const std::vector<std::uint32_t> objects{boolean(1), 0x20110008, 0x20130010, 0x20150018, 0x20170020,
                                           0x201A0028, 0x201B0030, 0x201C0038, 0x201D0040, boolean(64)};
  for (int round = 0; round < 50; ++round) {
    std::vector<std::uint32_t> words;
    for (unsigned bits = 0;;) {
      const std::uint32_t word = objects[random() % objects.size()];
      bits += word & 0xFF;
      if (bits > 64 || std::ranges::find(words, word) != words.end()) break;
      words.push_back(word);
    }
    if (words.empty()) continue;
    says("000#8005");
    map(0x1404, 0x00000505, 255, words);
    map(0x1804, 0x40000455, 1, words);
    operate();

    unsigned bits = 0;
    for (const std::uint32_t word : words) bits += word & 0xFF;
    canopen::Frame frame{.id = 0x505, .length = static_cast<std::uint8_t>((bits + 7) / 8)};
    canopen::store(frame.data.data(), random() >> (64 - bits));
    node->on_frame(frame, now);
    frame.id = 0x455;

    EXPECT_EQ(says("080#").back(), fakes::candump(frame));
  }
}

class PdoMappingWithoutDummies : public PdoTest {
 protected:
  PdoMappingWithoutDummies()
      : PdoTest{canopen::Policy{.error_keeping = canopen::ErrorKeeping::Owner, .dummy_types = 1 << 5}} {}
};

TEST_F(PdoMappingWithoutDummies, KnowsOnlyThoseThatThePolicyNames) {
  start();
  EXPECT_EQ(writes_u32(0x1604, 1, 0x00050008), 0U);
  EXPECT_EQ(writes_u32(0x1604, 2, 0x00060010), 0x06020000U);
}

}  // namespace
