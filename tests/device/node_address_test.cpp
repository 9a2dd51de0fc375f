// p8620 and r8621: the node-ID by the address switch, and with the switch at 0 by parameter.
#include "device/bus/node_address.hpp"

#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

/// The configuration of a unit with the switch at 0 that has @p saved.
Configuration without_switch(std::span<const std::byte> saved = {}, std::vector<ParameterPreset> presets = {}) {
  Configuration configuration = unit_with({});
  configuration.address_switch_off = true;
  configuration.presets = std::move(presets);
  configuration.node_id = address_without_switch(configuration, saved);
  return configuration;
}

TEST(NodeAddress, OfTheSwitchCannotBeWritten) {
  TestUnit unit;
  unit.start();
  unit.expect_dialogue({{"605#2BB6410001000000", "585#60B6410000000000"},
                        {"605#2FAC410007000000", "585#80AC410022000008"},
                        {"605#40AC410000000000", "585#4FAC410005000000"},
                        {"605#40AD410000000000", "585#4FAD410005000000"}});
}

TEST(NodeAddress, OfTheSwitchIsShownWhateverWasSaved) {
  TestUnit unit{unit_with({})};
  unit.start();
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);
  Configuration moved = unit_with({});
  moved.presets = {{.number = 8620, .value = 99}};
  TestUnit again{moved};
  ASSERT_TRUE(again.device.load_parameters(unit.listener.image));
  EXPECT_EQ(again.device.unit().control_unit().read(8620), 5.0);
}

TEST(NodeAddress, WithTheSwitchAtZeroIsThatOfP8620FromTheNextPowerOn) {
  TestUnit unit{without_switch()};
  EXPECT_EQ(unit.start().front(), "77E#00");
  unit.expect_dialogue({{"67E#2BB6410001000000", "5FE#60B6410000000000"},
                        {"67E#40AC410000000000", "5FE#4FAC41007E000000"},
                        {"67E#2FAC410007000000", "5FE#60AC410000000000"},  // p8620 = 7
                        {"67E#40AC410000000000", "5FE#4FAC410007000000"},
                        {"67E#40AD410000000000", "5FE#4FAD41007E000000"},    // r8621 = 126
                        {"67E#2BCB230001000000", "5FE#60CB230000000000"}});  // p0971 = 1
  EXPECT_EQ(unit.says("000#817E").front(), "77E#00") << "a reset is no power-on";

  TestUnit next{without_switch(unit.listener.image)};
  ASSERT_TRUE(next.device.load_parameters(unit.listener.image));
  EXPECT_EQ(next.start().front(), "707#00");
  next.expect_dialogue({{"607#2BB6410001000000", "587#60B6410000000000"},
                        {"607#40AD410000000000", "587#4FAD410007000000"},
                        {"607#4000140100000000", "587#4300140107020000"}});  // 1400h:01 = 207h
}

TEST(NodeAddress, OutlivesAFactoryReset) {
  TestUnit unit{without_switch()};
  unit.start();
  unit.expect_dialogue({{"67E#2BB6410001000000", "5FE#60B6410000000000"},
                        {"67E#2FAC410007000000", "5FE#60AC410000000000"},
                        {"67E#231110016C6F6164", "5FE#6011100100000000"},
                        {"67E#2BB6410001000000", "5FE#60B6410000000000"},
                        {"67E#40AC410000000000", "5FE#4FAC410007000000"}});
}

TEST(NodeAddress, IsOneOf127) {
  TestUnit unit{without_switch()};
  unit.start();
  unit.expect_dialogue({{"67E#2BB6410001000000", "5FE#60B6410000000000"},
                        {"67E#2FAC410000000000", "5FE#80AC410032000906"},
                        {"67E#2FAC410080000000", "5FE#80AC410031000906"}});
}

TEST(NodeAddress, IsThatOfANewUnitWhereNothingFits) {
  Configuration two = without_switch();
  two.axes.emplace_back();
  TestUnit other{two};
  other.start();
  other.expect_dialogue({{"67E#2BB6410001000000", "5FE#60B6410000000000"},
                         {"67E#2FAC410007000000", "5FE#60AC410000000000"},
                         {"67E#2310100173617665", "5FE#6010100100000000"}});
  EXPECT_EQ(address_without_switch(two, other.listener.image), 7);
  EXPECT_EQ(without_switch(other.listener.image).node_id, 126) << "an image of a unit with two axes";
  EXPECT_EQ(address_without_switch(two, std::span{other.listener.image}.first(40)), 126);
  EXPECT_EQ(without_switch({}, {{.number = 8620, .value = 33}}).node_id, 33);
}

}  // namespace
}  // namespace device
