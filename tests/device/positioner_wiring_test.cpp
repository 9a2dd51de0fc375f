// The ready wirings of the positioner: PDOs, what comes in them, and what is sent.
#include "device/process_data/positioner_wiring.hpp"

#include <array>

#include "tests/device/storage_fixture.hpp"
#include "tests/device/wired_device.hpp"

namespace device {
namespace {

constexpr std::array kAll{PositionerWiring::Mdi, PositionerWiring::Blocks, PositionerWiring::Telegram110,
                          PositionerWiring::Telegram111};

/// A unit of @p axes, all of them wired; a setup of @p axis with nothing else said.
Configuration wired(PositionerWiring wiring, std::size_t axes = 1, const drive::AxisConfiguration& axis = {}) {
  Configuration configuration = unit_of(axes);
  for (std::size_t i = 0; i < axes; ++i) {
    configuration.axes[i].drive = axis;
    configuration.axes[i].drive.positioner = true;
    configuration.axes[i].delivery = delivery_of(wiring, {.module = static_cast<std::uint8_t>(i),
                                                          .node_id = 5,
                                                          .kind = axis.kind,
                                                          .setpoint_channel = axis.setpoint_channel});
  }
  return configuration;
}

/// All that the wiring of axis @p axis (from 1) of @p configuration sets.
std::vector<ParameterPreset> values_of(const Configuration& configuration, std::size_t axis = 1) {
  const Delivery& delivery = configuration.axes[axis - 1].delivery;
  std::vector<ParameterPreset> all = delivery.identity;
  all.insert(all.end(), delivery.values.begin(), delivery.values.end());
  return all;
}

/// What @p unit has of @p configuration, and whether its PDOs can be used.
void expect_wired(WiredDevice& unit, const Configuration& configuration) {
  for (std::size_t axis = 1; axis <= configuration.axes.size(); ++axis)
    for (const ParameterPreset& preset : values_of(configuration, axis))
      EXPECT_EQ(unit.parameter(preset.number, preset.index, axis), preset.value)
          << "p" << preset.number << '[' << int{preset.index} << "] of axis " << axis;
  unit.enter();
  unit.cycle();
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  EXPECT_EQ(unit.read_parameter(1, 2132), 0U) << "alarm";
}

TEST(PositionerWiring, IsOfANewUnitWhateverItsAxesAre) {
  for (const PositionerWiring wiring : kAll)
    for (const drive::AxisConfiguration& axis :
         {drive::AxisConfiguration{}, drive::AxisConfiguration{.kind = drive::ObjectKind::Vector},
          drive::AxisConfiguration{.setpoint_channel = false}}) {
      const Configuration configuration = wired(wiring, 2, axis);
      WiredDevice unit{configuration};
      expect_wired(unit, configuration);
    }
}

TEST(PositionerWiring, LiesOverEverythingThatWasSavedWithOtherMappings) {
  WiredDevice former;
  former.unmap_all();
  former.map_rpdo(1, {0x58000010, 0x60400010, 0x60FF0020});
  former.map_tpdo(1, {0x60410010, 0x606C0020});
  ASSERT_EQ(former.wire(2, 8851, {1024, drive::kOwnObject, 0}, 2), 0U);
  ASSERT_EQ(former.wire(2, 2646, {8850, drive::kOwnObject, 0}), 0U);
  ASSERT_EQ(former.parameter(840), own(8891, 0));
  ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);
  for (const PositionerWiring wiring : kAll) {
    const Configuration configuration = wired(wiring);
    NextLife life{former, configuration};
    const drive::Axis& axis = life.unit.device.axis();
    for (const ParameterPreset& preset : values_of(configuration))
      EXPECT_EQ(axis.read(preset.number, preset.index).value(), preset.value)
          << "p" << preset.number << '[' << int{preset.index} << ']';
    EXPECT_EQ(axis.read(1070).value(), own(8796)) << "no word of the positioner is a speed";
  }
}

TEST(PositionerWiring, LeavesWhatTheUserHasChangedAndSaved) {
  const Configuration configuration = wired(PositionerWiring::Mdi);
  WiredDevice former{configuration};
  ASSERT_EQ(former.wire(2, 2612, {722, 1, 3}), 0U);
  ASSERT_EQ(former.write_parameter(2, 2633, 0, 4), 0U);
  ASSERT_EQ(former.download(0x1401, 1, 0x80000305, 4), 0U);
  ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);
  ASSERT_EQ(former.write_parameter(2, 2596, 0, 4), 0U) << "not saved";

  NextLife next{former, configuration};
  for (const char* const how : {"power-on", "reset"}) {
    const drive::Axis& axis = next.unit.device.axis();
    EXPECT_EQ(axis.read(2612).value(), drive::pack({722, 1, 3})) << how;
    EXPECT_EQ(axis.read(2633).value(), 0.0) << how;
    EXPECT_EQ(axis.read(8701).value(), 0x80000305) << how;
    EXPECT_EQ(axis.read(2596).value(), own(8892, 1)) << how;
    EXPECT_EQ(axis.read(2642).value(), own(8860, 4)) << how;
    next.unit.says("000#8105");
    next.unit.passes(100ms);
  }
  ASSERT_EQ(next.unit.download(kRestore, 1, kLoad, 4), 0U);
  EXPECT_EQ(next.unit.device.axis().read(2612).value(), own(8892, 2));
  EXPECT_EQ(next.unit.device.axis().read(8701).value(), 0x305);
}

TEST(PositionerWiring, IsKnownAgainWithAMappingOfTheConfiguration) {
  Configuration configuration = wired(PositionerWiring::Mdi);
  configuration.axes[0].presets = {{8713, 0x58050010, 0}};
  WiredDevice former{configuration};
  ASSERT_EQ(former.wire(2, 2612, {722, 1, 3}), 0U);
  ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);
  NextLife next{former, configuration};
  EXPECT_EQ(next.unit.device.axis().read(8713).value(), 0x58050010);
  EXPECT_EQ(next.unit.device.axis().read(2612).value(), drive::pack({722, 1, 3}));
}

TEST(PositionerWiring, ComesBackWhereAMasterHasMappedTheNodeAndResetsIt) {
  const Configuration configuration = wired(PositionerWiring::Mdi);
  WiredDevice unit{configuration};
  unit.unmap_all();
  unit.says("000#8205");
  unit.passes(100ms);
  expect_wired(unit, configuration);
}

TEST(PositionerWiring, TakesThePlaceOfAnother) {
  for (const PositionerWiring before : kAll)
    for (const PositionerWiring after : kAll) {
      WiredDevice former{wired(before)};
      ASSERT_EQ(former.download(kStore, 1, kSave, 4), 0U);
      NextLife next{former, wired(after)};
      const WiredDevice fresh{wired(after)};
      for (const drive::PlacedRow& placed : drive::parameters_of(drive::ObjectKind::Servo)) {
        const drive::ParameterRow& row = *placed.row;
        if (!drive::is_saved(row) || row.type == drive::DataType::F32) continue;  // no connection
        for (std::size_t i = 0; i < row.count; ++i)
          EXPECT_EQ(next.unit.device.axis().kept_value(row.number, i).value(),
                    fresh.device.axis().kept_value(row.number, i).value())
              << 'p' << row.number << '[' << i << "] " << static_cast<int>(before) << static_cast<int>(after);
      }
    }
}

TEST(PositionerWiring, OfAFurtherAxisHasItsObjectsAndNoCobIds) {
  WiredDevice unit{wired(PositionerWiring::Mdi, 2)};
  EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x205U);
  EXPECT_EQ(unit.upload(0x1600, 0).number(), 4U);
  EXPECT_EQ(unit.upload(0x1403, 1).number(), 0x800006DFU) << "a fourth one is not used";
  EXPECT_EQ(unit.upload(0x1603, 0).number(), 0U);
  EXPECT_EQ(unit.upload(0x1440, 1).number(), 0x800006DFU);
  EXPECT_EQ(unit.upload(0x1640, 1).number(), 0x68400010U);
  EXPECT_EQ(unit.upload(0x1641, 1).number(), 0x58A00020U);
  EXPECT_EQ(unit.upload(0x1A40, 2).number(), 0x58900010U);
  EXPECT_EQ(unit.upload(0x1A41, 2).number(), 0x686C0020U);
}

TEST(PositionerWiring, OfMdiBringsItsWordsToTheirPlaces) {
  WiredDevice unit{wired(PositionerWiring::Mdi)};
  unit.enter();
  unit.says("205#3E0400810021FF7F");  // controlword, POS_STW1 = 8100h, POS_STW2 = 2100h, override
  unit.says("305#A086010070170000");  // 100000 LU, 6000 * 1000 LU/min
  unit.says("405#00200040");          // 50 %, 100 %
  unit.cycle();
  EXPECT_EQ(unit.read_parameter(2, 8890), 0x043EU);
  EXPECT_EQ(unit.read_parameter(2, 8891), 0x8100U);
  EXPECT_EQ(unit.read_parameter(2, 8892), 0x2100U);
  EXPECT_EQ(unit.read_parameter(2, 8850, 3), 0x7FFFU);
  EXPECT_EQ(unit.read_parameter(2, 8860, 4), 100000U);
  EXPECT_EQ(unit.read_parameter(2, 8860, 6), 6000U);
  EXPECT_EQ(unit.read_parameter(2, 8850, 8), 0x2000U);
  EXPECT_EQ(unit.read_parameter(2, 8850, 9), 0x4000U);
  EXPECT_EQ(unit.device.axis().read(2643).value(), own(8860, 6));
  EXPECT_EQ(unit.parameter(8851, 3), own(2681));
}

TEST(PositionerWiring, LeadsTheStateMachineAndLeavesBit8ToThePositioner) {
  WiredDevice unit{wired(PositionerWiring::Mdi)};
  unit.enter();
  for (const char* const word : {"3E04", "3F04"}) {
    unit.says(std::string{"205#"} + word + "000000000040");
    unit.cycle();
  }
  ASSERT_EQ(unit.statusword() & 0x006FU, 0x0027U);
  unit.says("205#3F05000000000040");  // jog 1 and no halt
  unit.cycle();
  EXPECT_EQ(unit.statusword() & 0x006FU, 0x0027U);
  EXPECT_EQ(unit.read_parameter(2, 8890) >> 8U & 1U, 1U);
  EXPECT_EQ(unit.upload(0x605D).number(), 0xFFFFU);
}

TEST(PositionerWiring, IsNotUndoneByTheStandardWiring) {
  const Configuration configuration = wired(PositionerWiring::Telegram111);
  WiredDevice unit{configuration};
  unit.enter();
  unit.leave();
  ASSERT_EQ(unit.write_parameter(2, 8790, 1, 2), 0U);
  unit.map_rpdo(5, {0x60FF0020});
  unit.map_rpdo(5, {});
  unit.cycle();
  expect_wired(unit, configuration);
}

TEST(PositionerWiring, SendsTheStatuswordBehindATelegram) {
  WiredDevice unit{wired(PositionerWiring::Telegram110)};
  unit.start_operational();
  const Lines sent = unit.cycles_with("205#3E04000000000000");
  const Lines first = from("185#", sent), second = from("285#", sent);
  ASSERT_FALSE(first.empty());
  ASSERT_FALSE(second.empty());
  EXPECT_EQ(second.back().size(), std::string_view{"285#0000000000000000"}.size());
  EXPECT_EQ(second.back().substr(16, 2), first.back().substr(4, 2)) << "ZSW1 and 6041h, whose lower bytes agree";
}

TEST(PositionerWiring, ComesBackWithARestore) {
  const Configuration configuration = wired(PositionerWiring::Blocks);
  WiredDevice unit{configuration};
  unit.unmap_all();
  ASSERT_EQ(unit.write_parameter(2, 2631, 0, 4), 0U);
  ASSERT_EQ(unit.download(kRestore, 1, kLoad, 4), 0U);
  unit.cycle();
  expect_wired(unit, configuration);
}

}  // namespace
}  // namespace device
