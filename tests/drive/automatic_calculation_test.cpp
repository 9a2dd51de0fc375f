/// p0340: what each of its values computes, and that it leaves everything else alone.
#include <map>
#include <numbers>
#include <set>

#include "drive/machine/machine_model.hpp"
#include "motor/control/field/induction_circuit.hpp"
#include "tests/drive/measuring_axis.hpp"

namespace drive {
namespace {

using Numbers = std::set<std::uint16_t>;

const Numbers kCircuit{320, 350, 354, 356, 358, 360, 362, 363, 364, 365, 366, 367, 368, 369};
const Numbers kSynchronousCircuit{350, 356, 357};
const Numbers kInertia{341};
const Numbers kControllers{1460, 1462, 1470, 1472};
const Numbers kLimits{640, 1082, 1520, 1521, 1530, 1531, 2162};

Numbers all_of(std::initializer_list<Numbers> sets) {
  Numbers all;
  for (const Numbers& set : sets) all.insert(set.begin(), set.end());
  return all;
}

/// The parameters that p0340 = @p choice changes where all that it could compute are not what they should be, with
/// p0301 = @p code.
Numbers computed_by(const std::string& motor, double choice, double code = 0.0) {
  MeasuringAxis drive{real_axis(motor)};
  EXPECT_TRUE(drive.axis.write(10, 3.0));
  EXPECT_TRUE(drive.axis.write(301, code));
  EXPECT_TRUE(drive.axis.write(10, 0.0));
  for (const std::uint16_t number : all_of({kCircuit, {357}, kInertia, kControllers, kLimits})) {
    const double value = drive.shown(number);
    const double share = number == 341 ? 0.9 : 0.97;  // p1460 goes with p0341
    if (std::abs(value) > 0.0) {
      EXPECT_TRUE(drive.axis.write(number, share * value)) << number;
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
  EXPECT_EQ(computed_by("1le1003-2k2", 1.0), all_of({kCircuit, kInertia, kControllers, kLimits}));
  EXPECT_EQ(computed_by("1le1003-2k2", 2.0), kCircuit);
  EXPECT_EQ(computed_by("1le1003-2k2", 3.0), all_of({kControllers, kLimits}));
  EXPECT_EQ(computed_by("1le1003-2k2", 4.0), kControllers);
  EXPECT_EQ(computed_by("1le1003-2k2", 5.0), kLimits);
}

TEST(AutomaticCalculation, ComputesForASynchronousMotorWhatEachValueNames) {
  EXPECT_EQ(computed_by("1fk7063", 1.0), all_of({kSynchronousCircuit, kInertia, kControllers, kLimits}));
  EXPECT_EQ(computed_by("1fk7063", 2.0), kSynchronousCircuit);
  EXPECT_EQ(computed_by("1fk7063", 3.0), all_of({kControllers, kLimits}));
  EXPECT_EQ(computed_by("1fk7063", 4.0), kControllers);
  EXPECT_EQ(computed_by("1fk7063", 5.0), kLimits);
}

TEST(AutomaticCalculation, LeavesTheDataOfAMotorOfTheList) {
  constexpr double kCode = 12345.0;
  for (const char* const motor : {"1fk7063", "1le1003-2k2"}) {
    EXPECT_EQ(computed_by(motor, 1.0, kCode), all_of({kControllers, kLimits})) << motor;
    EXPECT_EQ(computed_by(motor, 2.0, kCode), Numbers{}) << motor;
    EXPECT_EQ(computed_by(motor, 4.0, kCode), kControllers) << motor;
  }
}

TEST(AutomaticCalculation, TakesTheNumberOfASeriesForItsKind) {
  constexpr std::uint16_t kImplausible = 7950;
  for (const auto& [motor, type, fits] : {std::tuple{"1fk7063", 237.0, true},
                                          {"1fk7063", 100.0, false},
                                          {"1fk7063", 10000.0, true},
                                          {"1fk7063", 5.0, false},
                                          {"1le1003-2k2", 10.0, true},
                                          {"1le1003-2k2", 200.0, false}}) {
    MeasuringAxis drive{real_axis(motor)};
    ASSERT_TRUE(drive.axis.write(10, 3.0));
    ASSERT_TRUE(drive.axis.write(300, type));
    ASSERT_TRUE(drive.axis.write(10, 0.0));
    drive.run(0.1);
    EXPECT_EQ(drive.has(kImplausible), !fits) << motor << " as " << type;
  }
}

/// A servo of which a master has told nothing but the plate.
struct UnknownServo : MeasuringAxis {
  explicit UnknownServo(const std::string& motor) : MeasuringAxis{real_axis(motor)} {
    for (const std::uint16_t number : std::initializer_list<std::uint16_t>{341, 342, 350, 356})
      EXPECT_TRUE(axis.write(number, 1.0));
    EXPECT_TRUE(axis.write(340, 1.0));
  }
  void expect_about(std::uint16_t number, double wanted) const {
    EXPECT_GT(shown(number), 0.5 * wanted) << 'p' << number;
    EXPECT_LT(shown(number), 2.0 * wanted) << 'p' << number;
  }
};

class PlateOfAServo : public testing::TestWithParam<const char*> {
 protected:
  const motor::MachineData& data_sheet_ = identification::preset(GetParam());
};

TEST_P(PlateOfAServo, GivesDataOfTheRightOrderAndAControlThatRuns) {
  UnknownServo drive{GetParam()};
  drive.expect_about(341, data_sheet_.inertia);
  drive.expect_about(350, data_sheet_.stator_resistance);
  drive.expect_about(356, 1e3 * data_sheet_.synchronous.q_inductance);
  drive.expect_about(357, 1e3 * data_sheet_.synchronous.d_inductance);
  const double rated = data_sheet_.rated_speed / kRpm;
  drive.turn_at(0.5 * rated);
  EXPECT_NEAR(drive.rpm(), 0.5 * rated, 0.005 * rated);
}

TEST_P(PlateOfAServo, IsEnoughToMeasureTheRest) {
  UnknownServo drive{GetParam()};
  drive.measure(kP1910);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_NEAR(drive.shown(350), data_sheet_.stator_resistance, 0.02 * data_sheet_.stator_resistance);
  EXPECT_NEAR(drive.shown(356), 1e3 * data_sheet_.synchronous.q_inductance,
              30.0 * data_sheet_.synchronous.q_inductance);
  drive.measure(kP1960);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
  EXPECT_NEAR(drive.shown(341) * drive.shown(342), data_sheet_.inertia, 0.02 * data_sheet_.inertia);
}

INSTANTIATE_TEST_SUITE_P(Presets, PlateOfAServo, testing::Values("1fk7042", "1fk7063", "1ft7044", "ipmsm-2k2"));

TEST(AutomaticCalculation, LeavesWhatItCannotComputeAlone) {
  MeasuringAxis drive{real_axis("1fk7063")};
  const double inertia = drive.shown(341), inductance = drive.shown(356);
  ASSERT_TRUE(drive.axis.write(10, 3.0));
  for (const std::uint16_t number : std::initializer_list<std::uint16_t>{304, 307})
    ASSERT_TRUE(drive.axis.write(number, 0.0));
  ASSERT_TRUE(drive.axis.write(340, 1.0));
  EXPECT_EQ(drive.shown(341), inertia);
  EXPECT_EQ(drive.shown(356), inductance);
}

TEST(SeriesInductance, IsPartOfWhatTheControlSeesAndNotOfWhatP1910Finds) {
  constexpr double kSeries = 2.0;  // mH
  for (const char* const motor : {"1fk7063", "1le1003-2k2"}) {
    const motor::MachineData& data_sheet = identification::preset(motor);
    MeasuringAxis drive{real_axis(motor)};
    const motor::MachineData before = believed_machine(drive.axis.block<MotorModel>().settings, data_sheet);
    ASSERT_TRUE(drive.axis.write(353, kSeries));
    const motor::MachineData after = believed_machine(drive.axis.block<MotorModel>().settings, data_sheet);
    if (before.type == motor::MachineType::Synchronous) {
      EXPECT_NEAR(after.synchronous.q_inductance - before.synchronous.q_inductance, 1e-3 * kSeries, 1e-9);
      EXPECT_NEAR(after.synchronous.d_inductance - before.synchronous.d_inductance, 1e-3 * kSeries, 1e-9);
    } else {
      EXPECT_NEAR(after.induction.stator_leakage - before.induction.stator_leakage, 1e-3 * kSeries, 1e-9);
    }
  }
  MeasuringAxis drive{real_axis("1fk7063")};
  const double inductance = drive.shown(356);
  ASSERT_TRUE(drive.axis.write(353, kSeries));
  drive.measure(kP1910);
  EXPECT_NEAR(drive.shown(1934), inductance, 0.03 * inductance) << "all that there is";
  EXPECT_NEAR(drive.shown(356), inductance - kSeries, 0.03 * inductance);
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
    const motor::MachineData believed = believed_machine(drive.axis.block<MotorModel>().settings, data_sheet);
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
    return motor::standing_flux(
        motor::induction_circuit(believed_machine(drive.axis.block<MotorModel>().settings, data_sheet)),
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
