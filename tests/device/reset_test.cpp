#include "tests/device/test_unit.hpp"

namespace device {
namespace {

class Reset : public testing::TestWithParam<const char*> {};

TEST_P(Reset, SendsTheBootUpMessageAndStoresNoFault) {
  TestUnit unit;
  unit.enable();

  EXPECT_EQ(unit.says(GetParam()), Lines{"705#00"});
  EXPECT_EQ(unit.passes(1s), Lines{});

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
}

TEST_P(Reset, ForgetsTheFaultsThatStood) {
  TestUnit unit;
  unit.start();
  for (const std::uint16_t number : std::vector<std::uint16_t>{7860, 30022, 8751})
    ASSERT_TRUE(unit.device.raise(1, number, 0, unit.now));
  unit.passes(100ms);

  EXPECT_EQ(unit.says(GetParam()), Lines{"705#00"});
  EXPECT_EQ(unit.passes(1s), Lines{});

  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  for (std::uint8_t sub_index = 0; sub_index <= 3; ++sub_index)
    EXPECT_EQ(unit.upload(0x1003, sub_index).number(), 0U) << int{sub_index};
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
}

TEST_P(Reset, SwitchesThePulsesOffAndLetsTheMotorCoast) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(3000, 1s);

  unit.says(GetParam());
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
  unit.passes(100ms);

  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
  EXPECT_EQ(unit.upload(0x6077).number(), 0U);
  EXPECT_GT(unit.velocity(), bus_speed(2800));
}

TEST_P(Reset, BringsTheCommunicationParametersBack) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1400, 1, 0x80000205, 4), 0U);
  ASSERT_EQ(unit.download(0x1600, 1, 0x60600008, 4), 0U);
  ASSERT_EQ(unit.download(0x1400, 1, 0x00000215, 4), 0U);
  ASSERT_EQ(unit.download(0x1800, 2, 1, 1), 0U);
  ASSERT_EQ(unit.download(0x1017, 0, 100, 2), 0U);
  unit.passes(50ms);

  unit.says(GetParam());

  EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x205U);
  EXPECT_EQ(unit.upload(0x1600, 1).number(), 0x60400010U);
  EXPECT_EQ(unit.upload(0x1800, 2).number(), 0xFEU);
  EXPECT_EQ(unit.upload(0x1017).number(), 0U);
  EXPECT_EQ(unit.passes(1s), Lines{});
  EXPECT_EQ(unit.cycles_with("000#0105"), at_rest(0x1640));
  EXPECT_EQ(unit.cycles_with("205#0600"), at_rest(0x1631));
}

TEST_P(Reset, AbandonsAnSdoTransfer) {
  TestUnit unit;
  unit.start();
  unit.says("605#4008100000000000");

  unit.says(GetParam());

  EXPECT_EQ(unit.says("605#6000000000000000"), Lines{"585#8000000001000405"});
}

INSTANTIATE_TEST_SUITE_P(Commands, Reset, testing::Values("000#8105", "000#8205", "000#8100"),
                         [](const auto& frame) { return "Frame" + std::string{frame.param + 4}; });

TEST(ResetNode, BringsTheParametersBackToTheConfiguredOnes) {
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 1.0}})};
  unit.start();
  ASSERT_EQ(unit.download(0x6083, 0, 1000000, 4), 0U);
  ASSERT_EQ(unit.download(0x605D, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(0x6060, 0, 4, 1), 0U);
  ASSERT_EQ(unit.download(0x60FF, 0, 1000, 4), 0U);

  unit.says("000#8105");

  EXPECT_EQ(unit.upload(0x6083).number(), 209715200U);
  EXPECT_EQ(unit.upload(0x605D).number(), 0xFFFFU);
  EXPECT_EQ(unit.upload(0x6060).number(), 3U);
  EXPECT_EQ(unit.upload(0x60FF).number(), 0U);
}

TEST(ResetCommunication, LeavesTheParametersAlone) {
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 1.0}})};
  unit.start();
  ASSERT_EQ(unit.download(0x6083, 0, 104857600, 4), 0U);
  ASSERT_EQ(unit.download(0x605D, 0, 2, 2), 0U);

  unit.says("000#8205");

  EXPECT_EQ(unit.upload(0x6083).number(), 104857600U);
  EXPECT_EQ(unit.upload(0x605D).number(), 2U);
}

}  // namespace
}  // namespace device
