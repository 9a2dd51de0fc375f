// Faults: what the master is told, how the axis stops, how it is reset.
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

struct FaultRow {
  std::uint16_t number;  // of the drive
  std::uint16_t code;
  std::uint8_t error_register;
};

struct DriveFault : testing::TestWithParam<FaultRow> {};

TEST_P(DriveFault, HasTheCodeOfTheProfile) {
  TestDevice device;
  device.enable(Mode::ProfileVelocity);
  device.bus.take();
  ASSERT_TRUE(device.device.raise(1, GetParam().number, 0, device.now));
  const Lines sent = from("085#", device.passes(50ms));
  ASSERT_FALSE(sent.empty());
  char expected[16];
  std::snprintf(expected, sizeof expected, "085#%02X%02X%02X", GetParam().code & 0xFFU,
                unsigned{GetParam().code} >> 8, unsigned{GetParam().error_register});
  EXPECT_EQ(sent.front().substr(0, 10), expected);
  EXPECT_TRUE(device.reaches(0x4F, 0x08, 5000ms));
  EXPECT_EQ(device.read(0x603F), GetParam().code);
  EXPECT_EQ(device.read(0x1001) & GetParam().error_register, GetParam().error_register);
  EXPECT_EQ(device.read(0x1003, 1), std::int64_t{1} << 16 | GetParam().code);
  device.write(0x6040, 0x00);
  device.write(0x6040, 0x80);
  EXPECT_EQ(device.statusword() & 0x4F, 0x40);
  EXPECT_EQ(device.read(0x1001), 0);
}

INSTANTIATE_TEST_SUITE_P(Rows, DriveFault,
                         testing::Values(FaultRow{30001, 0x2310, 0x03}, FaultRow{30002, 0x3210, 0x05},
                                         FaultRow{30003, 0x3220, 0x05}, FaultRow{30004, 0x4210, 0x09},
                                         FaultRow{7011, 0x4310, 0x09}, FaultRow{30005, 0x2312, 0x03},
                                         FaultRow{31100, 0x7305, 0x21}, FaultRow{7900, 0x7121, 0x21},
                                         FaultRow{7901, 0x8400, 0x21}, FaultRow{30021, 0x2340, 0x03}));

TEST(FaultReset, NeedsAnEdgeAndLeadsToSwitchOnDisabled) {
  TestDevice device;
  device.enable(Mode::ProfilePosition);
  device.device.raise(1, 7860, 0, device.now);
  ASSERT_TRUE(device.reaches(0x4F, 0x08, 1000ms));
  device.write(0x6040, 0x008F);
  EXPECT_EQ(device.statusword() & 0x4F, 0x40) << "bits 0 to 3 count with the next write";
  device.write(0x6040, 0x0006);
  EXPECT_EQ(device.statusword() & 0x6F, 0x21);
}

TEST(FollowingError, BeyondItsWindowIsAFault) {
  TestDevice device;
  device.enable(Mode::ProfilePosition);
  device.write(0x6065, 10);
  device.write(0x6066, 20);
  device.write(0x60E0, 1);  // no torque to speak of
  device.write(0x60E1, 1);
  device.write(0x607A, 100000);
  device.write(0x6040, 0x1F);
  EXPECT_TRUE(device.reaches(0x08, 0x08, 2000ms));
  EXPECT_EQ(device.read(0x603F), 0x8611);
}

TEST(Connection, LostInOperationEnabledActsBy6007h) {
  struct Row {
    std::int64_t option;
    std::uint16_t mask, state;
    std::int64_t code;
  };
  for (const Row row :
       {Row{0, 0x6F, 0x27, 0}, Row{1, 0x4F, 0x08, 0x8130}, Row{2, 0x4F, 0x40, 0}, Row{3, 0x4F, 0x40, 0}}) {
    TestDevice device;
    device.enable(Mode::ProfileVelocity);
    device.write(0x6007, row.option);
    device.says("000#8005");
    EXPECT_TRUE(device.reaches(row.mask, row.state, 2000ms)) << row.option;
    EXPECT_EQ(device.read(0x603F), row.code) << row.option;
  }
}

TEST(Connection, OfAWatchedMasterIsLostWithItsHeartbeat) {
  TestDevice device;
  device.start_operational();
  ASSERT_EQ(device.write(0x1016, 1, 0x10064), 0U);  // node 1, 100 ms
  device.says("701#05");
  for (const int word : {0x06, 0x07, 0x0F}) device.write(0x6040, word);
  device.passes(50ms);
  device.says("701#05");
  device.passes(90ms);
  EXPECT_EQ(device.statusword() & 0x6F, 0x27);
  const Lines sent = from("085#", device.passes(50ms));
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent.front().substr(0, 9), "085#30811");
  EXPECT_TRUE(device.reaches(0x4F, 0x08, 2000ms));
}

}  // namespace
}  // namespace cia402
