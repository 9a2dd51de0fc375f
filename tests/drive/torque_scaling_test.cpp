// Torque reduction (p1542) and scaling (p1552, p1554) of the torque limits.
#include <cstdint>
#include <utility>

#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr std::size_t kWord = 8;

struct ScaledLimits : WiredUnit {
  double upper = 0.0;
  double lower = 0.0;

  ScaledLimits() {
    cycles();
    upper = read(kX, 1538);
    lower = read(kX, 1539);
  }

  /// The effective limits with @p word at the input @p number, as shares of those without.
  std::pair<double, double> left(std::uint16_t number, unsigned word) {
    wire(kX, number, {8850, kOwnObject, kWord});
    receives(kX, kWord, static_cast<std::uint16_t>(word));
    cycles(2);
    return {read(kX, 1538) / upper, read(kX, 1539) / lower};
  }
};

TEST(TorqueScaling, MomredTakesItsShareOffBothLimits) {
  ScaledLimits limits;
  for (const auto& [word, share] : {std::pair{0x0000, 1.0}, std::pair{0x1000, 0.75}, std::pair{0x4000, 0.0},
                                    std::pair{0x7FFF, 0.0}, std::pair{0xFFFF, 0.0}}) {
    const auto [upper, lower] = limits.left(1542, static_cast<unsigned>(word));
    EXPECT_NEAR(upper, share, 1e-4) << std::hex << word;
    EXPECT_NEAR(lower, share, 1e-4) << std::hex << word;
  }
}

TEST(TorqueScaling, P1544SaysWhatAFullReductionTakesOff) {
  ScaledLimits limits;
  ASSERT_EQ(limits.write(kX, 1544, 50.0), std::nullopt);
  EXPECT_NEAR(limits.left(1542, 0x4000).first, 0.5, 1e-4);
  EXPECT_NEAR(limits.left(1542, 0x2000).second, 0.75, 1e-4);
}

TEST(TorqueScaling, EachLimitHasItsScaling) {
  ScaledLimits limits;
  const auto [upper, lower] = limits.left(1552, 0x1000);
  EXPECT_NEAR(upper, 0.25, 1e-4);
  EXPECT_NEAR(lower, 1.0, 1e-4);
  limits.set(kX, 1552, true);
  const auto [full, half] = limits.left(1554, 0x2000);
  EXPECT_NEAR(full, 1.0, 1e-4);
  EXPECT_NEAR(half, 0.5, 1e-4);
}

TEST(TorqueScaling, AWordHasNoSignAndTheMotorKeepsItsOwnLimits) {
  ScaledLimits limits;
  const double motor = limits.axis(kX).context().axis.machine.maximum_torque;
  ASSERT_NEAR(limits.upper, motor, 1e-3 * motor);
  EXPECT_NEAR(limits.left(1552, 0xC000).first, 1.0, 1e-4) << "300 %";
}

TEST(TorqueScaling, HoldsTheMotorBack) {
  ScaledLimits limits;
  limits.axis(kX).set_load_torque(0.5 * limits.read(kX, 333));
  limits.receives_double_word(kX, 1, 0x10000000);
  const auto left = limits.left(1552, 0x0400).first;
  ASSERT_LT(left * limits.upper, 0.5 * limits.read(kX, 333)) << "weaker than the load";
  limits.switch_on(kX);
  limits.cycles(50);
  EXPECT_NEAR(limits.axis(kX).actual().torque, left * limits.upper, 0.02 * limits.upper);
  EXPECT_LT(limits.rpm(kX), 0.0) << "the load turns it back";
}

}  // namespace
}  // namespace drive
