// No axis moves because of what was written before it was enabled, before its mode was chosen, or in a halt.
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

struct SetPoint {
  Mode mode;
  std::uint16_t index;
  std::uint8_t sub_index;
  std::int64_t value;
};
/// Those that modes take by themselves, as they follow their object, are none of them (pv, tq, vl).
constexpr SetPoint kSetPoints[] = {
    {Mode::ProfilePosition, 0x607A, 0, 500000},           {Mode::InterpolatedPosition, 0x60C1, 1, 500000},
    {Mode::CyclicSynchronousPosition, 0x607A, 0, 500000}, {Mode::CyclicSynchronousVelocity, 0x60FF, 0, 500000},
    {Mode::CyclicSynchronousTorque, 0x6071, 0, 200},
};

void write_all(TestDevice& device) {
  for (const SetPoint& row : kSetPoints) ASSERT_EQ(device.write(row.index, row.sub_index, row.value), 0U);
}

struct OldSetPoints : testing::TestWithParam<Mode> {
  TestDevice device;

  void expect_standstill() {
    for (int i = 0; i < 10; ++i) {
      device.passes(20ms);
      ASSERT_NEAR(static_cast<double>(device.position()), 0.0, 4.0);
    }
  }
};

TEST_P(OldSetPoints, DoNotMoveAnAxisThatIsEnabled) {
  device.start_operational();
  write_all(device);
  device.write(0x6060, static_cast<std::int64_t>(GetParam()));
  for (const int word : {0x06, 0x07, 0x0F}) device.write(0x6040, word);
  expect_standstill();
}

TEST_P(OldSetPoints, DoNotMoveAnAxisWhoseModeIsChosen) {
  device.enable(Mode::None);
  write_all(device);
  device.write(0x6060, static_cast<std::int64_t>(GetParam()));
  ASSERT_EQ(device.read(0x6061), static_cast<std::int64_t>(GetParam()));
  expect_standstill();
}

TEST_P(OldSetPoints, OfAHaltDoNotMoveAnAxisBehindIt) {
  device.enable(GetParam());
  device.write(0x6040, 0x010F);
  write_all(device);
  device.write(0x6040, 0x000F);
  expect_standstill();
}

INSTANTIATE_TEST_SUITE_P(Modes, OldSetPoints,
                         testing::Values(Mode::None, Mode::ProfilePosition, Mode::Homing,
                                         Mode::InterpolatedPosition, Mode::CyclicSynchronousPosition,
                                         Mode::CyclicSynchronousVelocity, Mode::CyclicSynchronousTorque));

}  // namespace
}  // namespace cia402
