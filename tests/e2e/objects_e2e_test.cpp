#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"
#include "tests/sdo/object_sweep.hpp"

namespace e2e {
namespace {

struct Objects : testing::TestWithParam<int> {
  DaemonProcess daemon{{.axes = GetParam()}};
  BusSdoClient client;
  sdo_test::ObjectSweep sweep{client, static_cast<unsigned>(GetParam())};
};

TEST_P(Objects, AreThoseOfTheRealUnit) {
  ASSERT_TRUE(daemon.is_ready());

  sweep.find_the_modules();
  sweep.find_every_entry();
}

TEST_P(Objects, AreAllThereIs) {
  ASSERT_TRUE(daemon.is_ready());

  sweep.find_nothing_else(false);
  constexpr std::uint16_t kWindow = 0x41B6;  // p8630
  ASSERT_EQ(client.download(kWindow, 0, 2, 2), 0U);
  sweep.find_nothing_else(true);
}

INSTANTIATE_TEST_SUITE_P(Axes, Objects, testing::Values(1, 2, 6, 8));

}  // namespace
}  // namespace e2e
