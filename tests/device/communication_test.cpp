#include <array>

#include "tests/device/communication_fixture.hpp"

namespace device {
namespace {

constexpr std::uint32_t kInvalidValue = 0x06090030, kDeviceState = 0x08000022, kReadOnly = 0x06010002;
constexpr std::uint32_t kTooHigh = 0x06090031;
constexpr std::uint16_t kStartState = 0x2000 + 8684, kNmtState = 0x2000 + 8685;

TEST(StartState, IsEnteredWithTheNextReset) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(kStartState, 0, 5, 2), 0U);
  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);

  unit.says("000#8205");

  EXPECT_EQ(unit.state(), canopen::NmtState::Operational);
}

TEST(StartState, MayBeStopped) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(kStartState, 0, 4, 2), 0U);

  EXPECT_EQ(unit.says("000#8205"), Lines{"705#00"});

  EXPECT_EQ(unit.state(), canopen::NmtState::Stopped);
}

TEST(StartState, RefusesOtherValues) {
  ControlUnit unit;

  for (const std::uint32_t value : {6U, 126U}) EXPECT_EQ(unit.download(kStartState, 0, value, 2), kInvalidValue);
  EXPECT_EQ(unit.download(kStartState, 0, 128, 2), kTooHigh);
  EXPECT_EQ(unit.upload(kStartState).number(), 127U);
}

TEST(NmtStateParameter, ShowsTheState) {
  ControlUnit unit;

  EXPECT_EQ(unit.upload(kNmtState).number(), 127U);
  unit.says("000#0105");
  EXPECT_EQ(unit.upload(kNmtState).number(), 5U);
}

TEST(NmtStateParameter, ChangesTheStateAfterTheAnswer) {
  ControlUnit unit;

  EXPECT_EQ(unit.says("605#2BED410005000000").at(0), "585#60ED410000000000");
  EXPECT_EQ(unit.state(), canopen::NmtState::Operational);
  EXPECT_EQ(unit.says("605#2BED41007F000000"), (Lines{"585#60ED410000000000", "085#011011FD21020000"}));
  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(unit.faults(2), Numbers{8701});
  EXPECT_EQ(unit.says("605#2BED410004000000"), Lines{"585#60ED410000000000"});
  EXPECT_EQ(unit.state(), canopen::NmtState::Stopped);
}

TEST(NmtStateParameter, Resets) {
  for (const char* const value : {"8000", "8100"}) {
    ControlUnit unit;
    EXPECT_EQ(unit.says(std::string{"605#2BED4100"} + value + "0000"), (Lines{"585#60ED410000000000", "705#00"}));
    EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
  }
}

TEST(NmtStateParameter, RefusesOtherValues) {
  ControlUnit unit;

  for (const std::uint32_t value : {0U, 1U, 3U, 126U})
    EXPECT_EQ(unit.download(kNmtState, 0, value, 2), kInvalidValue) << value;
  EXPECT_EQ(unit.download(kNmtState, 0, 130, 2), kTooHigh);
  EXPECT_EQ(unit.state(), canopen::NmtState::PreOperational);
}

TEST(NodeAddress, BelongsToTheConfiguration) {
  ControlUnit unit;

  EXPECT_EQ(unit.upload(0x2000 + 8620).number(), 5U);
  EXPECT_EQ(unit.upload(0x2000 + 8621).number(), 5U);
  EXPECT_EQ(unit.download(0x2000 + 8620, 0, 6, 1), kDeviceState);
  EXPECT_EQ(unit.download(0x2000 + 8621, 0, 6, 1), kReadOnly);
  EXPECT_EQ(unit.download(0x2000 + 8622, 0, 2, 2), 0U);
  EXPECT_EQ(unit.upload(0x2000 + 8622).number(), 2U);
}

TEST(ErrorControl, RefusesTheOtherMechanismByObjectAndByParameter) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x2000 + 8606, 0, 100, 2), 0U);

  EXPECT_EQ(unit.upload(0x1017).number(), 100U);
  for (std::uint8_t index = 0; index < 2; ++index)
    EXPECT_EQ(unit.download(0x2000 + 8604, index, 1, 2), kDeviceState);
  EXPECT_EQ(unit.download(0x100C, 0, 1, 2), kDeviceState);
  EXPECT_EQ(unit.download(0x100D, 0, 1, 1), kDeviceState);
  ASSERT_EQ(unit.download(0x1017, 0, 0, 2), 0U);
  EXPECT_EQ(unit.download(0x2000 + 8604, 0, 100, 2), 0U);
  EXPECT_EQ(unit.download(0x2000 + 8604, 1, 256, 2), kTooHigh) << "100Dh has one byte";
  EXPECT_EQ(unit.download(0x2000 + 8604, 1, 3, 2), 0U);
  EXPECT_EQ(unit.download(0x2000 + 8606, 0, 100, 2), kDeviceState);
  EXPECT_EQ(unit.download(0x1017, 0, 100, 2), kDeviceState);
}

TEST(Emcy, IsSuppressedByBit31) {
  ControlUnit unit;
  ASSERT_EQ(unit.download(0x1014, 0, 0x80000085, 4), 0U);

  ASSERT_TRUE(unit.device.raise(1, 7900, 0, unit.now));
  EXPECT_EQ(from("085#", unit.passes(100ms)), Lines{});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);

  ASSERT_EQ(unit.download(0x1014, 0, 0x85, 4), 0U);
  ASSERT_TRUE(unit.device.raise(1, 7901, 0, unit.now));
  EXPECT_EQ(from("085#", unit.passes(0ms)), Lines{"085#001081DD1E020000"});
}

TEST(Emcy, AndSyncIdentifiersKeepTheRulesOfCia301) {
  ControlUnit unit;

  EXPECT_EQ(unit.download(0x1014, 0, 0x00000086, 4), kDeviceState);
  EXPECT_EQ(unit.download(0x2000 + 8603, 0, 0, 4), kInvalidValue);
  EXPECT_EQ(unit.download(0x1005, 0, 0x40000080, 4), kInvalidValue);
  EXPECT_EQ(unit.download(0x2000 + 8602, 0, 0x40000080, 4), kInvalidValue);
  EXPECT_EQ(unit.download(0x2000 + 8602, 0, 0x90, 4), 0U);
  EXPECT_EQ(unit.upload(0x1005).number(), 0x90U);
}

}  // namespace
}  // namespace device
