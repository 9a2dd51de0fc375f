#include "tests/sdo/object_sweep.hpp"

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

struct Objects : testing::TestWithParam<unsigned> {
  void SetUp() override { unit.start(); }

  TestUnit unit{Configuration{.node_id = 5, .axes = std::vector<AxisSetup>(GetParam())}};
  sdo_test::ObjectSweep sweep{unit, GetParam()};
};

TEST_P(Objects, AreThereWithSizeDefaultAccessAndLimits) {
  sweep.find_every_entry();
}

TEST_P(Objects, AreAllThereIs) {
  sweep.find_nothing_else(false);
}

TEST_P(Objects, ListTheModules) {
  sweep.find_the_modules();
}

INSTANTIATE_TEST_SUITE_P(Axes, Objects, testing::Values(1U, 2U, 6U, 8U));

}  // namespace
}  // namespace device
