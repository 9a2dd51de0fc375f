// Halt, quick stop, disable operation, shutdown and fault reaction, each with every option code.
#include <cmath>

#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

constexpr std::int64_t kSpeed = 600000;              // units/s
constexpr std::int64_t kSlow = 1000000;              // 6084h
constexpr std::int64_t kFast = 4000000;              // 6085h
constexpr double kSlowTime = 0.6, kFastTime = 0.15;  // s, from kSpeed to rest

enum class Stop { Coast, Slow, Fast, MaxTorque };

/// A device that turns with kSpeed.
struct Turning : TestDevice {
  Turning() {
    enable(Mode::ProfileVelocity);
    write(0x6084, kSlow);
    write(0x6085, kFast);
    write(0x6083, 10000000);
    write(0x60FF, kSpeed);
    passes(300ms);
    EXPECT_NEAR(static_cast<double>(velocity()), kSpeed, 1000.0);
  }

  /// Seconds until the speed is below a hundredth; 9 if it takes longer than 2 s.
  double time_to_rest() {
    const canopen::TimePoint begin = now;
    while (now - begin < 2s) {
      if (std::abs(velocity()) < kSpeed / 100) return std::chrono::duration<double>(now - begin).count();
      passes(1ms);
    }
    return 9.0;
  }

  void expect_stop(Stop how) {
    const double time = time_to_rest();
    if (how == Stop::Slow) {
      EXPECT_NEAR(time, kSlowTime, 0.02);
    }
    if (how == Stop::Fast) {
      EXPECT_NEAR(time, kFastTime, 0.02);
    }
    if (how == Stop::MaxTorque) {
      EXPECT_LT(time, 0.1);
    }
    if (how == Stop::Coast) {
      EXPECT_GT(time, 0.7);
    }
  }
};

struct Code {
  std::int64_t code;
  Stop how;
  std::uint16_t mask, end;
};

struct QuickStop : testing::TestWithParam<Code> {};
TEST_P(QuickStop, StopsAsItsCodeSays) {
  Turning axis;
  ASSERT_EQ(axis.write(0x605A, GetParam().code), 0U);
  axis.write(0x6040, 0x000B);
  if (GetParam().how != Stop::Coast) {
    EXPECT_EQ(axis.statusword() & 0x6F, 0x07);
  }
  axis.expect_stop(GetParam().how);
  EXPECT_TRUE(axis.reaches(GetParam().mask, GetParam().end, 100ms));
}
INSTANTIATE_TEST_SUITE_P(Codes, QuickStop,
                         testing::Values(Code{0, Stop::Coast, 0x4F, 0x40}, Code{1, Stop::Slow, 0x4F, 0x40},
                                         Code{2, Stop::Fast, 0x4F, 0x40}, Code{3, Stop::MaxTorque, 0x4F, 0x40},
                                         Code{4, Stop::MaxTorque, 0x4F, 0x40}, Code{5, Stop::Slow, 0x6F, 0x07},
                                         Code{6, Stop::Fast, 0x6F, 0x07}, Code{7, Stop::MaxTorque, 0x6F, 0x07},
                                         Code{8, Stop::MaxTorque, 0x6F, 0x07}));

struct Shutdown : testing::TestWithParam<Code> {};
TEST_P(Shutdown, StopsAsItsCodeSays) {
  Turning axis;
  ASSERT_EQ(axis.write(0x605B, GetParam().code), 0U);
  axis.write(0x6040, 0x0006);
  EXPECT_EQ(axis.statusword() & 0x6F, 0x21);
  axis.expect_stop(GetParam().how);
}
INSTANTIATE_TEST_SUITE_P(Codes, Shutdown, testing::Values(Code{0, Stop::Coast, 0, 0}, Code{1, Stop::Slow, 0, 0}));

struct DisableOperation : testing::TestWithParam<Code> {};
TEST_P(DisableOperation, StopsAsItsCodeSays) {
  Turning axis;
  ASSERT_EQ(axis.write(0x605C, GetParam().code), 0U);
  axis.write(0x6040, 0x0007);
  EXPECT_EQ(axis.statusword() & 0x6F, 0x23);
  axis.expect_stop(GetParam().how);
}
INSTANTIATE_TEST_SUITE_P(Codes, DisableOperation,
                         testing::Values(Code{0, Stop::Coast, 0, 0}, Code{1, Stop::Slow, 0, 0}));

struct Halt : testing::TestWithParam<Code> {};
TEST_P(Halt, StopsAsItsCodeSaysAndGoesOn) {
  Turning axis;
  ASSERT_EQ(axis.write(0x605D, GetParam().code), 0U);
  axis.write(0x6040, 0x010F);
  axis.expect_stop(GetParam().how);
  EXPECT_EQ(axis.statusword() & 0x6F, 0x27);
  EXPECT_TRUE(axis.reaches(0x0400, 0x0400, 100ms)) << "target reached: speed zero";
  axis.write(0x6040, 0x000F);
  axis.passes(500ms);
  EXPECT_NEAR(static_cast<double>(axis.velocity()), kSpeed, 1000.0);
}
INSTANTIATE_TEST_SUITE_P(Codes, Halt,
                         testing::Values(Code{1, Stop::Slow, 0, 0}, Code{2, Stop::Fast, 0, 0},
                                         Code{3, Stop::MaxTorque, 0, 0}, Code{4, Stop::MaxTorque, 0, 0}));

struct FaultReaction : testing::TestWithParam<Code> {};
TEST_P(FaultReaction, StopsAsItsCodeSays) {
  Turning axis;
  ASSERT_EQ(axis.write(0x605E, GetParam().code), 0U);
  axis.write(0x6007, 1);
  axis.says("000#8005");
  if (GetParam().how != Stop::Coast) {
    EXPECT_EQ(axis.statusword() & 0x4F, 0x0F);
  }
  axis.expect_stop(GetParam().how);
  EXPECT_TRUE(axis.reaches(0x4F, 0x08, 100ms));
}
INSTANTIATE_TEST_SUITE_P(Codes, FaultReaction,
                         testing::Values(Code{0, Stop::Coast, 0, 0}, Code{1, Stop::Slow, 0, 0},
                                         Code{2, Stop::Fast, 0, 0}, Code{3, Stop::MaxTorque, 0, 0},
                                         Code{4, Stop::MaxTorque, 0, 0}));

}  // namespace
}  // namespace cia402
