// Cyclic synchronous modes over PDO and SYNC.
#include <cmath>
#include <cstdio>

#include "libcanopen/base/little_endian.hpp"
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

constexpr canopen::Duration kPeriod = 2ms;

/// An axis whose 6040h and 607Ah come by a synchronous RPDO, and whose 6041h and 6064h go by a synchronous TPDO.
struct SynchronousAxis {
  SynchronousAxis() {
    device.start();
    device.write(0x1402, 2, 1);
    device.write(0x1802, 2, 1);
    device.write(0x1802, 3, 0);
    device.write(0x60C2, 1, 2);
    device.write(0x60C2, 2, -3);
    device.write(0x6060, 8);
    device.says("000#0105");
    for (const int word : {0x06, 0x07, 0x0F}) sync(word, 0);
    for (int i = 0; i < 20; ++i) sync(0x0F, 0);
  }

  /// A set-point and the SYNC that makes it act, then time until the next is due.
  Lines sync(int word, std::int32_t position) {
    canopen::Frame frame{.id = 0x405, .length = 6};
    canopen::store(&frame.data[0], static_cast<std::uint16_t>(word));
    canopen::store(&frame.data[2], position);
    device.says(fakes::candump(frame));
    Lines sent = from("385#", device.says("080#"));
    device.passes(kPeriod);
    return sent;
  }
  void miss() { device.passes(kPeriod); }

  TestDevice device;
};

TEST(CyclicPosition, FollowsSetPointsWithOnePeriodOfDelay) {
  SynchronousAxis axis;
  double before = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double target = 20000.0 * (1.0 - std::cos(0.02 * i));
    axis.sync(0x0F, static_cast<std::int32_t>(std::lround(target)));
    EXPECT_NEAR(static_cast<double>(axis.device.read(0x6062)), target, 1.0);
    before = target;
  }
  EXPECT_EQ(axis.device.statusword() & 0x1000, 0x1000);
  EXPECT_LT(std::abs(static_cast<double>(axis.device.position()) - before), 200.0);
}

TEST(CyclicPosition, ExtrapolatesOneSetPointAndStopsAfterTheThird) {
  SynchronousAxis axis;
  std::int32_t target = 0;
  for (int i = 0; i < 50; ++i) axis.sync(0x0F, target += 200);
  axis.device.passes(kPeriod / 2);
  EXPECT_NEAR(static_cast<double>(axis.device.read(0x6062)), target + 100.0, 1.0);
  EXPECT_EQ(axis.device.statusword() & 0x1000, 0x1000);
  axis.device.passes(kPeriod / 2);
  axis.sync(0x0F, target += 400);
  for (int i = 0; i < 2; ++i) axis.miss();
  EXPECT_EQ(axis.device.statusword() & 0x4F, 0x07) << "not before the third one";
  for (int i = 0; i < 3; ++i) axis.miss();
  EXPECT_TRUE(axis.device.reaches(0x4F, 0x08, 2000ms));
  EXPECT_EQ(axis.device.read(0x603F), 0x8700);
}

TEST(CyclicPosition, HoldsForEverOverSdo) {
  TestDevice device;
  device.enable(Mode::CyclicSynchronousPosition);
  device.write(0x607A, 3000);
  device.passes(2s);
  EXPECT_EQ(device.statusword() & 0x6F, 0x27);
  EXPECT_EQ(device.read(0x6062), 3000);
  EXPECT_NEAR(static_cast<double>(device.position()), 3000.0, 2.0);
}

TEST(CyclicPosition, AnEnablingControlwordTakesTheSetPointOfItsOwnSync) {
  SynchronousAxis axis;
  for (const int word : {0x06, 0x07}) axis.sync(word, 5000);
  for (int i = 0; i < 50; ++i) axis.sync(0x07, 5000);
  EXPECT_NEAR(static_cast<double>(axis.device.position()), 0.0, 4.0);
  for (int i = 0; i < 50; ++i) axis.sync(0x0F, 1000);
  EXPECT_NEAR(static_cast<double>(axis.device.position()), 1000.0, 4.0);
}

}  // namespace
}  // namespace cia402
