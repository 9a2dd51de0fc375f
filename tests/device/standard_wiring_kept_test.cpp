// The standard interconnections through mode, reset, restore, save and several axes.
#include "tests/device/standard_wiring.hpp"
#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

constexpr std::uint32_t kFiller = 0x58000010;  // a free word
constexpr std::uint32_t kControlword = 0x60400010, kVelocity = 0x60FF0020, kMode = 0x60600008;

TEST(StandardWiring, SendsTheModeThatIsActive) {
  WiredDevice unit;
  unit.map_tpdo(1, {0x60410010, 0x60610008});
  unit.enter();
  EXPECT_EQ(from("185#", unit.cycles_with("205#0600")).back().substr(8), "03");
  ASSERT_EQ(unit.download(0x6060, 0, 4, 1), 0U);
  EXPECT_EQ(from("185#", unit.passes(20ms)).back().substr(8), "04");
}

TEST(StandardWiring, GivesTheModeToTheProcessDataWhileItIsMapped) {
  WiredDevice unit;
  ASSERT_EQ(unit.download(0x6060, 0, 4, 1), 0U);
  EXPECT_EQ(unit.parameter(1300), 23.0);
  ASSERT_EQ(unit.download(0x6060, 0, 3, 1), 0U);
  unit.map_rpdo(1, {kControlword, kMode});
  ASSERT_EQ(unit.download(0x6060, 0, 4, 1), 0U);
  unit.cycle();
  EXPECT_EQ(unit.parameter(1300), 21.0) << "p1300 stays";
  EXPECT_EQ(unit.upload(0x6060).number(), 4U);
  EXPECT_EQ(unit.upload(0x6061).number(), 4U);
  EXPECT_EQ(unit.read_parameter(2, 8850, 1) & 0xFFFFU, 4U);
  ASSERT_EQ(unit.download(0x6060, 0, 0xEC, 1), 0U);
  unit.cycle();
  EXPECT_EQ(unit.read_parameter(2, 8850, 1) & 0xFFFFU, 0xFFECU) << "sign-extended";
}

TEST(StandardWiring, IsThatOfANewUnitAfterAResetAndARestore) {
  for (const char* const how : {"reset", "restore", "predefined"}) {
    WiredDevice unit;
    ASSERT_EQ(unit.wire(2, 1070, {1024, drive::kOwnObject, 0}), 0U);
    const bool keeps = std::string_view{how} == "predefined";
    if (keeps) {
      ASSERT_EQ(unit.wire(2, 1070, {8860, drive::kOwnObject, 1}), 0U);
    }
    unit.unmap_all();
    if (std::string_view{how} == "reset") unit.says("000#8105");
    if (std::string_view{how} == "restore") {
      ASSERT_EQ(unit.download(0x1011, 1, kLoad, 4), 0U);
    }
    if (keeps) {
      ASSERT_EQ(unit.write_parameter(2, 8741, 1, 2), 0U);
    }
    unit.cycle();
    expect_commands_at(unit, 8890);
    EXPECT_EQ(unit.parameter(1070), own(8860, 1)) << how;
    EXPECT_EQ(unit.parameter(1503), own(8850, 3)) << how;
    EXPECT_EQ(unit.parameter(8851, 3), own(80)) << how;
    EXPECT_EQ(unit.parameter(8861, 4), own(482)) << how;
  }
}

TEST(StandardWiring, IsSavedAndFollowsInTheNextLife) {
  WiredDevice former;
  former.unmap_all();
  former.map_rpdo(1, {kFiller, kControlword, kVelocity});
  ASSERT_EQ(former.wire(2, 1513, {8745, drive::kOwnObject, 4}), 0U);
  ASSERT_EQ(former.write_parameter(2, 844, 1, 4), 0U);
  ASSERT_EQ(former.download(0x1010, 1, kSave, 4), 0U);
  former.passes(1s);

  WiredDevice next{former};
  EXPECT_EQ(next.parameter(840), own(8891, 0));
  EXPECT_EQ(next.parameter(844), 1.0);
  EXPECT_EQ(next.parameter(1070), own(8860, 2));
  EXPECT_EQ(next.parameter(1503), own(8797));
  EXPECT_EQ(next.parameter(1513), own(8745, 4));
  next.map_rpdo(1, {kControlword});
  EXPECT_EQ(next.parameter(840), own(8890, 0)) << "and goes on following";
  EXPECT_EQ(next.parameter(844), 1.0);
  EXPECT_EQ(next.parameter(1070), own(8796));
}

TEST(StandardWiring, TakesTheSpeedSetpointAgainWhenItWasSavedInVelocityMode) {
  WiredDevice former;
  ASSERT_EQ(former.download(0x6060, 0, 2, 1), 0U);
  former.cycle();
  ASSERT_EQ(former.parameter(1070), own(8792));
  ASSERT_EQ(former.download(0x1010, 1, kSave, 4), 0U);
  former.passes(1s);

  const WiredDevice next{former};
  EXPECT_EQ(next.device.axis().actual().mode, 3);
  EXPECT_EQ(next.parameter(1070), own(8860, 1));
}

TEST(StandardWiring, OfOneAxisDoesNotConcernAnother) {
  WiredDevice unit{unit_of(3)};
  unit.unmap_all(2);
  expect_commands_at(unit, 8890, 1);
  expect_commands_at(unit, 8795, 2);
  expect_commands_at(unit, 8890, 3);
  unit.map_rpdo(4, {0x58800010, 0x68400010, 0x68FF0020}, 2);
  expect_commands_at(unit, 8891, 2);
  EXPECT_EQ(unit.parameter(1070, 0, 2), own(8860, 2));
  EXPECT_EQ(unit.parameter(1070, 0, 1), own(8860, 1));
}

}  // namespace
}  // namespace device
