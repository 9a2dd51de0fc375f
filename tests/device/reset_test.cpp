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

INSTANTIATE_TEST_SUITE_P(Commands, Reset, testing::Values("000#8105", "000#8205", "000#8100", "000#8200"),
                         [](const auto& frame) { return "Frame" + std::string{frame.param + 4}; });

TEST(ResetNode, ForgetsTheFaultsThatStood) {
  TestUnit unit;
  unit.start();
  for (const std::uint16_t number : std::vector<std::uint16_t>{7860, 30022, 8751})
    ASSERT_TRUE(unit.device.raise(1, number, 0, unit.now));
  unit.passes(100ms);

  EXPECT_EQ(unit.says("000#8105"), Lines{"705#00"});
  EXPECT_EQ(unit.passes(1s), Lines{});

  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  for (std::uint8_t sub_index = 0; sub_index <= 3; ++sub_index)
    EXPECT_EQ(unit.upload(0x1003, sub_index).number(), 0U) << int{sub_index};
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
}

TEST(ResetNode, SwitchesThePulsesOffAndLetsTheMotorCoast) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(3000, 1s);

  unit.says("000#8105");
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
  unit.passes(100ms);

  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
  EXPECT_EQ(unit.upload(0x6077).number(), 0U);
  EXPECT_GT(unit.velocity(), bus_speed(2800));
}

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

/// What a master sees of the faults: error register, 1003h with the blocks of two axes, fault buffer, statusword.
std::vector<std::uint64_t> shown_faults(TestUnit& unit) {
  std::vector<std::uint64_t> shown{unit.upload(0x1001).number(), unit.statusword()};
  for (std::uint8_t sub_index = 0; sub_index <= 0x52; ++sub_index)
    shown.push_back(unit.upload(0x1003, sub_index).number());
  for (std::uint8_t index = 0; index < 8; ++index) shown.push_back(unit.upload(0x2000 + 945, index).number());
  return shown;
}

TEST(ResetCommunication, LeavesTheFaultsToTheirAcknowledgement) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x41B6, 0, 2, 2), 0U);
  for (const std::uint16_t number : std::vector<std::uint16_t>{7860, 8700, 30022})
    ASSERT_TRUE(unit.device.raise(1, number, 0, unit.now));
  unit.passes(100ms);
  const auto before = shown_faults(unit);

  EXPECT_EQ(unit.says("000#8205"), Lines{"705#00"});
  EXPECT_EQ(unit.passes(1s), Lines{}) << "the faults have been told";

  ASSERT_EQ(unit.download(0x41B6, 0, 2, 2), 0U);
  EXPECT_EQ(shown_faults(unit), before);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
  EXPECT_EQ(unit.upload(0x1001).number(), 0x91U);
  EXPECT_EQ(unit.upload(0x2000 + 945, 0).number(), 7860U);
  EXPECT_EQ(unit.upload(0x2000 + 945, 1).number(), 8700U);

  unit.says("000#8105");  // one of them goes only with a power-on
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

TEST(ResetCommunication, WithAFaultPending) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  EXPECT_EQ(unit.passes(Device::kCycle), Lines{"085#001081B41E020000"});

  unit.expect_dialogue({
      {"000#8205", "705#00"},
      {"605#4041600000000000", "585#4B41600008160000"},  // Fault
      {"605#4001100000000000", "585#4F01100081000000"},
      {"605#4003100000000000", "585#4F03100001000000"},  // one message
      {"605#4003100100000000", "585#4303100100100200"},  // the most recent: code 1000h of drive object 2
      {"605#4003100300000000", "585#430310030010B41E"},  // F07860 of the first axis
      {"605#2BB6410002000000", "585#60B6410000000000"},  // p8630[0] = 2
      {"605#40B1230000000000", "585#4BB12300B41E0000"},  // r0945[0]
      {"605#2B40600006000000", "585#6040600000000000"},  // Shutdown
  });
  EXPECT_EQ(unit.passes(Device::kCycle), Lines{});
  EXPECT_EQ(unit.says("605#4041600000000000"), Lines{"585#4B41600038160000"}) << "it needs an acknowledgement";
  unit.says("605#2B40600086000000");
  EXPECT_EQ(unit.passes(Device::kCycle), Lines{"085#0000000000000000"});
  EXPECT_EQ(unit.says("605#4041600000000000"), Lines{"585#4B41600070160000"});
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.says("605#4041600000000000"), Lines{"585#4B41600031160000"}) << "the word says OFF1 too";
}

TEST(ResetCommunication, IsFollowedByTheEndOfTheFaultsWhenTheyAreAcknowledged) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.says("000#8205");

  EXPECT_EQ(unit.says("605#2F03100000000000"), (Lines{"085#0000000000000000", "585#6003100000000000"}));

  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
}

TEST(ResetCommunication, KeepsF08701) {
  TestUnit unit;
  unit.start_operational();
  unit.says("000#8005");

  unit.says("000#8205");

  EXPECT_EQ(unit.upload(0x1003, 3).number(), 0x21FD1001U);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
}

struct Abort {
  double option;             ///< p8641
  std::uint16_t state;       ///< 6041h at once, under 4Fh and 20h
  double speed;              ///< after half a second (rpm)
  std::uint16_t last_state;  ///< after ten seconds
};
void PrintTo(const Abort& abort, std::ostream* out) {
  *out << "p8641 = " << abort.option;
}

struct AbortedConnection : testing::TestWithParam<Abort> {};

// 1500 rpm; p1121 takes 4 s from 3000 rpm, p1135 1 s.
TEST_P(AbortedConnection, StopsADriveThatRunsAsP8641SaysWithoutAFault) {
  const auto& [option, state, speed, last_state] = GetParam();
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 0.1}, {1121, 4.0}, {1135, 1.0}, {8641, option}})};
  unit.turn_at(1500, 1s);

  EXPECT_EQ(unit.says("000#8205"), Lines{"705#00"});

  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x6F, state);
  unit.passes(496ms);
  if (option == 2.0) {
    EXPECT_GT(unit.velocity(), bus_speed(1000)) << "it coasts";
  } else {
    EXPECT_NEAR(unit.velocity(), bus_speed(speed), bus_speed(20));
  }
  unit.passes(10s);
  EXPECT_EQ(unit.statusword() & 0x6F, last_state) << "ON, which is still set, needs an edge";
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Options, AbortedConnection,
                         testing::Values(Abort{0.0, 0x27, 1500.0, 0x27}, Abort{1.0, 0x27, 1125.0, 0x21},
                                         Abort{2.0, 0x60, 0.0, 0x60}, Abort{3.0, 0x07, 0.0, 0x60}),
                         [](const auto& tried) {
                           return "P8641Is" + std::to_string(static_cast<int>(tried.param.option));
                         });

TEST(ResetCommunication, IsFollowedByANewEnable) {
  TestUnit unit{unit_with({{8641, 1.0}})};
  unit.enable();
  unit.says("000#8205");
  unit.passes(1s);
  ASSERT_EQ(unit.statusword() & 0x6F, 0x21);

  unit.says("000#0105");
  for (const char* const controlword : {"205#0600", "205#0700", "205#0F00"}) unit.cycles_with(controlword);

  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
}

TEST(ResetCommunication, DoesNotLiftTheInhibit) {
  TestUnit unit{unit_with({{8641, 1.0}})};
  unit.start_operational();
  unit.cycles_with("205#0F00");
  ASSERT_EQ(unit.statusword() & 0x6F, 0x60);

  unit.says("000#8205");
  unit.passes(100ms);

  EXPECT_EQ(unit.statusword() & 0x6F, 0x60);
}

TEST(ResetCommunication, BySdoParameterLeavesTheFaultsToo) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x41B6, 0, 1, 2), 0U);
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  unit.says("605#2BED410081000000");  // p8685 = 129

  EXPECT_EQ(unit.upload(0x1003, 3).number(), 7860U << 16 | 0x1000U);
}

}  // namespace
}  // namespace device
