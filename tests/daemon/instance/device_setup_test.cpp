#include "daemon/instance/device_setup.hpp"

#include <gtest/gtest.h>

#include "tests/daemon/configuration/parse.hpp"
#include "tests/fakes/fake_port.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/fakes/vector_bus.hpp"

namespace axisd {
namespace {

/// The unit that the content of a configuration file makes.
struct ConfiguredUnit : device::Listener {
  explicit ConfiguredUnit(const std::string& text)
      : setup{device_configuration(parse_configuration(text, "node.json"), port, folder.path(""), log)},
        device{setup, bus, *this} {}
  void on_subscriptions_changed() noexcept override {}
  void on_foreign_frame(std::uint32_t) noexcept override {}

  double parameter(std::uint16_t number, std::size_t index = 0, std::size_t axis = 1) const {
    return device.axis(axis).read(number, index).value();
  }

  fakes::TemporaryDirectory folder;
  fakes::FakePort port;
  fakes::VectorBus bus;
  Log log{LogLevel::Error};
  device::Configuration setup;
  device::Device device;
};

TEST(DeviceSetup, WiresThePositionersOfTheAxesThatAskForIt) {
  const ConfiguredUnit unit{R"({"node_id": 7, "axes": [
    {"positioner": true, "positioner_wiring": "mdi"}, {"positioner": true}, {}]})"};

  EXPECT_EQ(unit.parameter(2642), drive::own_source(8860, 4));
  EXPECT_EQ(unit.parameter(8700), 0x207);
  EXPECT_EQ(unit.parameter(2642, 0, 2), drive::own_source(2690, 0));
  EXPECT_EQ(unit.parameter(108, 0, 2), 0x20000118);
  EXPECT_EQ(unit.parameter(108, 0, 3), 0x20000100);
}

TEST(DeviceSetup, LaysParametersOverAWiring) {
  const ConfiguredUnit unit{R"({"node_id": 0, "axes": [{"positioner": true, "positioner_wiring": "mdi",
    "parameters": {"p2612": "r0722.3 of drive object 1", "p8703[0]": 1286}}]})"};

  EXPECT_EQ(unit.parameter(2612), drive::pack({722, 1, 3}));
  EXPECT_EQ(unit.parameter(2596), drive::own_source(8892, 1));
  EXPECT_EQ(unit.parameter(8703), 1286.0);
  EXPECT_EQ(unit.parameter(8700), 0x200 + 126) << "p8620";
}

}  // namespace
}  // namespace axisd
