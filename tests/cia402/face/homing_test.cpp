// Homing of a motor that turns a load past switches.
#include <cmath>

#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

/// Switches that the ways of all methods meet: limits at -4.7 and 8.6 revolutions, home from 2.3 to 4.6.
Configuration with_switches() {
  Configuration configuration{.node_id = 5};
  TravelSwitches& switches = configuration.axes.front().switches;
  switches.set(Signal::NegativeLimit, {.from = -1e6, .to = -4.7});
  switches.set(Signal::PositiveLimit, {.from = 8.6, .to = 1e6});
  switches.set(Signal::Home, {.from = 2.3, .to = 4.6});
  return configuration;
}

struct Method {
  int number;
  double home;  // revolutions from the place at power-on
};

struct HomingMethods : testing::TestWithParam<Method> {};

TEST_P(HomingMethods, FindTheirHome) {
  TestDevice device{with_switches()};
  device.enable(Mode::Homing);
  device.write(0x6099, 1, 5 * kRevolution);
  device.write(0x6099, 2, kRevolution);
  ASSERT_EQ(device.write(0x6098, GetParam().number), 0U);
  EXPECT_EQ(device.write(0x6040, 0x1F), 0U);
  EXPECT_EQ(device.statusword() & 0x3400, 0x0000);
  ASSERT_TRUE(device.reaches(0x3400, 0x1400, 60s)) << std::hex << device.statusword();
  EXPECT_EQ(device.statusword() & 0x8000, 0x8000);
  const double counted = static_cast<double>(device.read(0x6063)) / kRevolution;
  const double shown = static_cast<double>(device.position()) / kRevolution;
  EXPECT_NEAR(counted - shown, GetParam().home, 2.0 / kRevolution);
}

INSTANTIATE_TEST_SUITE_P(All, HomingMethods,
                         testing::Values(Method{17, -4.7}, Method{18, 8.6}, Method{19, 2.3}, Method{20, 2.3},
                                         Method{23, 2.3}, Method{24, 2.3}, Method{25, 4.6}, Method{26, 4.6},
                                         Method{27, 4.6}, Method{28, 4.6}, Method{29, 2.3}, Method{30, 2.3},
                                         Method{1, -4.0}, Method{2, 8.0}, Method{7, 2.0}, Method{8, 3.0},
                                         Method{11, 5.0}, Method{12, 4.0}, Method{33, -1.0}, Method{34, 1.0},
                                         Method{37, 0.0}));

TEST(Homing, ShowsHomeAtMinusItsOffset) {
  TestDevice device;
  device.enable(Mode::Homing);
  device.write(0x607C, 1234);
  device.write(0x6098, 37);
  device.write(0x6040, 0x1F);
  ASSERT_TRUE(device.reaches(0x3400, 0x1400, 100ms));
  EXPECT_EQ(device.position(), -1234);
}

}  // namespace
}  // namespace cia402
