// BICO inputs over SDO: what is refused and how, and what comes of it on the bus.
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

TEST(Interconnection, IsMadeByWritingItsParameter) {
  WiredDevice unit;
  // Drive object 2; p1070 = r1024 (0400h) of its own drive object (63 << 10), index 0.
  unit.expect_dialogue({{"605#2BB6410002000000", "585#60B6410000000000"},
                        {"605#232E240000FC0004", "585#602E240000000000"},
                        {"605#402E240000000000", "585#432E240000FC0004"}});
  EXPECT_EQ(unit.parameter(1070), own(1024));
}

TEST(Interconnection, IsRefusedWhereThereIsNoSuchSource) {
  WiredDevice unit{unit_of(2)};
  constexpr std::uint32_t kIllegal = 0x06090030;
  using drive::kOwnObject;
  struct Case {
    std::uint16_t input;
    drive::BicoSource source;
  };
  for (const Case& c :
       {Case{840, {8850, kOwnObject, 0}}, Case{840, {8890, kOwnObject, 16}}, Case{840, {8890, 4, 0}},
        Case{840, {1, 2, 0}}, Case{840, {722, 2, 0}}, Case{1070, {8860, 2, 19}}, Case{1070, {1120, 2, 0}},
        Case{1070, {1024, 1, 0}}, Case{1070, {1070, 2, 0}}}) {
    const std::uint32_t before = unit.read_parameter(2, c.input);
    EXPECT_EQ(unit.wire(2, c.input, c.source), kIllegal) << c.input << " to " << c.source.number;
    EXPECT_EQ(unit.read_parameter(2, c.input), before);
  }
  EXPECT_EQ(unit.write_parameter(2, 840, 2, 4), kIllegal) << "only 0 and 1 are constants";
  EXPECT_EQ(unit.wire(2, 840, {722, 1, 3}), 0U) << "a digital input of the control unit";
  EXPECT_EQ(unit.wire(2, 840, {899, 3, 2}), 0U) << "another axis";
  EXPECT_EQ(unit.wire(2, 8851, {8784, kOwnObject, 0}, 25), 0x06090011U) << "no such input";
  EXPECT_EQ(unit.write_parameter(2, 840, 1, 2), 0x06070010U);
}

TEST(Interconnection, LetsAnAxisFollowTheBitsThatAnotherOneReceives) {
  WiredDevice unit{unit_of(2)};
  for (const std::uint16_t input : std::initializer_list<std::uint16_t>{844, 848, 852})
    ASSERT_EQ(unit.write_parameter(3, input, 1, 4), 0U);
  ASSERT_EQ(unit.wire(3, 840, {8890, 2, 11}), 0U);
  ASSERT_EQ(unit.wire(3, 1070, {8860, 2, 1}), 0U);
  ASSERT_EQ(unit.write_parameter(3, 1120, 0, 4), 0U);
  unit.enter();
  unit.passes(1s);
  unit.says("305#00080000C800");  // bit 11, 187.5 rpm
  unit.passes(500ms);
  EXPECT_EQ(unit.device.axis(2).actual().state, drive::State::OperationEnabled);
  EXPECT_NEAR(unit.device.axis(2).actual().speed / drive::kRpm, 187.5, 0.5);
  EXPECT_FALSE(unit.device.axis(1).actual().pulses_enabled);
}

TEST(Interconnection, ActsOnAUnitThatRestsWhenAFreeObjectIsWritten) {
  WiredDevice unit{unit_of(2)};
  ASSERT_EQ(unit.wire(3, 8899, {8745, 2, 5}), 0U);
  for (const std::uint16_t input : std::initializer_list<std::uint16_t>{844, 848})
    ASSERT_EQ(unit.write_parameter(3, input, 1, 4), 0U);
  ASSERT_EQ(unit.wire(3, 840, {8894, drive::kOwnObject, 2}), 0U);
  unit.passes(1s);
  ASSERT_EQ(unit.word(0x6841) & 0x6F, 0x21);
  ASSERT_EQ(unit.download(0x5805, 0, 0x0004, 2), 0U);
  unit.passes(20ms);
  EXPECT_EQ(unit.word(0x6841) & 0x6F, 0x23);
  EXPECT_EQ(unit.read_parameter(2, 8745, 5), 4U);
}

TEST(Interconnection, ShowsOnTheBusWhatConvertersMake) {
  WiredDevice unit;
  unit.map_tpdo(1, {0x60410010, 0x58100010});  // the free object has word 8: 1 + 2 + 1 + 2 words are in use
  unsigned place = 0;
  while (place < 16 && unit.read_parameter(2, 8751, static_cast<std::uint8_t>(place)) != 0x5810) ++place;
  ASSERT_LT(place, 16U);
  ASSERT_EQ(unit.wire(2, 8880, {899, drive::kOwnObject, 0}, 3), 0U);
  ASSERT_EQ(unit.write_parameter(2, 8888, 0x0080, 2), 0U);
  ASSERT_EQ(unit.wire(2, 8851, {8889, drive::kOwnObject, 0}, static_cast<std::uint8_t>(place)), 0U);
  unit.enter();
  EXPECT_EQ(from("185#", unit.cycles_with("205#0600")).back(), "185#31168800");
}

TEST(Interconnection, ShowsTheFreeBitsOfTheStatusword) {
  WiredDevice unit;
  ASSERT_EQ(unit.wire(2, 8785, {8890, drive::kOwnObject, 11}), 0U);
  ASSERT_EQ(unit.wire(2, 8786, {8890, drive::kOwnObject, 12}), 0U);
  ASSERT_EQ(unit.write_parameter(2, 8787, 1, 4), 0U);
  unit.enter();
  unit.cycles_with("205#0608");
  EXPECT_EQ(unit.statusword(), 0x9731);
  unit.cycles_with("205#0610");
  EXPECT_EQ(unit.statusword(), 0xD631);
}

TEST(Interconnection, RaisesAnExternalFaultByABitFromTheBus) {
  WiredDevice unit;
  ASSERT_EQ(unit.wire(2, 2106, {8890, drive::kOwnObject, 13}), 0U);
  unit.enter();
  unit.cycles_with("205#0600");
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08) << "F07860, the bit is 0";
  EXPECT_EQ(unit.upload(0x1003, 1).number() & 0xFFFFU, 0x1000U);
}

}  // namespace
}  // namespace device
