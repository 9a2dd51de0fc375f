/// A master commissions an axis over CAN: rating plate in, measure, save; docs/how-to/commissioning.md shows the
/// same frames.
#include <bit>

#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint32_t kDeviceState = 0x08000022, kInvalidValue = 0x06090030;

/// The default servo, but its winding has 1.2 times the resistance, and it turns three times its inertia.
Configuration other_machine() {
  Configuration configuration{.node_id = 5};
  drive::AxisConfiguration& axis = configuration.axes.front().drive;
  axis.inverter.dead_time = 1.5e-6;
  axis.inverter.forward_voltage = 1.0;
  axis.load.inertia = 2.0 * axis.machine.inertia;
  axis.deviation = {.stator_resistance = 1.2, .q_inductance = 0.9, .magnet_flux = 0.95};
  return configuration;
}

struct CommissionedUnit : TestUnit {
  CommissionedUnit() : TestUnit{other_machine()} { start_operational(); }

  /// 2000h + parameter, as REAL32.
  double real(std::uint16_t number) {
    const auto index = static_cast<std::uint16_t>(0x2000 + number);
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(upload(index).number())));
  }
  /// The same as INTEGER16.
  int word(std::uint16_t number) {
    return static_cast<std::int16_t>(upload(static_cast<std::uint16_t>(0x2000 + number)).number());
  }
  /// ON by RPDO1.
  void on() {
    for (const char* const frame : {"205#0600", "205#0600", "205#0700", "205#0F00"}) cycles_with(frame);
    EXPECT_EQ(statusword() & 0x006F, 0x0027) << "Operation enabled";
  }
};

TEST(Commissioning, GoesOverCanAsOnTheUnit) {
  CommissionedUnit unit;
  unit.expect_dialogue({
      {"605#2BB6410002000000", "585#60B6410000000000"},  // p8630[0] = 2: parameters of axis 1
      {"605#2B0A200003000000", "585#600A200000000000"},  // p0010 = 3: motor commissioning
      {"605#233021000000A543", "585#6030210000000000"},  // p0304 = 330 V
      {"605#233121003333B340", "585#6031210000000000"},  // p0305 = 5.6 A
      {"605#2337210000803B45", "585#6037210000000000"},  // p0311 = 3000 rpm
      {"605#235621000000803F", "585#6056210000000000"},  // p0342 = 1: the load is not known
      {"605#2B54210001000000", "585#6054210000000000"},  // p0340 = 1: compute everything from the plate
      {"605#2355210031EBC53A", "585#6055210000000000"},  // p0341 = 0.00151 kgm2, of the data sheet
      {"605#2B54210003000000", "585#6054210000000000"},  // p0340 = 3: the control once more
      {"605#2B0A200000000000", "585#600A200000000000"},  // p0010 = 0
      {"605#2B76270001000000", "585#6076270000000000"},  // p1910 = 1: A07991
  });
  unit.passes(10ms);
  EXPECT_NE(unit.statusword() & 0x0080, 0) << "alarm";
  EXPECT_EQ(unit.word(47), 300);
  const double gain = unit.real(1460);

  unit.on();
  EXPECT_EQ(unit.word(2), 14);
  EXPECT_TRUE(unit.reaches(0x007F, 0x0070, 60s)) << "Switch on disabled";
  EXPECT_EQ(unit.word(1910), 0);
  EXPECT_EQ(unit.statusword() & 0x0088, 0) << "neither alarm nor fault";
  EXPECT_NEAR(unit.real(350), 1.2 * 0.55, 0.02 * 0.66);
  EXPECT_NEAR(unit.real(356), 0.9 * 5.5, 0.03 * 4.95);

  unit.expect_dialogue({{"605#2BA8270001000000", "585#60A8270000000000"}});  // p1960 = 1: A07980
  unit.on();
  EXPECT_TRUE(unit.reaches(0x007F, 0x0070, 60s));
  EXPECT_EQ(unit.word(1960), 0);
  EXPECT_NEAR(unit.real(342), 3.0, 0.06);
  EXPECT_NEAR(unit.real(316), 0.95 * 1.37, 0.01 * 1.37);
  EXPECT_NEAR(unit.real(1460) / gain, 3.0, 0.1);

  unit.expect_dialogue({{"605#2310100173617665", "585#6010100100000000"}});  // 1010h:01 = "save"
  const double resistance = unit.real(350), ratio = unit.real(342);
  unit.says("000#8105");  // reset node: what was saved is there again
  unit.passes(1s);
  unit.says("000#0105");
  unit.download(0x41B6, 0, 2, 2);
  EXPECT_EQ(unit.real(350), resistance);
  EXPECT_EQ(unit.real(342), ratio);
  EXPECT_EQ(unit.real(1912), 0.0) << "forgotten";
}

TEST(Commissioning, AnswersWhatIsNotPossibleWithTheFittingAbortCode) {
  CommissionedUnit unit;
  ASSERT_EQ(unit.download(0x41B6, 0, 2, 2), 0U);
  const auto select = [&](std::uint16_t number, int value) {
    return unit.download(static_cast<std::uint16_t>(0x2000 + number), 0, static_cast<std::uint16_t>(value), 2);
  };

  EXPECT_EQ(select(1910, 2), kInvalidValue) << "of a vector axis";
  EXPECT_EQ(select(1910, -3), kDeviceState) << "nothing was found yet";
  EXPECT_EQ(select(1960, 3), kInvalidValue);
  unit.on();
  EXPECT_EQ(select(1910, 1), kDeviceState) << "pulses";
}

TEST(Commissioning, EndsWithAResetOfTheNode) {
  CommissionedUnit unit;
  ASSERT_EQ(unit.download(0x41B6, 0, 2, 2), 0U);
  ASSERT_EQ(unit.download(0x276C, 0, 1, 2), 0U);  // p1900 = 1
  unit.on();
  unit.passes(500ms);
  EXPECT_EQ(unit.word(2), 14);

  unit.says("000#8105");
  unit.passes(1s);
  unit.says("000#0105");
  ASSERT_EQ(unit.download(0x41B6, 0, 2, 2), 0U);

  EXPECT_EQ(unit.word(1900), 0);
  EXPECT_EQ(unit.word(1910), 0);
  EXPECT_EQ(unit.word(47), 0);
  EXPECT_EQ(unit.statusword() & 0x0088, 0);
  EXPECT_NEAR(unit.real(350), 0.55, 1e-6);
}

}  // namespace
}  // namespace device
