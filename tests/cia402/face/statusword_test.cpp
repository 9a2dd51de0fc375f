// Behind each write of 6040h and 6060h the next read shows what has become of it, without a cycle in between.
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

constexpr std::uint16_t kStateBits = 0x6F;

TEST(Statusword, FollowsEachControlwordAtOnce) {
  TestDevice device;
  device.start_operational();
  EXPECT_EQ(device.statusword() & 0x4F, 0x40);
  struct Step {
    std::int64_t word;
    std::uint16_t mask, state;
  };
  for (const Step step : {Step{0x06, kStateBits, 0x21}, Step{0x07, kStateBits, 0x23}, Step{0x0F, kStateBits, 0x27},
                          Step{0x07, kStateBits, 0x23}, Step{0x0F, kStateBits, 0x27}, Step{0x02, kStateBits, 0x07},
                          Step{0x00, 0x4F, 0x40}, Step{0x06, kStateBits, 0x21}, Step{0x0F, kStateBits, 0x27},
                          Step{0x06, kStateBits, 0x21}, Step{0x00, 0x4F, 0x40}}) {
    ASSERT_EQ(device.write(0x6040, step.word), 0U);
    EXPECT_EQ(device.statusword() & step.mask, step.state) << std::hex << step.word;
  }
}

TEST(Statusword, ShowsModesAtOnceInEveryState) {
  TestDevice device;
  device.start_operational();
  for (const std::int64_t word : {0x00, 0x06, 0x07, 0x0F})
    for (const std::int64_t mode : {1, 2, 3, 4, 6, 7, 8, 9, 10, 0}) {
      ASSERT_EQ(device.write(0x6040, word), 0U);
      ASSERT_EQ(device.write(0x6060, mode), 0U);
      EXPECT_EQ(device.read(0x6061), mode);
    }
  for (const std::int64_t mode : {-1, 5, 11}) {
    EXPECT_EQ(device.write(0x6060, mode), 0x06090030U);
    EXPECT_EQ(device.read(0x6061), 0);
  }
}

TEST(Statusword, IsSentBeforeAnyCycleByAnEventDrivenTpdo) {
  TestDevice device;
  device.start_operational();
  device.passes(5ms);
  EXPECT_EQ(from("185#", device.says("205#0600")), Lines{"185#3102"});
  EXPECT_EQ(from("185#", device.says("205#0700")), Lines{"185#3302"});
  EXPECT_EQ(from("185#", device.says("205#0F00")), Lines{"185#3702"});
}

TEST(Statusword, OfASyncIsThatWithItsControlword) {
  TestDevice device;
  device.start();
  ASSERT_EQ(device.write(0x1400, 2, 1), 0U);
  ASSERT_EQ(device.write(0x1800, 2, 1), 0U);
  device.says("000#0105");
  EXPECT_EQ(from("185#", device.says("205#0600")), Lines{});
  EXPECT_EQ(from("185#", device.says("080#")), Lines{"185#3102"});
}

TEST(Statusword, HasRemoteInOperationalOnly) {
  TestDevice device;
  device.start();
  EXPECT_EQ(device.statusword() & 0x0200, 0);
  device.says("000#0105");
  EXPECT_EQ(device.statusword() & 0x0200, 0x0200);
  device.says("000#8005");
  EXPECT_EQ(device.statusword() & 0x0200, 0);
}

}  // namespace
}  // namespace cia402
