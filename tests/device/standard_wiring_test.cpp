// The interconnections of a new unit, and that they follow every mapping, except what the user has wired.
#include "tests/device/standard_wiring.hpp"

#include "tests/drive/axis_inputs.hpp"

namespace device {
namespace {

constexpr std::uint32_t kFiller = 0x58000010;  // a free word
constexpr std::uint32_t kControlword = 0x60400010, kVelocity = 0x60FF0020, kTorque = 0x60710010;
constexpr std::uint32_t kVlVelocity = 0x60420010;

TEST(StandardWiring, OfANewUnitIsThatOfThePredefinedConnectionsOnEveryAxis) {
  WiredDevice unit{unit_of(8)};
  for (std::size_t axis = 1; axis <= 8; ++axis) {
    expect_commands_at(unit, 8890, axis);
    EXPECT_EQ(unit.parameter(8790, 0, axis), 1.0);
    EXPECT_EQ(unit.parameter(1070, 0, axis), own(8860, 1));
    EXPECT_EQ(unit.parameter(1503, 0, axis), own(8850, 3));
    for (const std::uint16_t unwired : std::initializer_list<std::uint16_t>{1075, 1155, 1160, 1511, 1513})
      EXPECT_EQ(unit.parameter(unwired, 0, axis), 0.0) << 'p' << unwired;
    for (std::uint8_t word = 0; word < 25; ++word) {
      const double expected = word == 0 ? own(8784) : word == 3 ? own(80) : 0.0;
      EXPECT_EQ(unit.parameter(8851, word, axis), expected) << int{word};
    }
    for (std::uint8_t word = 0; word < 24; ++word) {
      const double expected = word == 1 ? own(63) : word == 4 ? own(482) : 0.0;
      EXPECT_EQ(unit.parameter(8861, word, axis), expected) << int{word};
    }
  }
}

TEST(StandardWiring, FollowsTheControlwordThroughTheWordsThatHaveBits) {
  for (unsigned place = 0; place < 4; ++place) {
    WiredDevice unit;
    unit.unmap_all();
    std::vector<std::uint32_t> entries;
    for (unsigned i = 0; i < place; ++i) entries.push_back(kFiller + (i << 16));
    entries.push_back(kControlword);
    unit.map_rpdo(1, entries);
    expect_commands_at(unit, static_cast<std::uint16_t>(8890 + place));

    unit.enter();
    const std::string filler(4 * place, '0');
    unit.says("205#" + filler + "0600");
    unit.cycle();
    EXPECT_EQ(unit.statusword() & 0x6F, 0x21) << "place " << place;
    unit.says("205#" + filler + "0700");
    unit.cycle();
    EXPECT_EQ(unit.statusword() & 0x6F, 0x23);
    EXPECT_EQ(unit.read_parameter(2, 8795), 0U) << "a mapped object has no parameter of its own";
  }
}

TEST(StandardWiring, TakesTheWrittenControlwordWhereItIsNotMapped) {
  WiredDevice unit;
  unit.unmap_all();
  expect_commands_at(unit, 8795);
  unit.switch_on();
  EXPECT_EQ(unit.statusword() & 0x6F, 0x27);
  EXPECT_EQ(unit.read_parameter(2, 8795), 0x000FU);

  unit.map_rpdo(2, {kControlword});
  expect_commands_at(unit, 8890);
  unit.cycle();
  EXPECT_EQ(unit.statusword() & 0x6F, 0x27) << "what was written is in the process data now";
  EXPECT_EQ(unit.read_parameter(2, 8795), 0U);
  ASSERT_EQ(unit.download(0x6040, 0, 0x0002, 2), 0U);
  unit.cycle();
  EXPECT_EQ(unit.statusword() & 0x6F, 0x07) << "SDO writes the place in the process data";
}

TEST(StandardWiring, FollowsTheSpeedSetpoint) {
  WiredDevice unit{[] {
    Configuration c = unit_of(1);
    c.axes[0].presets = {{1120, 0.0}, {1121, 0.0}};
    return c;
  }()};
  unit.unmap_all();
  EXPECT_EQ(unit.parameter(1070), own(8796));
  unit.switch_on();
  ASSERT_EQ(unit.download(0x60FF, 0, increments(600), 4), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(600), bus_speed(1));
  EXPECT_EQ(unit.read_parameter(2, 8796), increments(600));

  ASSERT_EQ(unit.download(0x6094, 1, 2, 4), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(600), bus_speed(1)) << "on the bus both have the factor";
  EXPECT_NEAR(unit.device.axis().actual().speed / drive::kRpm, 1200.0, 1.0);

  unit.map_rpdo(3, {kFiller, kControlword, kVelocity});
  EXPECT_EQ(unit.parameter(1070), own(8860, 2));
  unit.passes(100ms);
  EXPECT_NEAR(unit.device.axis().actual().speed / drive::kRpm, 1200.0, 1.0);
  EXPECT_EQ(unit.read_parameter(2, 8796), 0U);
  ASSERT_EQ(unit.download(0x60FF, 0, increments(-150), 4), 0U);
  unit.passes(500ms);
  EXPECT_NEAR(unit.device.axis().actual().speed / drive::kRpm, -300.0, 1.0);
}

TEST(StandardWiring, FollowsTheTorqueSetpoint) {
  WiredDevice unit;
  unit.unmap_all();
  EXPECT_EQ(unit.parameter(1503), own(8797));
  ASSERT_EQ(unit.download(0x6071, 0, 250, 2), 0U);
  unit.cycle();
  EXPECT_EQ(unit.read_parameter(2, 8797), 250U);
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).torque_setpoint, 0.25 * unit.parameter(333), 1e-3);
  unit.map_rpdo(1, {kVelocity, kTorque});
  EXPECT_EQ(unit.parameter(1503), own(8850, 2));
  unit.cycle();
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).torque_setpoint, 0.25 * unit.parameter(333), 1e-3);
}

TEST(StandardWiring, TakesTheRpmOfVelocityModeInItsPlace) {
  WiredDevice unit;
  unit.unmap_all();
  ASSERT_EQ(unit.download(0x6060, 0, 2, 1), 0U);
  unit.cycle();
  EXPECT_EQ(unit.parameter(1070), own(8792));
  ASSERT_EQ(unit.download(0x6042, 0, 300, 2), 0U);
  unit.cycle();
  EXPECT_EQ(unit.read_parameter(2, 8792), 300U);
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).main_setpoint, 300 * drive::kRpm, 1e-6);

  unit.map_rpdo(1, {kControlword, kVlVelocity});
  EXPECT_EQ(unit.parameter(1070), own(8850, 1));
  unit.cycle();
  EXPECT_NEAR(drive::inputs_of(unit.device.axis()).main_setpoint, 300 * drive::kRpm, 0.1 * drive::kRpm);
  ASSERT_EQ(unit.download(0x6060, 0, 3, 1), 0U);
  unit.cycle();
  EXPECT_EQ(unit.parameter(1070), own(8796));
}

struct Sent {
  std::uint32_t entry;
  std::uint16_t source;
};
constexpr std::array kSent{Sent{0x60410010, 8784}, Sent{0x60430010, 1170}, Sent{0x60440010, 63},
                           Sent{0x60610008, 8762}, Sent{0x60630020, 482},  Sent{0x60690020, 61},
                           Sent{0x606B0020, 1170}, Sent{0x606C0020, 63},   Sent{0x60740010, 79},
                           Sent{0x60770010, 80}};

TEST(StandardWiring, FollowsEveryActualValueAndReadsTheDriveWithoutIt) {
  for (const Sent& sent : kSent) {
    const auto index = static_cast<std::uint16_t>(sent.entry >> 16);
    const std::uint16_t sink = (sent.entry & 0xFF) == 0x20 ? 8861 : 8851;
    WiredDevice unit{[] {
      Configuration c = unit_of(1);
      c.axes[0].presets = {{1120, 0.0}};
      return c;
    }()};
    unit.unmap_all();
    unit.switch_on();
    unit.device.set_load_torque(1, 0.5, unit.now);
    ASSERT_EQ(unit.download(0x60FF, 0, increments(750), 4), 0U);
    unit.passes(1s);
    const std::uint64_t unmapped = unit.upload(index).number();
    EXPECT_NE(unmapped, 0U) << std::hex << index;

    for (const auto& [entries, place] : {std::pair{std::vector{sent.entry}, 0},
                                         std::pair{std::vector{0x58100010U, 0x58110010U, sent.entry}, 2}}) {
      unit.map_tpdo(3, entries);
      EXPECT_EQ(unit.parameter(sink, static_cast<std::size_t>(place)), own(sent.source)) << std::hex << index;
      if (place == 2) {
        EXPECT_EQ(unit.parameter(sink, 0), 0.0) << "the former place is free";
      }
      unit.cycle();
      const auto difference =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(unit.upload(index).number() - unmapped));
      const std::int32_t tolerance = index == 0x6063 ? 10'000'000 : sink == 8861 ? 4000 : 3;
      EXPECT_LE(std::abs(difference), tolerance) << std::hex << index << " at " << place;
    }
    ASSERT_EQ(unit.write_parameter(2, sink, 0, 4, 2), 0U);
    unit.cycle();
    EXPECT_EQ(unit.upload(index).number(), 0U) << "unwired: " << std::hex << index;
    unit.map_tpdo(3, {});
    EXPECT_EQ(unit.parameter(sink, 2), 0.0);
    unit.cycle();
    EXPECT_NE(unit.upload(index).number(), 0U) << "not mapped, it shows the drive";
  }
}

TEST(StandardWiring, SendsNothingForAWordThatIsNotWired) {
  WiredDevice unit;
  unit.enter();
  ASSERT_EQ(unit.write_parameter(2, 8851, 0, 4, 0), 0U);
  EXPECT_EQ(from("185#", unit.cycles_with("205#0600")).back(), "185#0000");
  EXPECT_EQ(unit.statusword(), 0U) << "SDO reads the same place";
  ASSERT_EQ(unit.wire(2, 8851, {8784, drive::kOwnObject, 0}), 0U);
  unit.cycle();
  EXPECT_EQ(unit.statusword() & 0x6F, 0x21);
}

TEST(StandardWiring, LeavesWhatTheUserHasWired) {
  WiredDevice unit;
  ASSERT_EQ(unit.wire(2, 1070, {1024, drive::kOwnObject, 0}), 0U);
  ASSERT_EQ(unit.write_parameter(2, 844, 1, 4), 0U);
  ASSERT_EQ(unit.wire(2, 8851, {2139, drive::kOwnObject, 0}, 3), 0U);
  ASSERT_EQ(unit.wire(2, 1513, {8850, drive::kOwnObject, 3}), 0U);
  unit.unmap_all();
  EXPECT_EQ(unit.parameter(1070), own(1024));
  EXPECT_EQ(unit.parameter(844), 1.0);
  EXPECT_EQ(unit.parameter(840), own(8795, 0)) << "the others follow";
  EXPECT_EQ(unit.parameter(8851, 3), own(2139));
  EXPECT_EQ(unit.parameter(1513), own(8850, 3));
  unit.map_rpdo(1, {kVelocity, kControlword});
  EXPECT_EQ(unit.parameter(1070), own(1024));
  EXPECT_EQ(unit.parameter(844), 1.0);
  EXPECT_EQ(unit.parameter(840), own(8892, 0));
}

TEST(StandardWiring, FollowsAgainWhatTheUserHasWiredBack) {
  WiredDevice unit;
  ASSERT_EQ(unit.write_parameter(2, 1070, 0, 4), 0U);
  unit.unmap_all();
  unit.map_rpdo(3, {kFiller, kVelocity});
  EXPECT_EQ(unit.parameter(1070), 0.0);
  ASSERT_EQ(unit.wire(2, 1070, {8860, drive::kOwnObject, 1}), 0U);  // where 60FFh lies now
  unit.map_rpdo(3, {});
  EXPECT_EQ(unit.parameter(1070), own(8796));
}

TEST(P8790, ConnectsTheControlwordWhereItLies) {
  WiredDevice unit;
  for (const Command& command : kCommands) ASSERT_EQ(unit.write_parameter(2, command.input, 0, 4), 0U);
  ASSERT_EQ(unit.write_parameter(2, 8790, 0, 2), 0U);
  for (const Command& command : kCommands) EXPECT_EQ(unit.parameter(command.input), 0.0);
  ASSERT_EQ(unit.write_parameter(2, 8790, 1, 2), 0U);
  expect_commands_at(unit, 8890);
}

TEST(P8790, LeavesTheControlwordAloneWhileItIs0) {
  WiredDevice unit;
  ASSERT_EQ(unit.write_parameter(2, 8790, 0, 2), 0U);
  unit.unmap_all();
  expect_commands_at(unit, 8890);
  unit.map_rpdo(1, {kFiller, kControlword});
  expect_commands_at(unit, 8890);
  ASSERT_EQ(unit.write_parameter(2, 8790, 1, 2), 0U);
  expect_commands_at(unit, 8891);
}

TEST(P8790, IsRefusedWhereTheControlwordHasNoBits) {
  constexpr std::uint32_t kNotNow = 0x08000022;
  WiredDevice unit;
  unit.unmap_all();
  EXPECT_EQ(unit.write_parameter(2, 8790, 1, 2), kNotNow) << "not mapped";
  unit.map_rpdo(1, {kFiller, kFiller + 0x10000, kFiller + 0x20000, kFiller + 0x30000});
  unit.map_rpdo(2, {kControlword});
  EXPECT_EQ(unit.write_parameter(2, 8790, 1, 2), kNotNow) << "in the fifth word";
  EXPECT_EQ(unit.write_parameter(2, 8790, 2, 2), 0x06090031U);
  EXPECT_EQ(unit.write_parameter(1, 8790, 1, 2), 0x06020000U) << "the control unit has none";
}

TEST(StandardWiring, FollowsAMappingWhileTheUnitRests) {
  WiredDevice unit;
  unit.passes(1s);
  const std::uint16_t statusword = unit.statusword();
  ASSERT_EQ(unit.write_parameter(2, 8851, 0, 4, 0), 0U);
  unit.passes(1s);
  ASSERT_EQ(unit.statusword(), 0U) << "unwired";
  unit.unmap_all();
  unit.passes(1s);
  EXPECT_EQ(unit.statusword(), statusword) << "not mapped, it shows the drive";
}

}  // namespace
}  // namespace device
