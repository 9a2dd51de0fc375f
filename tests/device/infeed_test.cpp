// The infeed as drive object 2: switched by the controlword of an axis, waited for by the axes, with faults of its
// own.
#include "tests/device/storage_fixture.hpp"
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

Configuration with_infeed(std::size_t axes = 1, motor::Infeed kind = motor::Infeed::Diode) {
  Configuration configuration = unit_of(axes);
  configuration.infeed = true;
  configuration.supply.infeed = kind;
  return configuration;
}

constexpr std::uint8_t kInfeed = 2;
constexpr std::uint8_t kAxis = 3;

/// A unit whose infeed is switched by bit 15 of the controlword of its axis, which waits for it.
struct SuppliedUnit : WiredDevice {
  explicit SuppliedUnit(std::size_t axes = 1) : WiredDevice{with_infeed(axes)} {
    expect_dialogue({{"605#2BB6410002000000", "585#60B6410000000000"},
                     {"605#234823000F0CBA22", "585#6048230000000000"},  // p0840 = r8890.15 of drive object 3
                     {"605#2BB6410003000000", "585#60B6410000000000"},
                     {"605#2360230000085F03", "585#6060230000000000"}});  // p0864 = r0863.0 of drive object 2
    enter();
  }
  std::int64_t display(std::uint8_t object) { return read_parameter(object, 2); }
  void run() {
    for (const char* const controlword : {"205#0600", "205#0700", "205#0F80"}) {
      cycles_with(controlword);
      passes(20ms);
    }
    ASSERT_EQ(statusword() & 0x6F, 0x27);
  }
};

TEST(Infeed, IsSwitchedOnByBit15OfTheControlwordOfItsAxis) {
  SuppliedUnit unit;
  EXPECT_EQ(unit.display(kInfeed), 31);
  EXPECT_EQ(unit.device.unit().dc_link().voltage(), 0.0);
  unit.cycles_with("205#0600");
  unit.cycles_with("205#0F00");
  EXPECT_EQ(from("185#", unit.passes(1s)), Lines{}) << "Switched on is all there is without the infeed";
  EXPECT_EQ(unit.statusword() & 0x6F, 0x23);
  EXPECT_EQ(unit.display(kAxis), 23);

  unit.says("205#0F80");
  EXPECT_EQ(from("185#", unit.passes(40ms)).back(), "185#3716");
  EXPECT_EQ(unit.display(kInfeed), 0);
  EXPECT_EQ(unit.display(kAxis), 0);
  unit.expect_dialogue({{"605#2BB6410002000000", "585#60B6410000000000"},
                        {"605#405F230000000000", "585#4B5F230003000000"},  // r0863
                        {"605#4083230000000000", "585#4B832300171A0000"}});
}

TEST(Infeed, TakesTheAxisWithItWhenItIsSwitchedOff) {
  SuppliedUnit unit;
  unit.run();
  const Lines sent = [&] {
    Lines lines = unit.says("205#0F00");
    std::ranges::move(unit.passes(20ms), std::back_inserter(lines));
    return lines;
  }();
  EXPECT_EQ(from("085#", sent), Lines{"085#001081A11E030000"});  // F07841 of drive object 3
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
  EXPECT_EQ(unit.display(kInfeed), 31);
}

TEST(Infeed, IsMissedAfterTheMonitoringTime) {
  SuppliedUnit unit;
  unit.cycles_with("205#0600");
  unit.cycles_with("205#0F00");
  EXPECT_EQ(from("085#", unit.passes(7s)), Lines{"085#001081A01E030000"});  // F07840
}

TEST(Infeed, HasAFaultOfItsOwnWhenTheLineIsMissing) {
  SuppliedUnit unit;
  unit.device.set_line_voltage(0.0, unit.now);
  unit.says("205#0680");
  unit.passes(1s);
  EXPECT_EQ(unit.display(kInfeed), 200);
  EXPECT_EQ(from("085#", unit.passes(6s)), Lines{"085#0010817A1E020000"});  // F07802 of drive object 2
  EXPECT_EQ(unit.display(kInfeed), 45);
  EXPECT_EQ(unit.read_parameter(kInfeed, 945), 7802U);
  EXPECT_EQ(unit.upload(0x1003, 0x4A).number(), 1U) << "an infeed is no logical module";
  EXPECT_EQ(unit.statusword() & 0x6F, 0x21) << "the axis has no part in it";

  unit.device.set_line_voltage(400.0, unit.now);
  EXPECT_EQ(unit.write_parameter(kInfeed, 3981, 1, 1), 0U);
  EXPECT_EQ(from("085#", unit.passes(20ms)), Lines{});
  EXPECT_EQ(unit.read_parameter(kInfeed, 945), 0U);
  EXPECT_EQ(unit.display(kInfeed), 41) << "ON is still given";
  unit.says("205#0600");
  unit.passes(20ms);
  unit.says("205#0680");
  unit.passes(20ms);
  EXPECT_EQ(unit.display(kInfeed), 0);
}

TEST(Infeed, TripsWhenTheLineFailsUnderLoad) {
  SuppliedUnit unit;
  unit.run();
  unit.device.set_load_torque(1, 5.0, unit.now);
  unit.says("305#0F800000800C");
  unit.passes(1s);
  unit.device.set_line_voltage(0.0, unit.now);
  const Lines sent = from("085#", unit.passes(2s));
  EXPECT_NE(std::ranges::find(sent, "085#0010813375020000"), sent.end()) << testing::PrintToString(sent);
}

TEST(Infeed, HasNumber2AndTheAxesFollow) {
  SuppliedUnit unit{2};
  unit.expect_dialogue({{"605#4027100000000000", "585#4F27100002000000"},
                        {"605#4027100100000000", "585#4B2710010B000000"},
                        {"605#4027100200000000", "585#4B2710020B010000"},
                        {"605#2BB6410001000000", "585#60B6410000000000"},
                        {"605#4027420000000000", "585#4B27420003000000"},  // r8743[0] = 3
                        {"605#4027420100000000", "585#4B27420104000000"},  // r8743[1] = 4
                        {"605#4066200000000000", "585#4B66200004000000"},  // r0102[0] = 4
                        {"605#406B200100000000", "585#4B6B20011E000000"},  // p0107[1] = 30, basic infeed
                        {"605#406B200200000000", "585#4B6B20020B000000"},  // p0107[2] = 11, servo
                        {"605#2BB6410005000000", "585#60B6410000000000"},
                        {"605#4002200000000000", "585#8002200000000206"}});  // there is no drive object 5
}

TEST(Infeed, HasTheTypeOfItsSupply) {
  WiredDevice active{with_infeed(1, motor::Infeed::Active)};
  EXPECT_EQ(active.read_parameter(1, 107, 1), 10U);
  WiredDevice smart{with_infeed(1, motor::Infeed::Regenerative)};
  EXPECT_EQ(smart.read_parameter(1, 107, 1), 20U);
}

TEST(Infeed, HasNoProcessDataAndNoMotor) {
  WiredDevice unit{with_infeed()};
  for (const std::uint16_t number : std::initializer_list<std::uint16_t>{8890, 8851, 8612, 848, 1120, 300})
    EXPECT_EQ(unit.write_parameter(kInfeed, number, 1, 4), 0x06020000U) << number;
  EXPECT_FALSE(unit.device.unit().infeed() == nullptr);
}

TEST(Infeed, HasNoSdoServerOfItsOwn) {
  SuppliedUnit unit{2};
  // p8612 of the first axis is 1202h.
  unit.expect_dialogue({{"605#2302120111060000", "585#6002120100000000"},
                        {"605#2302120291050000", "585#6002120200000000"},
                        {"611#4014250000000000", "591#4B14250015000000"}});  // p1300, which the infeed has not
}

TEST(Infeed, IsSwitchedOffByLeavingOperational) {
  Configuration configuration = with_infeed();
  configuration.fault_on_leaving_operational = true;
  WiredDevice unit{configuration};
  ASSERT_EQ(unit.write_parameter(kInfeed, 840, 1, 4), 0U);
  unit.passes(20ms);
  ASSERT_EQ(unit.write_parameter(kInfeed, 840, 0, 4), 0U);
  unit.passes(20ms);
  ASSERT_EQ(unit.write_parameter(kInfeed, 840, 1, 4), 0U);
  unit.passes(20ms);
  ASSERT_EQ(unit.read_parameter(kInfeed, 2), 0U);
  unit.enter();
  unit.leave();
  unit.passes(20ms);
  EXPECT_EQ(unit.read_parameter(kInfeed, 945), 8701U);
  EXPECT_EQ(unit.read_parameter(kInfeed, 2), 45U);
  EXPECT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  EXPECT_EQ(unit.read_parameter(kInfeed, 945), 0U);
}

TEST(Infeed, KeepsItsWiringThroughAPowerCut) {
  SuppliedUnit unit;
  unit.leave();
  ASSERT_EQ(unit.download(0x1010, 1, kSave, 4), 0U);
  NextLife next{unit, with_infeed()};
  EXPECT_EQ(next.unit.device.unit().infeed()->read(840), static_cast<double>(drive::pack({8890, 3, 15})));
  TestUnit other;
  EXPECT_FALSE(other.device.load_parameters(unit.listener.image)) << "a unit without infeed";
}

}  // namespace
}  // namespace device
