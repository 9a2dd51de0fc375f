// Digital inputs of the control unit as a master sees them: what is wired to them acts on the bus.
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

TEST(Terminals, AnInputAcknowledgesAFault) {
  WiredDevice unit;
  unit.expect_dialogue({{"605#2BB6410002000000", "585#60B6410000000000"},
                        {"605#233828000204D202", "585#6038280000000000"}});  // p2104 = r0722.2 of drive object 1
  unit.enter();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  EXPECT_EQ(from("085#", unit.passes(8ms)), Lines{"085#001081B41E020000"});
  ASSERT_EQ(unit.statusword() & 0x4F, 0x08);

  unit.device.set_input(2, true, unit.now);
  const Lines sent = unit.passes(8ms);
  EXPECT_EQ(from("085#", sent), Lines{"085#0000000000000000"});
  EXPECT_EQ(from("185#", sent).front(), "185#4016");
}

TEST(Terminals, DigitalInput1SwitchesTheMotorOn) {
  WiredDevice unit;
  unit.expect_dialogue({{"605#2BB6410002000000", "585#60B6410000000000"},
                        {"605#234823000104D202", "585#6048230000000000"},    // p0840 = r0722.1
                        {"605#234C230001000000", "585#604C230000000000"},    // p0844 = 1
                        {"605#2350230001000000", "585#6050230000000000"},    // p0848 = 1
                        {"605#2354230001000000", "585#6054230000000000"}});  // p0852 = 1
  unit.enter();
  unit.passes(1s);  // the unit rests
  ASSERT_EQ(unit.statusword() & 0x6F, 0x21);

  unit.device.set_input(1, true, unit.now);
  EXPECT_EQ(from("185#", unit.passes(12ms)).back(), "185#3716");
  unit.device.set_input(1, false, unit.now);
  EXPECT_EQ(from("185#", unit.passes(1s)).back(), "185#3116");
}

TEST(Terminals, AreReadAndSimulatedOverSdo) {
  WiredDevice unit;
  unit.device.set_input(16, true, unit.now);
  unit.expect_dialogue({{"605#2BB6410001000000", "585#60B6410000000000"},
                        {"605#40D2220000000000", "585#43D2220000000100"},  // r0722
                        {"605#40D3220000000000", "585#43D32200FFFF3200"},  // r0723
                        {"605#231B230004000000", "585#601B230000000000"},  // p0795, input 2
                        {"605#231C230004000000", "585#601C230000000000"},  // p0796
                        {"605#40D2220000000000", "585#43D2220004000100"}});
}

TEST(Terminals, KeepDirectionAndSourcesThroughAPowerCut) {
  WiredDevice unit;
  ASSERT_EQ(unit.write_parameter(1, 728, 0x0300, 4), 0U);
  ASSERT_EQ(unit.write_parameter(1, 795, 0x0001, 4), 0U);
  ASSERT_EQ(unit.wire(1, 738, {899, 2, 0}), 0U);
  ASSERT_EQ(unit.download(0x1010, 1, 0x65766173, 4), 0U);

  WiredDevice again{unit.listener.image};
  EXPECT_EQ(again.read_parameter(1, 728), 0x0300U);
  EXPECT_EQ(again.read_parameter(1, 738), drive::pack({899, 2, 0}));
  EXPECT_EQ(again.read_parameter(1, 795), 0U) << "the simulation ends with the power";
}

}  // namespace
}  // namespace device
