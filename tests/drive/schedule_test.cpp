// The schedule of the axes: what one block has come to is there for the blocks of a later part of the same cycle.
#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr unsigned kTargetReached = 1U << 10;
constexpr unsigned kFreeBit14 = 1U << 14;

unsigned statusword_of(WiredUnit& wired, std::uint8_t object) {
  return wired.axis(object).actual().statusword;
}

TEST(Schedule, BringsASetpointToTheTorqueInputsOfAllAxesInTheSameCycle) {
  for (const auto& [from, to] : {std::pair{kX, kX}, {kX, kY}, {kY, kX}}) {
    WiredUnit wired;
    wired.wire(from, 1020, {8891, kOwnObject, 0});
    ASSERT_EQ(wired.write(from, 1001, 100.0), std::nullopt);
    wired.wire(to, 1511, {1024, from, 0});
    wired.cycles();
    ASSERT_EQ(inputs_of(wired.axis(to)).supplementary_torque_1, 0.0);

    wired.receives(from, 1, 1);
    wired.cycles();
    EXPECT_NEAR(inputs_of(wired.axis(to)).supplementary_torque_1,
                100.0 / wired.read(from, 2000) * wired.read(to, 2003), 1e-3)
        << "from " << int{from} << " to " << int{to};
  }
}

TEST(Schedule, ShowsAMessageInAFreeBitOfTheSameStatuswordOnAllAxes) {
  for (const auto& [from, to] : {std::pair{kX, kX}, {kX, kY}, {kY, kX}}) {
    WiredUnit wired;
    ASSERT_EQ(wired.write(from, 1120, 1.0), std::nullopt);
    wired.wire(to, 8786, {2197, from, 7});
    wired.switch_on(from);
    int changes = 0;
    for (int i = 0; i < 400; ++i) {
      wired.receives_double_word(from, 1, i < 200 ? 0x08000000 : 0);
      const unsigned before = statusword_of(wired, from) & kTargetReached;
      wired.cycles();
      const bool reached = (statusword_of(wired, from) & kTargetReached) != 0;
      changes += before != (statusword_of(wired, from) & kTargetReached) ? 1 : 0;
      ASSERT_EQ((statusword_of(wired, to) & kFreeBit14) != 0, reached)
          << "from " << int{from} << " to " << int{to};
    }
    EXPECT_GE(changes, 2);
  }
}

TEST(Schedule, IsTheSameForAnAxisThatRests) {
  const auto life = [](bool awake) {
    WiredUnit wired;
    wired.awake = {true, awake};
    wired.wire(kX, 1020, {8891, kOwnObject, 0});
    EXPECT_EQ(wired.write(kX, 1001, 100.0), std::nullopt);
    wired.wire(kY, 1511, {1024, kX, 0});
    wired.wire(kY, 1155, {1024, kX, 0});
    wired.wire(kY, 2151, {1150, kX, 0});
    wired.wire(kY, 8786, {2197, kX, 7});
    wired.switch_on(kX);
    std::vector<double> seen;
    for (int i = 0; i < 400; ++i) {
      wired.receives_double_word(kX, 1, i % 100 < 50 ? 0x08000000 : 0);
      wired.receives(kX, 1, static_cast<std::uint16_t>(i / 40 % 2));
      wired.cycles();
      seen.push_back(statusword_of(wired, kY));
      seen.push_back(inputs_of(wired.axis(kY)).supplementary_torque_1);
      seen.push_back(inputs_of(wired.axis(kY)).speed_setpoint_1);
    }
    return seen;
  };
  EXPECT_EQ(life(false), life(true));
}

}  // namespace
}  // namespace drive
