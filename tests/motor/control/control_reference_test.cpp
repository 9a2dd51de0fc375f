// The product's own controllers, set to the bandwidths of the references a1, b1 and c1: other laws, so metrics are
// held against each other and not samples.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "motor/drive_train.hpp"
#include "tests/motor/reference/reference_file.hpp"
#include "tests/motor/reference/reference_plant.hpp"

namespace motor {
namespace {

using reference::File;
using reference::Table;

constexpr double kSteady = 0.005;  // bands of vectors/README.md: share of the range of the column
constexpr double kPeak = 0.05;     // share of the peak
constexpr double kTime = 0.10;     // share of the time

/// Part of a recording of one column.
struct Stretch {
  const Table& table;
  double start;
  double end;

  template <class Visit>
  void each(std::string_view column, Visit visit) const {
    const std::vector<double>& time = table.abscissa();
    const std::vector<double>& values = table.column(column);
    for (std::size_t i = 0; i < time.size(); ++i)
      if (time[i] >= start - 1e-9 && time[i] <= end + 1e-9) visit(time[i], values[i]);
  }
  /// The value furthest from 0 in the direction of @p sign.
  double peak(std::string_view column, double sign) const {
    double best = -1e300;
    each(column, [&](double, double value) { best = std::max(best, sign * value); });
    return sign * best;
  }
  double last(std::string_view column) const {
    double result = 0.0;
    each(column, [&](double, double value) { result = value; });
    return result;
  }
  /// When the column has gone @p share of its way from its first to its last value, after the start (s).
  double reached(std::string_view column, double share) const {
    double first = 0.0;
    bool begun = false;
    double when = -1.0;
    const double final = last(column);
    each(column, [&](double time, double value) {
      if (!begun) first = value;
      begun = true;
      if (when < 0.0 && std::abs(value - first) >= share * std::abs(final - first)) when = time - start;
    });
    return when;
  }
  /// When the column was furthest in the direction of @p sign, after the start (s).
  double time_of_peak(std::string_view column, double sign) const {
    const double highest = peak(column, sign);
    double when = -1.0;
    each(column, [&](double time, double value) {
      if (when < 0.0 && sign * value >= sign * highest) when = time - start;
    });
    return when;
  }
};

/// The same stretch of reference and own recording. With AXISD_PHYSICS_OUT set to a folder each metric is appended
/// to metrics.csv there.
struct Pair {
  std::string name;
  Stretch theirs;
  Stretch ours;

  void hold(std::string_view column, std::string_view metric, double mine, double reference, double band) const {
    EXPECT_NEAR(mine, reference, band) << column << ", " << metric << " from " << theirs.start << " s";
    const char* const folder = std::getenv("AXISD_PHYSICS_OUT");
    if (folder == nullptr) return;
    std::ofstream{std::filesystem::path{folder} / "metrics.csv", std::ios::app}
        << name << ',' << column << ',' << metric << ',' << theirs.start << ',' << reference << ',' << mine << ','
        << band << '\n';
  }
  void same_end(std::string_view column, double range) const {
    hold(column, "end", ours.last(column), theirs.last(column), kSteady * range);
  }
  void same_peak(std::string_view column, double sign) const {
    const double peak = theirs.peak(column, sign);
    hold(column, "peak", ours.peak(column, sign), peak, kPeak * std::abs(peak));
  }
  /// The largest deviation from the last value, which a load step makes.
  void same_dip(std::string_view column) const {
    const double dip = theirs.last(column) - theirs.peak(column, -1.0);
    hold(column, "dip", ours.last(column) - ours.peak(column, -1.0), dip, kPeak * dip);
  }
  void same_rise(std::string_view column) const {
    const double rise = theirs.reached(column, 0.9) - theirs.reached(column, 0.1);
    const double until = theirs.reached(column, 0.9);
    hold(column, "10..90 %", ours.reached(column, 0.9) - ours.reached(column, 0.1), rise, kTime * rise);
    hold(column, "until 90 %", ours.reached(column, 0.9), until, kTime * until);
  }
  void same_time_of_peak(std::string_view column, double sign) const {
    const double when = theirs.time_of_peak(column, sign);
    hold(column, "time of peak", ours.time_of_peak(column, sign), when, kTime * when);
  }
};

Pair between(const File& file, const Table& ours, double start, double end) {
  return {file.name, {file.table, start, end}, {ours, start, end}};
}

/// Settings with the bandwidths of @p file.
ControlSettings settings_of(const File& file, const MachineData& machine) {
  ControlSettings settings = computed_settings(machine, {.maximum_current = 1000.0}, machine.inertia);
  const double scale = file.number("/controller/alpha_c") / kCurrentBandwidth;
  settings.current.d_proportional *= scale;
  settings.current.q_proportional *= scale;
  const double gain = file.number("/controller/speed_Kp");
  settings.speed = {.proportional = gain, .integral_time = gain / file.number("/controller/speed_Ki")};
  settings.current_limit = file.number("/controller/i_max") / std::numbers::sqrt2;
  settings.acceleration_precontrol = 1.0;
  return settings;
}

/// Smooths a stepped speed setpoint (p1416) with the bandwidth of the reference's two-degree-of-freedom law.
class SetpointFilter {
 public:
  explicit SetpointFilter(double bandwidth) : share_{-std::expm1(-bandwidth * kControlPeriod)} {}
  void apply(double target, DriveCommand& command) {
    const double change = share_ * (target - command.speed_setpoint);
    command.speed_setpoint += change;
    command.acceleration_setpoint = change / kControlPeriod;
  }

 private:
  double share_;
};

constexpr int kRowSteps = 4;

/// Runs until the reference ends; @p lead sets the command and the load at a time.
Table record(DriveTrain& train, const File& file, double dc_voltage,
             const std::function<void(double, DriveCommand&)>& lead) {
  Table result{{"t_s", "w_M_rad_s", "T_e_Nm", "i_d_A", "i_q_A", "i_A"}};
  const double end = file.table.abscissa().back();
  const double torque = file.about["controller"].value("T_max", 1e3);
  DriveCommand command{.pulses_enabled = true, .limits = {torque, -torque}};
  const int steps = static_cast<int>(std::lround(end / kControlPeriod));
  for (int i = 0; i <= steps; ++i) {
    const Signals& now = train.signals();
    if (i % kRowSteps == 0)
      result.append(
          {i * kControlPeriod, now.true_speed, now.true_torque, now.d_current, now.q_current, now.current});
    lead(i * kControlPeriod, command);
    train.step(dc_voltage, command);
  }
  return result;
}

TEST(ControlReference, SalientSynchronousMachineUnderSpeedControl) {
  const File file{"a1_pmsm_motulator"};
  const MachineData machine = reference::synchronous_machine(file);
  DriveTrain train{machine, {}};
  train.tune(settings_of(file, machine));
  SetpointFilter filter{file.number("/controller/alpha_s")};

  const Table ours = record(train, file, 540.0, [&](double time, DriveCommand& command) {
    filter.apply(time >= 0.1 - 1e-9 ? file.number("/stimulus/w_ref") : 0.0, command);
    train.set_load_torque(time >= 0.6 - 1e-9 ? file.number("/stimulus/T_load") : 0.0);
  });

  const Pair run_up = between(file, ours, 0.1, 0.5995);
  run_up.same_rise("w_M_rad_s");
  run_up.same_peak("T_e_Nm", 1.0);
  run_up.same_peak("i_q_A", 1.0);
  run_up.same_peak("i_d_A", -1.0);
  run_up.same_end("w_M_rad_s", 78.54);
  run_up.same_end("T_e_Nm", 20.9);
  const Pair load = between(file, ours, 0.6, 0.9995);
  load.same_dip("w_M_rad_s");
  load.same_time_of_peak("w_M_rad_s", -1.0);
  load.same_end("w_M_rad_s", 78.54);
  load.same_end("T_e_Nm", 20.9);
  load.same_end("i_d_A", 1.72);
  load.same_end("i_q_A", 8.14);
}

TEST(ControlReference, InductionMachineUnderSpeedControl) {
  const File file{"c1_im_cvc_motulator"};
  MachineData machine = reference::induction_machine(file);
  const double flux = file.table.column("psi_R_abs_Vs").back();
  machine.induction.magnetising_current = flux / file.number("/plant/L_M") / std::numbers::sqrt2;
  DriveTrain train{machine, {}};
  train.tune(settings_of(file, machine));
  SetpointFilter filter{file.number("/controller/alpha_s")};

  const Table ours = record(train, file, 540.0, [&](double time, DriveCommand& command) {
    const double half = file.number("/stimulus/speed_ref_steps/0/1");
    filter.apply(time >= 1.0 - 1e-9 ? -half : time >= 0.2 - 1e-9 ? half : 0.0, command);
    train.set_load_torque(time >= 0.6 - 1e-9 ? file.number("/stimulus/load_steps/0/1") : 0.0);
  });

  const Pair run_up = between(file, ours, 0.2, 0.599);
  run_up.same_rise("w_M_rad_s");
  run_up.same_peak("T_e_Nm", 1.0);
  run_up.same_end("w_M_rad_s", 78.54);
  const Pair load = between(file, ours, 0.6, 0.999);
  load.same_dip("w_M_rad_s");
  load.same_time_of_peak("w_M_rad_s", -1.0);
  load.same_end("w_M_rad_s", 78.54);
  load.same_end("T_e_Nm", 21.7);
  load.same_end("i_q_A", 8.9);
  const Pair reversal = between(file, ours, 1.0, 1.8);
  reversal.same_rise("w_M_rad_s");
  reversal.same_peak("T_e_Nm", -1.0);
  reversal.same_end("w_M_rad_s", 78.54);
  reversal.same_end("T_e_Nm", 21.7);
}

/// The reference leaves the circle of the voltage, which this inverter does not: a DC link that holds the voltage
/// within it makes both comparable.
TEST(ControlReference, InductionMachineUnderVoltageFrequencyControl) {
  const File file{"b1_im_vhz_motulator"};
  const MachineData machine = reference::induction_machine(file);
  DriveTrain train{machine, {.fan_coefficient = file.number("/plant/quad")}};
  ControlSettings settings = computed_settings(machine, {.maximum_current = 1000.0}, machine.inertia);
  settings.mode = ControlMode::VoltageFrequency;
  settings.current_limit = 100.0;
  const double rated = 2.0 * std::numbers::pi * 50.0;
  settings.voltage_frequency = {.rated_voltage = std::sqrt(1.5) * file.number("/controller/psi_s_nom") * rated,
                                .rated_frequency = 50.0};
  train.tune(settings);

  const Table ours = record(train, file, 570.0, [&](double time, DriveCommand& command) {
    const double slope = file.number("/controller/slew_rad_s2");
    const double target = file.number("/stimulus/speed_ref_steps/0/1");
    command.speed_setpoint = std::clamp(slope * (time - 0.1), 0.0, target);
    train.set_load_torque(time >= 1.2 - 1e-9 ? file.number("/stimulus/load_steps/0/1") : 0.0);
  });

  const Pair run_up = between(file, ours, 0.1, 1.199);
  run_up.same_rise("w_M_rad_s");
  run_up.same_peak("w_M_rad_s", 1.0);
  run_up.same_end("w_M_rad_s", 150.9);
  const Pair load = between(file, ours, 1.2, 1.5);
  load.same_end("w_M_rad_s", 150.9);
  load.same_dip("w_M_rad_s");
}

}  // namespace
}  // namespace motor
