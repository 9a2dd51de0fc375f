// BICO inputs: what they can be connected to, and that what comes from there acts in the next cycle.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "drive/wiring.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr double kWord = 0x4000;
constexpr double kDoubleWord = 0x40000000;

struct BitInput {
  std::uint16_t number;
  bool AxisInputs::*input;
};
const std::vector<BitInput> kBitInputs{
    {840, &AxisInputs::on},
    {844, &AxisInputs::no_off2},
    {845, &AxisInputs::no_off2_second},
    {848, &AxisInputs::no_off3},
    {849, &AxisInputs::no_off3_second},
    {852, &AxisInputs::enable_operation},
    {854, &AxisInputs::control_by_plc},
    {856, &AxisInputs::enable_speed_controller},
    {864, &AxisInputs::infeed_operates},
    {1020, &AxisInputs::fixed_setpoint_bit_0},
    {1021, &AxisInputs::fixed_setpoint_bit_1},
    {1022, &AxisInputs::fixed_setpoint_bit_2},
    {1023, &AxisInputs::fixed_setpoint_bit_3},
    {1055, &AxisInputs::jog_1},
    {1056, &AxisInputs::jog_2},
    {1110, &AxisInputs::inhibit_negative},
    {1111, &AxisInputs::inhibit_positive},
    {1113, &AxisInputs::invert_setpoint},
    {1122, &AxisInputs::bypass_ramp},
    {1140, &AxisInputs::enable_ramp},
    {1141, &AxisInputs::continue_ramp},
    {1142, &AxisInputs::enable_setpoint},
    {1143, &AxisInputs::set_ramp},
    {1501, &AxisInputs::torque_control},
    {2103, &AxisInputs::acknowledge_1},
    {2104, &AxisInputs::acknowledge_2},
    {2105, &AxisInputs::acknowledge_3},
    {2106, &AxisInputs::no_external_fault_1},
    {2107, &AxisInputs::no_external_fault_2},
    {2108, &AxisInputs::no_external_fault_3},
    {2112, &AxisInputs::no_external_alarm_1},
};

struct ValueInput {
  std::uint16_t number;
  double AxisInputs::*input;
  std::uint16_t reference;
  double si;  ///< of one unit of the reference
};
const std::vector<ValueInput> kValueInputs{
    {1070, &AxisInputs::main_setpoint, 2000, kRpm},
    {1075, &AxisInputs::supplementary_setpoint, 2000, kRpm},
    {1085, &AxisInputs::forward_limit, 2000, kRpm},
    {1088, &AxisInputs::backward_limit, 2000, kRpm},
    {1144, &AxisInputs::ramp_setting, 2000, kRpm},
    {1155, &AxisInputs::speed_setpoint_1, 2000, kRpm},
    {1160, &AxisInputs::speed_setpoint_2, 2000, kRpm},
    {1503, &AxisInputs::torque_setpoint, 2003, 1.0},
    {1511, &AxisInputs::supplementary_torque_1, 2003, 1.0},
    {1513, &AxisInputs::supplementary_torque_2, 2003, 1.0},
    {1522, &AxisInputs::upper_torque_limit, 2003, 1.0},
    {1523, &AxisInputs::lower_torque_limit, 2003, 1.0},
};

/// Inputs that act elsewhere: messages of the statusword, acknowledgement of the unit, process data, converters.
const std::set<std::uint16_t> kOtherInputs{2102, 2151, 8746, 8748, 8785, 8786, 8787, 8851,
                                           8861, 8880, 8881, 8882, 8883, 8884, 8899};
/// Inputs of functions that the drive does not have yet.
bool is_of_positioner(std::uint16_t number) {
  return number == 2200 || (number >= 2510 && number <= 2663);
}

/// The drive objects that a source can lie on, seen from axis X.
const std::vector<std::uint8_t> kObjects{kOwnObject, kX, kY, kUnit};
std::uint8_t real(std::uint8_t object) { return object == kOwnObject ? kX : object; }

TEST(Wiring, HasEveryInputOfTheParameterList) {
  std::set<std::uint16_t> known = kOtherInputs;
  for (const BitInput& row : kBitInputs) known.insert(row.number);
  for (const ValueInput& row : kValueInputs) known.insert(row.number);

  for (const ObjectKind kind : {ObjectKind::Servo, ObjectKind::Vector, ObjectKind::ControlUnit})
    for (const PlacedRow& placed : parameters_of(kind)) {
      if (!is_bico_input(placed.row->type) || is_of_positioner(placed.row->number)) continue;
      EXPECT_TRUE(known.contains(placed.row->number)) << parameter_text(*placed.row);
    }
}

TEST(Wiring, BringsEveryBitInTheNextCycleFromItsOwnAxisAnotherOneAndTheControlUnit) {
  for (const BitInput& row : kBitInputs)
    for (const std::uint8_t object : kObjects)
      for (const auto& [word, bit] : {std::pair{0, 4}, std::pair{3, 15}}) {
        WiredUnit wired;
        wired.wire(kX, row.number, {static_cast<std::uint16_t>(8890 + word), object, static_cast<std::uint16_t>(bit)});
        for (const bool on : {true, false, true}) {
          wired.receives(real(object), static_cast<std::size_t>(word), static_cast<std::uint16_t>(on ? 1U << bit : 0U));
          wired.cycles();
          EXPECT_EQ(wired.axis(kX).inputs().*row.input, on) << "p" << row.number << " on object " << int{object};
        }
      }
}

TEST(Wiring, BringsEveryConstantBit) {
  for (const BitInput& row : kBitInputs)
    for (const bool one : {false, true}) {
      WiredUnit wired;
      wired.set(kX, row.number, one);
      wired.cycles();
      EXPECT_EQ(wired.axis(kX).inputs().*row.input, one) << "p" << row.number;
    }
}

TEST(Wiring, BringsEveryValueInTheNextCycleFromItsOwnAxisAnotherOneAndTheControlUnit) {
  for (const ValueInput& row : kValueInputs)
    for (const std::uint8_t object : kObjects) {
      WiredUnit wired;
      const double full = wired.read(kX, row.reference) * row.si;
      const double tolerance = 1e-6 * full;

      wired.wire(kX, row.number, {8850, object, 5});
      wired.receives(real(object), 5, 0x2000);
      wired.cycles();
      EXPECT_NEAR(wired.axis(kX).inputs().*row.input, full / 2, tolerance) << "p" << row.number;
      wired.receives(real(object), 5, 0x8000);
      wired.cycles();
      EXPECT_NEAR(wired.axis(kX).inputs().*row.input, -2 * full, tolerance) << "p" << row.number;

      wired.wire(kX, row.number, {8860, object, 7});
      wired.receives_double_word(real(object), 7, 0xE0000000);
      wired.cycles();
      EXPECT_NEAR(wired.axis(kX).inputs().*row.input, -full / 2, tolerance) << "p" << row.number;
    }
}

TEST(Wiring, BringsAHundredPercentOfTheConstantOne) {
  for (const ValueInput& row : kValueInputs) {
    WiredUnit wired;
    wired.set(kX, row.number, true);
    wired.cycles();
    EXPECT_NEAR(wired.axis(kX).inputs().*row.input, wired.read(kX, row.reference) * row.si, 1e-3) << row.number;
    wired.set(kX, row.number, false);
    wired.cycles();
    EXPECT_EQ(wired.axis(kX).inputs().*row.input, 0.0) << row.number;
  }
}

TEST(Wiring, TakesTheShareOfTheSourcesReferenceForTheOwnOne) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 2000, 3000.0), std::nullopt);
  ASSERT_EQ(wired.write(kY, 2000, 500.0), std::nullopt);
  ASSERT_EQ(wired.write(kY, 1001, 100.0), std::nullopt);
  wired.wire(kX, 1070, {1001, kY, 0});
  wired.cycles();
  EXPECT_NEAR(wired.axis(kX).inputs().main_setpoint, 600.0 * kRpm, 1e-3) << "20 % of 500 rpm is 20 % of 3000 rpm";

  ASSERT_EQ(wired.write(kY, 2000, 1000.0), std::nullopt);
  wired.cycles();
  EXPECT_NEAR(wired.axis(kX).inputs().main_setpoint, 300.0 * kRpm, 1e-3) << "a new reference acts in the next cycle";
  ASSERT_EQ(wired.write(kX, 2000, 1500.0), std::nullopt);
  wired.cycles();
  EXPECT_NEAR(wired.axis(kX).inputs().main_setpoint, 150.0 * kRpm, 1e-3);
}

TEST(Wiring, LetsEveryConnectorBeSentAsAWordOfItsReference) {
  struct Scale {
    Unit unit;
    std::uint16_t reference;
  };
  const std::vector<Scale> scales{{Unit::Rpm, 2000},         {Unit::Volts, 2001},       {Unit::VoltsRms, 2001},
                                  {Unit::Amperes, 2002},     {Unit::AmperesRms, 2002},  {Unit::NewtonMetre, 2003},
                                  {Unit::Kilowatts, 2004},   {Unit::Degrees, 2005},     {Unit::Celsius, 2006},
                                  {Unit::RevolutionsPerSecondSquared, 2007}};
  WiredUnit wired;
  wired.receives_double_word(kX, 1, 0x10000000);
  wired.switch_on(kX);
  wired.cycles(50);
  std::size_t sources = 0;
  for (const PlacedRow& placed : parameters_of(ObjectKind::Servo)) {
    const ParameterRow& row = *placed.row;
    if (row.output == Output::No) continue;
    ++sources;
    for (std::size_t i = 0; i < row.count; ++i) {
      wired.wire(kX, 8861, {row.number, kOwnObject, static_cast<std::uint16_t>(i)}, 6);
      wired.unit.send_process_data();
      const auto sent = static_cast<std::int32_t>(static_cast<std::uint32_t>(wired.read(kX, 8863, 6)));
      const double value = wired.axis(kX).read(row.number, i).value();
      const auto scale = std::find_if(scales.begin(), scales.end(), [&](const Scale& s) { return s.unit == row.unit; });
      if (scale == scales.end()) continue;
      const double expected = value / wired.read(kX, scale->reference) * kDoubleWord;
      EXPECT_NEAR(sent, std::clamp(expected, -2147483648.0, 2147483647.0), 128.0) << parameter_text(row) << '[' << i << ']';
    }
  }
  EXPECT_GT(sources, 100U);
}

TEST(Wiring, LetsEveryWordBeReadBitByBit) {
  WiredUnit wired;
  wired.switch_on(kX);
  for (const PlacedRow& placed : parameters_of(ObjectKind::Servo)) {
    const ParameterRow& row = *placed.row;
    if (row.output != Output::Both || row.number == 8889 || row.number == 8843) continue;
    const unsigned bits = 8U * row_of(row.type).size;
    for (unsigned bit = 0; bit < bits; ++bit) {
      wired.wire(kX, 8880, {row.number, kOwnObject, static_cast<std::uint16_t>(bit)}, bit % 16);
      if (bit % 16 != 15 && bit != bits - 1) continue;
      const auto before = static_cast<std::uint32_t>(wired.axis(kX).read(row.number).value());
      wired.unit.exchange_process_data();
      const unsigned first = bit / 16 * 16;
      const std::uint32_t mask = (1U << (bit - first + 1)) - 1U;
      EXPECT_EQ(static_cast<std::uint32_t>(wired.read(kX, 8889, 0)) & mask, before >> first & mask) << parameter_text(row);
    }
  }
}

TEST(Wiring, TakesTheStateOfTheInterfaceBitByBit) {
  WiredUnit wired;
  wired.wire(kX, 1020, {8843, kOwnObject, 0});
  wired.wire(kX, 1021, {8843, kOwnObject, 2});
  wired.unit.object(kX)->process_data().interface_state = {false, false, true};
  wired.cycles();
  EXPECT_FALSE(wired.axis(kX).inputs().fixed_setpoint_bit_0);
  EXPECT_TRUE(wired.axis(kX).inputs().fixed_setpoint_bit_1);
  EXPECT_EQ(wired.write(kX, 1022, pack({8843, kOwnObject, 3})), Refusal::IllegalSource);
}

TEST(Wiring, RefusesWhatIsNoSource) {
  const std::uint32_t fine = pack({8890, kOwnObject, 0});
  struct Case {
    std::uint16_t input;
    BicoSource source;
    const char* why;
  };
  const std::vector<Case> cases{
      {840, {8850, kOwnObject, 0}, "a connector has no bits"},
      {840, {1024, kOwnObject, 0}, "neither has a speed"},
      {840, {8890, kOwnObject, 16}, "a word has 16 bits"},
      {840, {8890, 4, 0}, "there is no third axis"},
      {840, {8890, 0, 0}, "there is no drive object 0"},
      {840, {8889, kOwnObject, 1023}, "no such bit"},
      {840, {3, kOwnObject, 0}, "no parameter"},
      {840, {840, kOwnObject, 0}, "an input is no source"},
      {840, {0, kOwnObject, 2}, "no constant"},
      {840, {722, kOwnObject, 0}, "the digital inputs are on the control unit"},
      {1070, {8860, kOwnObject, 19}, "the last double word begins at word 18"},
      {1070, {8850, kOwnObject, 20}, "20 words are received"},
      {1070, {1120, kOwnObject, 0}, "a time is no connector"},
      {1070, {1070, kOwnObject, 0}, "an input is no source"},
      {1070, {8860, 62, 0}, "no such drive object"},
      {1070, {9999, kY, 0}, "no parameter"},
      {1070, {1024, kUnit, 0}, "the control unit has no fixed setpoints"},
  };
  for (const Case& c : cases) {
    WiredUnit wired;
    ASSERT_EQ(wired.write(kX, 840, fine), std::nullopt);
    const double before = wired.read(kX, c.input);
    EXPECT_EQ(wired.write(kX, c.input, pack(c.source)), Refusal::IllegalSource) << c.why;
    EXPECT_EQ(wired.read(kX, c.input), before) << c.why;
  }
  WiredUnit wired;
  EXPECT_EQ(wired.write(kX, 840, 2.0), Refusal::IllegalSource) << "0 and 1 are the constants";
  EXPECT_EQ(wired.write(kX, 8851, 1.0, 25), Refusal::NoIndex);
  EXPECT_EQ(wired.write(kUnit, 2102, pack({722, kOwnObject, 3})), std::nullopt);
}

TEST(Wiring, ChangesInOperation) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 1120, 0.0), std::nullopt);
  wired.receives_double_word(kX, 1, 0x10000000);  // p1070 of a new axis
  wired.switch_on(kX);
  wired.cycles(200);
  ASSERT_NEAR(wired.rpm(kX), 0.25 * wired.read(kX, 2000), 1.0);

  wired.receives_double_word(kY, 3, 0x08000000);
  wired.wire(kX, 1070, {8860, kY, 3});
  wired.cycles();
  EXPECT_NEAR(wired.axis(kX).inputs().main_setpoint, 0.125 * wired.read(kX, 2000) * kRpm, 1e-3);
  ASSERT_EQ(wired.write(kX, 1121, 0.0), std::nullopt);
  wired.cycles(250);
  EXPECT_NEAR(wired.rpm(kX), 0.125 * wired.read(kX, 2000), 1.0);

  wired.set(kX, 844, false);
  wired.cycles();
  EXPECT_EQ(wired.state(kX), State::SwitchOnDisabled) << "OFF2";
}

TEST(Wiring, LetsOneAxisFollowAnother) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 1120, 0.5), std::nullopt);
  ASSERT_EQ(wired.write(kY, 1120, 0.0), std::nullopt);
  wired.wire(kY, 840, {899, kX, 2});   // ON while X operates
  wired.wire(kY, 1070, {1170, kX, 0});  // X's setpoint behind its ramp
  wired.set(kY, 844, true);
  wired.set(kY, 848, true);
  wired.set(kY, 852, true);
  wired.receives_double_word(kX, 1, 0x10000000);
  wired.cycles(2);
  ASSERT_EQ(wired.state(kY), State::ReadyToSwitchOn);

  wired.switch_on(kX);
  wired.cycles(500);
  EXPECT_EQ(wired.state(kY), State::OperationEnabled);
  EXPECT_NEAR(wired.rpm(kY), wired.rpm(kX), 0.5);
  EXPECT_NEAR(wired.rpm(kY), 0.25 * wired.read(kX, 2000), 1.0);
}

TEST(Wiring, HasWhatLiesOnAnAxisOfTheLastCycleAndWhatTheBusBroughtOfThisOne) {
  WiredUnit wired;
  wired.wire(kY, 1070, {1024, kX, 0});
  wired.wire(kX, 1020, {8891, kOwnObject, 0});
  ASSERT_EQ(wired.write(kX, 1001, 100.0), std::nullopt);
  const double share = 100.0 / wired.read(kX, 2000) * wired.read(kY, 2000) * kRpm;

  wired.receives(kX, 1, 1);
  wired.cycles();
  EXPECT_NEAR(wired.read(kX, 1024), 100.0, 1e-3) << "chosen in the cycle, in whatever state";
  EXPECT_EQ(wired.axis(kY).inputs().main_setpoint, 0.0);
  wired.cycles();
  EXPECT_NEAR(wired.axis(kY).inputs().main_setpoint, share, 1e-3);
}

TEST(Wiring, ConvertsWordsToBitsBeforeTheInputsOfTheSameCycle) {
  WiredUnit wired;
  wired.wire(kX, 8899, {8850, kOwnObject, 7});
  wired.wire(kX, 8899, {8850, kUnit, 0}, 1);
  ASSERT_EQ(wired.write(kX, 8898, 0x0001, 1), std::nullopt);
  wired.wire(kX, 840, {8894, kOwnObject, 3});
  wired.wire(kY, 1113, {8895, kX, 0});

  wired.receives(kX, 7, 0x0008);
  wired.cycles();
  EXPECT_EQ(wired.read(kX, 8894), 0x0008);
  EXPECT_EQ(wired.read(kX, 8895), 0x0001);
  EXPECT_TRUE(wired.axis(kX).inputs().on);
  EXPECT_TRUE(wired.axis(kY).inputs().invert_setpoint) << "inverted";
  wired.receives(kUnit, 0, 0x0001);
  wired.receives(kX, 7, 0xFFF7);
  wired.cycles();
  EXPECT_FALSE(wired.axis(kX).inputs().on);
  EXPECT_FALSE(wired.axis(kY).inputs().invert_setpoint);
}

TEST(Wiring, SendsInTheSameCycleTheWordsThatAreMadeOfBits) {
  WiredUnit wired;
  for (std::uint16_t converter = 0; converter < 5; ++converter) {
    const auto input = static_cast<std::uint16_t>(8880 + converter);
    wired.wire(kX, input, {899, kOwnObject, 2}, converter);  // operation enabled
    wired.wire(kX, input, {899, kY, 2}, 15);
    wired.wire(kX, 8851, {8889, kOwnObject, converter}, 10U + converter);
    ASSERT_EQ(wired.write(kX, 8888, 0x0100, converter), std::nullopt);
  }
  wired.cycles();
  EXPECT_EQ(wired.read(kX, 8853, 12), 0x0100) << "inverted";

  wired.command(kX, 0x0006);
  wired.command(kX, 0x0007);
  wired.receives(kX, 0, 0x000F);
  wired.cycles();
  ASSERT_EQ(wired.state(kX), State::OperationEnabled);
  for (std::size_t converter = 0; converter < 5; ++converter)
    EXPECT_EQ(wired.read(kX, 8853, 10 + converter), 0x0100U + (1U << converter)) << "in the cycle itself";
  wired.switch_on(kY);
  EXPECT_EQ(wired.read(kX, 8853, 10), 0x8101);
}

TEST(Wiring, BringsBitsOfTheStatusword) {
  for (const auto& [input, bit] : {std::pair{8785, 8}, std::pair{8786, 14}, std::pair{8787, 15}}) {
    WiredUnit wired;
    const auto number = static_cast<std::uint16_t>(input);
    wired.cycles(2);
    EXPECT_EQ(wired.axis(kX).actual().statusword >> bit & 1, 0);
    wired.wire(kX, number, {8890, kY, 5});
    wired.receives(kY, 0, 0x0020);
    wired.cycles();
    EXPECT_EQ(wired.axis(kX).actual().statusword >> bit & 1, 1) << "p" << input;
    wired.set(kX, number, false);
    wired.cycles();
    EXPECT_EQ(wired.axis(kX).actual().statusword >> bit & 1, 0) << "p" << input;
  }
}

TEST(Wiring, AcknowledgesOnEveryEdgeOfEveryInput) {
  for (const auto& [object, input] : {std::pair{kX, 2103}, std::pair{kX, 2104}, std::pair{kX, 2105}, std::pair{kUnit, 2102}}) {
    WiredUnit wired;
    wired.wire(object, static_cast<std::uint16_t>(input), {8892, kY, 9});
    wired.cycles(2);
    ASSERT_TRUE(wired.axis(kX).raise(7860));
    wired.cycles(2);
    ASSERT_EQ(wired.state(kX), State::Fault);
    wired.receives(kY, 2, 0x0200);
    wired.cycles(2);
    EXPECT_NE(wired.state(kX), State::Fault) << "p" << input;
    ASSERT_TRUE(wired.axis(kX).raise(7860));
    wired.cycles(2);
    EXPECT_EQ(wired.state(kX), State::Fault) << "the level does not acknowledge: p" << input;
  }
}

TEST(Wiring, WakesAnAxisThatRestsWhenItsSourceChanges) {
  WiredUnit wired;
  wired.wire(kY, 840, {8890, kX, 11});
  wired.set(kY, 844, true);
  wired.set(kY, 848, true);
  wired.cycles(10);
  ASSERT_TRUE(wired.axis(kY).is_quiescent());
  ASSERT_EQ(wired.state(kY), State::ReadyToSwitchOn);

  wired.awake = {true, false};
  wired.receives(kX, 0, 0x0800);
  wired.cycles();
  EXPECT_EQ(wired.state(kY), State::SwitchedOn);
  wired.set(kY, 852, true);
  wired.cycles();
  EXPECT_EQ(wired.state(kY), State::OperationEnabled);
}

TEST(Wiring, LetsAnAxisThatWasWokenGoOn) {
  WiredUnit wired;
  wired.set(kY, 844, true);
  wired.set(kY, 848, true);
  wired.set(kY, 852, true);
  ASSERT_EQ(wired.write(kY, 1120, 0.0), std::nullopt);
  wired.wire(kY, 840, {8890, kX, 11});
  wired.wire(kY, 1070, {8860, kX, 5});
  wired.cycles(10);
  ASSERT_TRUE(wired.axis(kY).is_quiescent());

  wired.awake = {true, false};
  wired.receives(kX, 0, 0x0800);
  wired.receives_double_word(kX, 5, 0x10000000);
  wired.cycles(250);
  EXPECT_NEAR(wired.rpm(kY), 0.25 * wired.read(kY, 2000), 1.0);
}

TEST(Wiring, ShowsTheStatusBitsOfAnAxisThatRests) {
  WiredUnit wired;
  wired.wire(kY, 8786, {8890, kX, 11});
  wired.cycles(10);
  ASSERT_TRUE(wired.axis(kY).is_quiescent());

  wired.awake = {true, false};
  wired.receives(kX, 0, 0x0800);
  wired.cycles();
  EXPECT_NE(wired.axis(kY).actual().statusword & 0x4000, 0);
}

TEST(Wiring, TakesTheSetpointOfTheMessagesFromAnySource) {
  WiredUnit wired;
  wired.receives_double_word(kX, 1, 0x08000000);
  ASSERT_EQ(wired.write(kX, 1120, 0.0), std::nullopt);
  wired.switch_on(kX);
  wired.cycles(250);
  EXPECT_NE(wired.axis(kX).actual().statusword & 0x0400, 0) << "target reached";

  wired.wire(kX, 2151, {8860, kY, 0});
  wired.receives_double_word(kY, 0, 0x20000000);
  wired.cycles(100);
  EXPECT_EQ(wired.axis(kX).actual().statusword & 0x0400, 0);
}

TEST(Wiring, GivesNothingToAnInputThatIsUnwired) {
  WiredUnit wired;
  wired.set(kX, 8851, false);
  wired.cycles(2);
  EXPECT_EQ(wired.read(kX, 8853, 0), 0.0);
  wired.set(kX, 8851, true);
  wired.cycles();
  EXPECT_EQ(wired.read(kX, 8853, 0), kWord);
}

}  // namespace
}  // namespace drive
