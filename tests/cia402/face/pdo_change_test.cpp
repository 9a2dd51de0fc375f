// PDOs that are changed in Operational, and asked for by remote frames; and the error field while it is empty.
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

TEST(PdoChanges, InOperationalTakeEffectAtOnce) {
  TestDevice device;
  device.start_operational();
  ASSERT_EQ(device.write(0x1403, 1, 0x80000505), 0U);
  ASSERT_EQ(device.write(0x1603, 0, 0), 0U);
  ASSERT_EQ(device.write(0x1603, 1, 0x60600008), 0U);
  ASSERT_EQ(device.write(0x1603, 0, 1), 0U);
  ASSERT_EQ(device.write(0x1403, 2, 255), 0U);
  ASSERT_EQ(device.write(0x1403, 1, 0x505), 0U);
  device.says("505#03");
  EXPECT_EQ(device.read(0x6061), 3);
}

TEST(PdoChanges, InOperationalMakeControlwordsWaitForSync) {
  TestDevice device;
  device.start_operational();
  ASSERT_EQ(device.write(0x1400, 1, 0x80000205), 0U);
  ASSERT_EQ(device.write(0x1400, 2, 1), 0U);
  ASSERT_EQ(device.write(0x1400, 1, 0x205), 0U);
  device.says("205#0600");
  EXPECT_EQ(device.statusword() & 0x4F, 0x40);
  device.says("080#");
  EXPECT_EQ(device.statusword() & 0x6F, 0x21);
}

TEST(TpdoRequests, AreAnsweredWhileBit30IsClear) {
  TestDevice device;
  device.start_operational();
  device.passes(5ms);
  EXPECT_EQ(from("185#", device.says("185#R2")), Lines{});
  ASSERT_EQ(device.write(0x1800, 1, 0x185), 0U);
  device.passes(5ms);
  EXPECT_EQ(from("185#", device.says("185#R2")), Lines{"185#5002"});
}

TEST(ErrorField, HasNoEntriesWhileItIsEmpty) {
  TestDevice device;
  device.start();
  EXPECT_EQ(device.read(0x1003, 0), 0);
  EXPECT_EQ(from("585#", device.says("605#4003100100000000")), Lines{"585#8003100124000008"});
}

}  // namespace
}  // namespace cia402
