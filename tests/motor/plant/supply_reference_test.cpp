#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "motor/math/crossing.hpp"
#include "motor/plant/dc_link.hpp"
#include "motor/plant/encoder.hpp"
#include "motor/plant/machine/temperature.hpp"
#include "motor/plant/machine/thermal.hpp"
#include "motor/plant/power_unit.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace motor {
namespace {

using reference::Band;
using reference::expect_agreement;
using reference::File;
using reference::Table;

/// Value of a quantity that is held from each of the instants in a stimulus of the form [[time, value], ...].
double held(const nlohmann::json& steps, double time) {
  double value = 0.0;
  for (const auto& step : steps)
    if (step.at(0).get<double>() <= time) value = step.at(1).get<double>();
  return value;
}

/// Runs @p step from each row of @p file to the next and calls @p row at each, the first and last included.
template <class Step, class Row>
void walk(const File& file, const Step& step, const Row& row) {
  const std::vector<double>& times = file.table.abscissa();
  row(times.front());
  for (std::size_t i = 1; i < times.size(); ++i) {
    step(times[i - 1], times[i]);
    row(times[i]);
  }
}

/// The DC link of a reference file, on a line that gives the floor of its voltage.
DcLink link_of(const File& file) {
  const double floor = file.number("/plant/u_rect_floor");
  const auto& brake = file.about.at("plant").at("R_brake");
  return DcLink{{.line_voltage = floor / kRectifierRatio,
                 .line_resistance = 1e-3,
                 .capacitance = file.number("/plant/C_dc"),
                 .chopper_resistance = brake.is_null() ? 0.0 : brake.get<double>(),
                 .chopper_on = file.number("/plant/U_on"),
                 .chopper_off = file.number("/plant/U_off"),
                 .chopper_sampling = file.number("/event_resolution_s")}};
}

struct ChopperEvent {
  double time;
  bool on;
};

/// When in a step of @p dt (s) in which the axes draw @p energy (J) the chopper of @p link switches (s).
double switching_time(const DcLink& link, double dt, double energy) {
  return crossing(0.0, dt, [&](double time) {
    DcLink trial = link;
    trial.step(time, energy * time / dt);
    return trial.chopper_on() == link.chopper_on() ? -1.0 : 1.0;
  });
}

/// Brakes the machine of a g file into its DC link in control periods; what the chopper does goes to @p events.
Table brake_into(DcLink& link, const File& file, std::vector<ChopperEvent>& events) {
  constexpr double kPeriod = 125e-6;
  const double inertia = file.number("/plant/J");
  const double speed_at_start = file.number("/stimulus/w0");
  const double rate = file.number("/stimulus/decel_rad_s2");
  const auto kinetic = [&](double t) {
    return 0.5 * inertia * std::pow(std::max(0.0, speed_at_start - rate * t), 2);
  };
  Table ours{{"t_s", "u_dc_V", "E_chop_J"}};
  const auto step = [&](double from, double to) {
    const auto steps = static_cast<int>(std::lround((to - from) / kPeriod));
    for (int i = 0; i < steps; ++i) {
      const double t = from + i * kPeriod;
      const DcLink before = link;
      const double energy = kinetic(t + kPeriod) - kinetic(t) + file.number("/plant/P_loss") * kPeriod;
      link.step(kPeriod, energy);
      if (link.chopper_on() == before.chopper_on()) continue;
      events.push_back({t + switching_time(before, kPeriod, energy), link.chopper_on()});
    }
  };
  walk(file, step, [&](double t) { ours.append({t, link.voltage(), link.energies().chopper}); });
  return ours;
}

TEST(SupplyReference, DcLinkRisesWithTheEnergyThatIsFedBack) {
  const File file{"g1_dclink_nochop"};
  DcLink link = link_of(file);
  std::vector<ChopperEvent> events;

  expect_agreement(file, brake_into(link, file, events), Band::Target);

  EXPECT_TRUE(events.empty());
}

TEST(SupplyReference, ChopperHoldsTheDcLinkAndSwitchesAtTheInstantsOfTheReference) {
  const File file{"g2_dclink_chop"};
  DcLink link = link_of(file);
  std::vector<ChopperEvent> events;

  expect_agreement(file, brake_into(link, file, events), Band::Target);

  const auto& expected = file.about.at("events");
  ASSERT_EQ(events.size(), expected.size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_NEAR(1e3 * events[i].time, 1e3 * expected.at(i).at(0).get<double>(),
                file.number("/bands_target/event_ms"))
        << "event " << i;
    EXPECT_EQ(events[i].on, expected.at(i).at(1) == "on") << "event " << i;
  }
}

TEST(SupplyReference, MotorWarmsAsTwoBodies) {
  constexpr double kPeriod = 10e-3;
  const File file{"e1_thermal"};
  const ThermalData data{.winding_capacity = file.number("/plant/C_w_J_K"),
                         .frame_capacity = file.number("/plant/C_f_J_K"),
                         .winding_to_frame = file.number("/plant/G_wf_W_K"),
                         .frame_to_ambient = file.number("/plant/G_fa_W_K"),
                         .ambient = file.number("/plant/T_amb")};
  MotorThermal motor{data};
  MotorThermal linear{data};
  const double resistance = file.number("/plant/R_20");
  Table ours{{"t_s", "T_winding_C", "T_frame_C", "T_winding_lin_C", "T_frame_lin_C"}};

  const auto step = [&](double from, double to) {
    const double current = held(file.about.at("stimulus").at("I_rms_steps"), from);
    const double copper = 3.0 * resistance * current * current;
    const double iron = current > 0.0 ? file.number("/plant/P_fe_when_I_gt_0") : 0.0;
    const auto steps = static_cast<int>(std::lround((to - from) / kPeriod));
    for (int i = 0; i < steps; ++i) motor.step(kPeriod, copper * resistance_factor(motor.winding()), iron);
    linear.step(to - from, copper * resistance_factor(100.0 + kDataTemperature), iron);
  };
  walk(file, step, [&](double t) {
    ours.append({t, motor.winding(), motor.frame(), linear.winding(), linear.frame()});
  });

  expect_agreement(file, ours, Band::Target);
}

TEST(SupplyReference, PowerUnitAndMotorModelFollowTheSquareOfTheCurrent) {
  const File file{"e2_pu_i2t"};
  const auto parameter = [&](const char* name) { return file.number(std::string{"/parameters/"} + name); };
  PowerUnit unit{{.rated_current = parameter("I_N"),
                  .overload_time_constant = parameter("tau_i2t"),
                  .chip_time_constant = parameter("tau_chip"),
                  .chip_rise = parameter("dT_chip_at_IN"),
                  .heat_sink_time_constant = parameter("tau_hs"),
                  .heat_sink_rise = parameter("dT_hs_at_IN"),
                  .ambient = parameter("T_ambient")}};
  OverloadModel motor{{.reference_current = parameter("I0_motor"),
                       .time_constant = parameter("tau_motor"),
                       .rise = parameter("dT_motor_at_I0"),
                       .ambient = parameter("T_amb_motor")}};
  Table ours{{"t_s", "i2t_pu_percent", "T_chip_C", "T_heatsink_C", "i2t_motor_percent", "T_motor_i2t_C"}};

  const auto step = [&](double from, double to) {
    const double current = held(file.about.at("stimulus").at("I_rms_steps"), from);
    unit.step(to - from, current * current);
    motor.step(to - from, current * current);
  };
  walk(file, step, [&](double t) {
    ours.append({t, 100.0 * unit.overload(), unit.chip_temperature(), unit.heat_sink_temperature(),
                 100.0 * motor.utilisation(), motor.temperature()});
  });

  expect_agreement(file, ours, Band::Target);
}

TEST(SupplyReference, EncoderCountsEveryIncrement) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const File file{"j1_encoder"};
  MachineData machine;
  machine.encoder.pulses = static_cast<std::uint32_t>(file.number("/parameters/p0408"));
  machine.encoder.fine_bits = static_cast<std::uint8_t>(file.number("/parameters/p0418"));
  Encoder encoder{machine};
  encoder.configure(1e-3);
  const double acceleration = file.number("/stimulus/acc_rad_s2");
  const double rise = file.number("/stimulus/t_acc");
  const auto angle_at = [&](double t) {
    const double turning = std::min(t, rise);
    return acceleration * turning * (0.5 * turning + t - turning);
  };
  const std::int64_t per_quarter = (std::int64_t{1} << machine.encoder.fine_bits) / 4;
  const auto per_turn = static_cast<std::int64_t>(increments_per_revolution(machine));
  Table ours{{"t_s", "XIST1_counts", "incr_4x", "revolutions_zero_mark_count"}};

  const auto step = [&](double, double to) {
    const double angle = angle_at(to);
    const double whole = std::floor(angle / kTurn);
    encoder.move_to(static_cast<std::int64_t>(whole), angle - whole * kTurn);
  };
  walk(file, step, [&](double t) {
    const std::int64_t counts = encoder.counts();
    ours.append({t, static_cast<double>(counts), static_cast<double>(counts / per_quarter),
                 static_cast<double>(counts / per_turn)});
  });

  expect_agreement(file, ours, Band::Target);
  for (const reference::Deviation& d : reference::compare(file, ours)) EXPECT_EQ(d.max_absolute, 0.0) << d.column;
}

}  // namespace
}  // namespace motor
