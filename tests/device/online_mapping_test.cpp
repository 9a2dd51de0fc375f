#include "tests/device/pdo_rules_fixture.hpp"

/// Entries that are written while sub-index 0 of their mapping holds a 0 that a master has written.
namespace device {
namespace {

/// What a master may have written to 1604h:00 before the online mapping.
struct EarlierZero : testing::TestWithParam<bool> {
  void SetUp() override {
    unit.start();
    expect_accepted(unit, {0x41B6, 0, 2, 2});
    if (GetParam()) expect_accepted(unit, {0x1604, 0, 0, 1});
  }
  void expect_mapped() {
    EXPECT_EQ(unit.upload(0x1604, 0).number(), 2U);
    EXPECT_EQ(unit.upload(0x2000 + 8750, 4).number(), 0x5800U)
        << "behind the four words of 6040h, 60FFh and 6071h";
    expect_no_alarm(unit);
    unit.says("000#0105");
    unit.says("312#FECA78563412");
    EXPECT_EQ(unit.upload(0x5800).number(), 0xCAFEU);
    EXPECT_EQ(unit.upload(0x5820).number(), 0x12345678U);
  }

  TestUnit unit{unit_of(1)};
};

TEST_P(EarlierZero, DoesNotHinderTheOnlineMappingByParameters) {
  expect_accepted(unit, {0x2000 + 8704, 0, kInvalid | 0x312});
  expect_accepted(unit, {0x2000 + 8714, 0, 0x58000010});
  EXPECT_EQ(unit.upload(0x1604, 0).number(), 1U);
  expect_accepted(unit, {0x2000 + 8714, 1, 0x58200020});
  EXPECT_EQ(unit.upload(0x1604, 0).number(), 2U);
  expect_accepted(unit, {0x2000 + 8704, 0, 0x312});

  expect_mapped();
}

TEST_P(EarlierZero, DoesNotHinderTheOnlineMappingByObjects) {
  expect_accepted(unit, {0x1604, 1, 0x58000010});
  expect_accepted(unit, {0x1604, 2, 0x58200020});
  expect_accepted(unit, {0x1404, 1, 0x312});

  expect_mapped();
}

TEST_P(EarlierZero, DoesNotHinderAMappingByBoth) {
  expect_accepted(unit, {0x1604, 1, 0x58000010});
  expect_accepted(unit, {0x2000 + 8714, 1, 0x58200020});
  expect_accepted(unit, {0x1404, 1, 0x312});

  expect_mapped();
}

TEST_P(EarlierZero, DoesNotHinderThePredefinedConnections) {
  expect_accepted(unit, {0x1401, 1, kInvalid});
  expect_accepted(unit, {0x1601, 0, 0, 1});
  expect_accepted(unit, {0x1601, 1, 0x58000010});

  expect_accepted(unit, {0x2000 + 8741, 0, 1, 2});

  EXPECT_EQ(unit.upload(0x1601, 0).number(), 2U);
  EXPECT_EQ(unit.upload(0x1601, 1).number(), 0x60400010U);
}

INSTANTIATE_TEST_SUITE_P(OnlineMapping, EarlierZero, testing::Bool(),
                         [](const auto& tried) { return tried.param ? "Written" : "NotWritten"; });

TEST(OnlineMapping, IsJudgedWhenThePdoBecomesValid) {
  TestUnit unit{unit_of(1)};
  unit.start();
  expect_accepted(unit, {0x1403, 1, kInvalid});
  expect_accepted(unit, {0x1603, 0, 0, 1});
  expect_accepted(unit, {0x1603, 1, 0x60FF0020});  // 60FFh twice and 6071h are ten bytes

  EXPECT_EQ(unit.download(0x1403, 1, 0x505, 4), 0x06040042U);

  EXPECT_EQ(unit.upload(0x1003, 0x4B).number() >> 16, 8756U);
  EXPECT_EQ(unit.upload(0x1403, 1).number(), kInvalid);
  expect_accepted(unit, {0x1603, 3, 0});
  expect_accepted(unit, {0x1403, 1, 0x505});
  EXPECT_EQ(unit.upload(0x1603, 0).number(), 2U);
}

TEST(OnlineMapping, OutlivesAnInterfaceThatWasDown) {
  TestUnit unit{unit_of(1)};
  unit.start();
  expect_accepted(unit, {0x1604, 0, 0, 1});
  expect_accepted(unit, {0x1604, 1, 0x58000010});

  unit.device.start(unit.now);
  expect_accepted(unit, {0x1404, 1, 0x312});

  EXPECT_EQ(unit.upload(0x1604, 0).number(), 1U);
}

}  // namespace
}  // namespace device
