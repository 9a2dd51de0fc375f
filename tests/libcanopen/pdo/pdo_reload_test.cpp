#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

/// Lays values over the dictionary as stored ones would be, before the services start.
class PdoReload : public PdoTest {
 protected:
  using PdoTest::PdoTest;
  void stores_mapping(std::uint16_t index, std::initializer_list<std::uint32_t> words) {
    std::uint8_t sub = 0;
    for (const std::uint32_t word : words) store_value(index, ++sub, word);
    store_value(index, 0, sub);
  }
  /// What bit 31 of their COB-IDs tells a master.
  void expect_valid(std::initializer_list<std::uint16_t> pdos, bool valid) const {
    for (const std::uint16_t index : pdos)
      EXPECT_EQ((value_of(index, 1) & 0x80000000) == 0, valid) << std::hex << index;
  }
};

TEST_F(PdoReload, ShowsPdosThatCannotBeMappedAsInvalid) {
  stores_mapping(0x1600, {0x60410010});              // ro in an RPDO
  stores_mapping(0x1601, {0x60400010, 0x77770010});  // no such object
  stores_mapping(0x1A00, {0x201D0040, 0x60610008});  // 72 bits
  stores_mapping(0x1A01, {0});                       // an empty entry

  start();

  expect_valid({0x1400, 0x1401, 0x1800, 0x1801}, false);
  expect_valid({0x1402, 0x1802}, true);
  EXPECT_EQ(value_of(0x1400, 1), 0x80000205) << "the rest of the COB-ID stays";
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x405, 0x585, 0x605, 0x705}));
  EXPECT_EQ(says("000#0105"), Lines{});
}

TEST_F(PdoReload, LeavesPdosWithoutMappingValidAndDisabled) {
  stores_mapping(0x1A00, {});
  start();

  expect_valid({0x1800}, true);
  EXPECT_EQ(says("000#0105"), Lines{});
}

TEST_F(PdoReload, LeavesAnIdentifierToTheFirstThatHasIt) {
  store_value(0x1402, 1, 0x205);       // as RPDO 1
  store_value(0x1801, 1, 0x40000305);  // as RPDO 2
  store_value(0x1802, 1, 0x40000185);  // as TPDO 1
  store_value(0x1803, 1, 0x40000085);  // as EMCY
  store_value(0x1403, 1, 0x80);        // as SYNC

  start();

  expect_valid({0x1402, 0x1801, 0x1802, 0x1803, 0x1403}, false);
  expect_valid({0x1400, 0x1401, 0x1800}, true);
  says("000#0105");
  says("205#0F00");
  EXPECT_EQ(value_of(0x6040), 0x0F) << "RPDO 1, at once";
}

TEST_F(PdoReload, ShowsPdosOfIdentifiersThatNobodyMayUseAsInvalid) {
  store_value(0x1400, 1, 0x605);
  store_value(0x1800, 1, 0x40000000);
  start();

  expect_valid({0x1400}, false);
  expect_valid({0x1800}, false);
  EXPECT_EQ(says("605#4000100000000000"), (Lines{"585#4300100092010200"})) << "SDO has it";
}

TEST_F(PdoReload, FindsTheSameAfterTheBusWasAway) {
  start_operational();
  const Lines before{"705#00"};

  EXPECT_EQ(start(), before);

  expect_valid({0x1400, 0x1401, 0x1402, 0x1800, 0x1801, 0x1802}, true);
}

TEST_F(PdoReload, SendsTheAnswerToTheWriteBeforeTheTpdoThatItMakesValid) {
  start_operational();
  ASSERT_EQ(writes_u32(0x1800, 1, 0xC0000185), 0U);

  EXPECT_EQ(says("605#2300180186010040"), (Lines{"585#6000180100000000", "186#4000"}));
}

TEST_F(PdoReload, KeepsTheInhibitTimeAfterTheLastFrameOfASynchronousTpdo) {
  start();
  ASSERT_EQ(writes_u16(0x1804, 3, 100), 0U);  // 10 ms
  map(0x1804, 0x40000455, 1, {0x60410010});
  operate();
  passes(1s);
  says("080#");
  passes(4ms);

  ASSERT_EQ(writes_u8(0x1804, 2, 255), 0U);

  EXPECT_EQ(passes(100ms), (Lines{"1010ms 455#4000"}));
}

}  // namespace
