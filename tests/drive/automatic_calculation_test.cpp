/// p0340: what each of its values computes, and that it leaves everything else alone.
#include <map>
#include <numbers>
#include <set>

#include "drive/machine_model.hpp"
#include "motor/induction_circuit.hpp"
#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

using Numbers = std::set<std::uint16_t>;

const Numbers kCircuit{320, 350, 354, 356, 358, 360, 362, 363, 364, 365, 366, 367, 368, 369};
const Numbers kControllers{1460, 1462, 1470, 1472};
const Numbers kLimits{640, 1082, 1520, 1521, 1530, 1531, 2162};

Numbers all_of(std::initializer_list<Numbers> sets) {
  Numbers all;
  for (const Numbers& set : sets) all.insert(set.begin(), set.end());
  return all;
}

/// The parameters that p0340 = @p choice changes where all that it could compute are not what they should be.
Numbers computed_by(const std::string& motor, double choice) {
  MeasuringAxis drive{real_axis(motor)};
  for (const std::uint16_t number : all_of({kCircuit, {357}, kControllers, kLimits})) {
    const double value = drive.shown(number);
    if (std::abs(value) > 0.0) {
      EXPECT_TRUE(drive.axis.write(number, 0.97 * value)) << number;
    }
  }
  const auto kept = [&] {
    std::map<std::uint16_t, double> values;
    for (const PlacedRow& placed : parameters_of(drive.axis.kind()))
      if (is_saved(*placed.row)) values[placed.row->number] = drive.axis.value(placed, 0);
    return values;
  };
  const auto before = kept();
  EXPECT_TRUE(drive.axis.write(340, choice));
  EXPECT_EQ(drive.shown(340), 0.0);
  Numbers changed;
  for (const auto& [number, value] : kept())
    if (std::abs(value - before.at(number)) > 1e-9 * std::abs(value)) changed.insert(number);
  return changed;
}

TEST(AutomaticCalculation, ComputesForAnInductionMotorWhatEachValueNames) {
  EXPECT_EQ(computed_by("1le1003-2k2", 0.0), Numbers{});
  EXPECT_EQ(computed_by("1le1003-2k2", 1.0), all_of({kCircuit, kControllers, kLimits}));
  EXPECT_EQ(computed_by("1le1003-2k2", 2.0), kCircuit);
  EXPECT_EQ(computed_by("1le1003-2k2", 3.0), all_of({kControllers, kLimits}));
  EXPECT_EQ(computed_by("1le1003-2k2", 4.0), kControllers);
  EXPECT_EQ(computed_by("1le1003-2k2", 5.0), kLimits);
}

TEST(AutomaticCalculation, ComputesForASynchronousMotorWhatEachValueNames) {
  EXPECT_EQ(computed_by("1fk7063", 1.0), all_of({kControllers, kLimits}));
  EXPECT_EQ(computed_by("1fk7063", 2.0), Numbers{});
  EXPECT_EQ(computed_by("1fk7063", 3.0), all_of({kControllers, kLimits}));
  EXPECT_EQ(computed_by("1fk7063", 4.0), kControllers);
  EXPECT_EQ(computed_by("1fk7063", 5.0), kLimits);
}

TEST(AutomaticCalculation, KeepsTheRatioOfTheInductancesOfASynchronousMotor) {
  MeasuringAxis drive{real_axis("ipmsm-2k2")};
  const double ratio = drive.shown(357) / drive.shown(356);
  ASSERT_LT(ratio, 0.9) << "salient";
  ASSERT_TRUE(drive.axis.write(356, 2.0 * drive.shown(356)));
  ASSERT_TRUE(drive.axis.write(340, 1.0));
  EXPECT_NEAR(drive.shown(357) / drive.shown(356), ratio, 1e-6);
}

TEST(AutomaticCalculation, TakesTheCharacteristicOfAPlateAsAStraightLine) {
  MeasuringAxis drive{real_axis("1ph8131")};
  ASSERT_GT(drive.shown(369), 130.0);
  ASSERT_TRUE(drive.axis.write(340, 1.0));
  for (std::uint16_t number = 362; number < 366; ++number)
    EXPECT_NEAR(drive.shown(static_cast<std::uint16_t>(number + 4)), drive.shown(number), 1e-6) << number;
}

TEST(MagnetisingCharacteristic, GivesTheControlTheSaturationOfTheDataSheet) {
  for (const char* const motor : {"1le1003-2k2", "1ph8131", "im-2k2"}) {
    const MeasuringAxis drive{real_axis(motor)};
    const motor::MachineData& data_sheet = identification::preset(motor);
    const motor::MachineData believed = believed_machine(drive.axis.parameters(), data_sheet);
    EXPECT_NEAR(believed.induction.saturation_flux, data_sheet.induction.saturation_flux, 1e-6) << motor;
    EXPECT_EQ(drive.shown(362), 60.0);
    EXPECT_EQ(drive.shown(365), 125.0);
  }
}

TEST(MagnetisingCharacteristic, IsWhatTheControlFollowsWithoutPassingThroughEveryPoint) {
  const motor::MachineData& data_sheet = identification::preset("1ph8131");
  MeasuringAxis drive{real_axis("1ph8131")};
  const double current = std::numbers::sqrt2 * data_sheet.induction.magnetising_current;
  const auto flux = [&](double share) {
    return motor::standing_flux(motor::induction_circuit(believed_machine(drive.axis.parameters(), data_sheet)),
                                share * current);
  };
  const double unsaturated = flux(0.2) / 0.2;

  ASSERT_TRUE(drive.axis.write(369, 210.0));
  EXPECT_LT(flux(1.0), 0.98 * unsaturated) << "more saturation";
  EXPECT_NEAR(flux(0.2) / 0.2, unsaturated, 1e-3 * unsaturated);
  for (const auto& [number, value] : {std::pair{366, 60.0}, {367, 85.0}, {368, 115.0}, {369, 125.0}})
    ASSERT_TRUE(drive.axis.write(static_cast<std::uint16_t>(number), value));
  EXPECT_NEAR(flux(1.0), unsaturated, 1e-4 * unsaturated) << "a straight line";
  for (const int number : {366, 367, 368, 369})
    ASSERT_TRUE(drive.axis.write(static_cast<std::uint16_t>(number), 800.0));
  EXPECT_GT(flux(1.0), 0.0) << "nonsense has an end";
}

}  // namespace
}  // namespace drive
