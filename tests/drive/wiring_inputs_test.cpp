// Every BICO input from every kind of drive object, and every source as a value and bit by bit.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "drive/wiring.hpp"
#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

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

/// Inputs that act elsewhere: encoder interface, scaling of the torque limits, digital outputs, messages of the
/// statusword, acknowledgement of the unit, its clock, sign of life, process data, converters.
const std::set<std::uint16_t> kOtherInputs{480,  738,  739,  740,  741,  742,  743,  744,  745,  1542,
                                           1552, 1554, 2045, 2051, 2061, 2080, 2081, 2082, 2083, 2084,
                                           2099, 2102, 2151, 3104, 3116, 8746, 8748, 8785, 8786, 8787,
                                           8851, 8861, 8880, 8881, 8882, 8883, 8884, 8899, 806};
/// Inputs of position control and the positioner, which have tests of their own.
bool is_of_positioner(std::uint16_t number) {
  return number == 1545 || (number >= 2508 && number <= 2663) || number == 2730;
}

/// The drive objects that a source can lie on, seen from axis X.
const std::vector<std::uint8_t> kObjects{kOwnObject, kX, kY, kUnit};
std::uint8_t real(std::uint8_t object) {
  return object == kOwnObject ? kX : object;
}

TEST(WiringInputs, HasEveryInputOfTheParameterList) {
  std::set<std::uint16_t> known = kOtherInputs;
  for (const BitInput& row : kBitInputs) known.insert(row.number);
  for (const ValueInput& row : kValueInputs) known.insert(row.number);

  for (const ObjectKind kind :
       {ObjectKind::Servo, ObjectKind::Vector, ObjectKind::ControlUnit, ObjectKind::Infeed})
    for (const PlacedRow& placed : parameters_of(kind)) {
      if (!is_bico_input(placed.row->type) || is_of_positioner(placed.row->number)) continue;
      if (std::holds_alternative<Stored>(placed.row->home)) continue;
      EXPECT_TRUE(known.contains(placed.row->number)) << parameter_text(*placed.row);
    }
}

TEST(WiringInputs, BringsEveryBitInTheNextCycleFromItsOwnAxisAnotherOneAndTheControlUnit) {
  for (const BitInput& row : kBitInputs)
    for (const std::uint8_t object : kObjects)
      for (const auto& [word, bit] : {std::pair{0, 4}, std::pair{3, 15}}) {
        WiredUnit wired;
        wired.wire(kX, row.number,
                   {static_cast<std::uint16_t>(8890 + word), object, static_cast<std::uint16_t>(bit)});
        for (const bool on : {true, false, true}) {
          wired.receives(real(object), static_cast<std::size_t>(word),
                         static_cast<std::uint16_t>(on ? 1U << bit : 0U));
          wired.cycles();
          EXPECT_EQ(inputs_of(wired.axis(kX)).*row.input, on) << "p" << row.number << " on object " << int{object};
        }
      }
}

TEST(WiringInputs, BringsEveryConstantBit) {
  for (const BitInput& row : kBitInputs)
    for (const bool one : {false, true}) {
      WiredUnit wired;
      wired.set(kX, row.number, one);
      wired.cycles();
      EXPECT_EQ(inputs_of(wired.axis(kX)).*row.input, one) << "p" << row.number;
    }
}

TEST(WiringInputs, BringsEveryValueInTheNextCycleFromItsOwnAxisAnotherOneAndTheControlUnit) {
  for (const ValueInput& row : kValueInputs)
    for (const std::uint8_t object : kObjects) {
      WiredUnit wired;
      const double full = wired.read(kX, row.reference) * row.si;
      const double tolerance = 1e-6 * full;

      wired.wire(kX, row.number, {8850, object, 5});
      wired.receives(real(object), 5, 0x2000);
      wired.cycles();
      EXPECT_NEAR(inputs_of(wired.axis(kX)).*row.input, full / 2, tolerance) << "p" << row.number;
      wired.receives(real(object), 5, 0x8000);
      wired.cycles();
      EXPECT_NEAR(inputs_of(wired.axis(kX)).*row.input, -2 * full, tolerance) << "p" << row.number;

      wired.wire(kX, row.number, {8860, object, 7});
      wired.receives_double_word(real(object), 7, 0xE0000000);
      wired.cycles();
      EXPECT_NEAR(inputs_of(wired.axis(kX)).*row.input, -full / 2, tolerance) << "p" << row.number;
    }
}

TEST(WiringInputs, BringsAHundredPercentOfTheConstantOne) {
  for (const ValueInput& row : kValueInputs) {
    WiredUnit wired;
    wired.set(kX, row.number, true);
    wired.cycles();
    EXPECT_NEAR(inputs_of(wired.axis(kX)).*row.input, wired.read(kX, row.reference) * row.si, 1e-3) << row.number;
    wired.set(kX, row.number, false);
    wired.cycles();
    EXPECT_EQ(inputs_of(wired.axis(kX)).*row.input, 0.0) << row.number;
  }
}

TEST(WiringInputs, TakesTheShareOfTheSourcesReferenceForTheOwnOne) {
  WiredUnit wired;
  ASSERT_EQ(wired.write(kX, 2000, 3000.0), std::nullopt);
  ASSERT_EQ(wired.write(kY, 2000, 500.0), std::nullopt);
  ASSERT_EQ(wired.write(kY, 1001, 100.0), std::nullopt);
  wired.wire(kX, 1070, {1001, kY, 0});
  wired.cycles();
  EXPECT_NEAR(inputs_of(wired.axis(kX)).main_setpoint, 600.0 * kRpm, 1e-3)
      << "20 % of 500 rpm is 20 % of 3000 rpm";

  ASSERT_EQ(wired.write(kY, 2000, 1000.0), std::nullopt);
  wired.cycles();
  EXPECT_NEAR(inputs_of(wired.axis(kX)).main_setpoint, 300.0 * kRpm, 1e-3)
      << "a new reference acts in the next cycle";
  ASSERT_EQ(wired.write(kX, 2000, 1500.0), std::nullopt);
  wired.cycles();
  EXPECT_NEAR(inputs_of(wired.axis(kX)).main_setpoint, 150.0 * kRpm, 1e-3);
}

TEST(WiringInputs, LetsEveryConnectorBeSentAsAWordOfItsReference) {
  struct Scale {
    Unit unit;
    std::uint16_t reference;
  };
  const std::vector<Scale> scales{{Unit::Rpm, 2000},        {Unit::Volts, 2001},
                                  {Unit::VoltsRms, 2001},   {Unit::Amperes, 2002},
                                  {Unit::AmperesRms, 2002}, {Unit::NewtonMetre, 2003},
                                  {Unit::Kilowatts, 2004},  {Unit::Degrees, 2005},
                                  {Unit::Celsius, 2006},    {Unit::RevolutionsPerSecondSquared, 2007}};
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
      const auto scale =
          std::find_if(scales.begin(), scales.end(), [&](const Scale& s) { return s.unit == row.unit; });
      if (scale == scales.end()) continue;
      const double expected = value / wired.read(kX, scale->reference) * kDoubleWord;
      EXPECT_NEAR(sent, std::clamp(expected, -2147483648.0, 2147483647.0), 128.0)
          << parameter_text(row) << '[' << i << ']';
    }
  }
  EXPECT_GT(sources, 100U);
}

TEST(WiringInputs, LetsEveryWordBeReadBitByBit) {
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
      EXPECT_EQ(static_cast<std::uint32_t>(wired.read(kX, 8889, 0)) & mask, before >> first & mask)
          << parameter_text(row);
    }
  }
}

}  // namespace
}  // namespace drive
