#include "tests/sdo/object_sweep.hpp"

#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

struct Objects : testing::TestWithParam<unsigned> {
  void SetUp() override { device.start(); }

  TestDevice device{Configuration{.node_id = 5, .axes = std::vector<AxisSetup>(GetParam())}};
  sdo_test::ObjectSweep sweep{device, GetParam(), sdo_test::SweptDevice::Cia402};
};

TEST_P(Objects, AreThereWithSizeDefaultAccessAndLimits) {
  sweep.find_every_entry();
}

TEST_P(Objects, AreAllThereIs) {
  sweep.find_nothing_else(false);
}

INSTANTIATE_TEST_SUITE_P(Axes, Objects, testing::Values(1U, 2U, 8U));

}  // namespace
}  // namespace cia402
