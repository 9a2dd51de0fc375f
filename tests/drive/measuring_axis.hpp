#pragma once

#include <string>
#include <vector>

#include "tests/drive/messages.hpp"
#include "tests/drive/test_axis.hpp"
#include "tests/motor/identification/random_plants.hpp"

namespace drive {

/// A machine that differs from its data sheet in everything.
inline constexpr motor::PlantDeviation kOther{.stator_resistance = 1.2,
                                              .d_inductance = 0.85,
                                              .q_inductance = 1.15,
                                              .magnet_flux = 0.9,
                                              .rotor_resistance = 1.15,
                                              .stator_leakage = 0.9,
                                              .rotor_leakage = 0.9,
                                              .magnetising_inductance = 0.85,
                                              .saturation_flux = 0.9,
                                              .inertia = 1.2,
                                              .friction = 1.2};

/// A real machine with the data sheet of preset @p name: @p deviation from it, dead times in its inverter.
inline AxisConfiguration real_axis(const std::string& name, const motor::PlantDeviation& deviation = {},
                                   const motor::Load& load = {}) {
  const motor::MachineData& machine = identification::preset(name);
  return {.machine = machine,
          .load = load,
          .kind = machine.type == motor::MachineType::Induction ? ObjectKind::Vector : ObjectKind::Servo,
          .inverter = identification::real_inverter(machine),
          .deviation = deviation};
}

inline constexpr std::uint16_t kP1900 = 1900;
inline constexpr std::uint16_t kP1910 = 1910;
inline constexpr std::uint16_t kP1960 = 1960;

/// An axis that is commissioned by a master.
struct MeasuringAxis : TestAxis {
  static constexpr double kLongest = 200.0;  // s, of any measurement

  explicit MeasuringAxis(const AxisConfiguration& configuration) : TestAxis{configuration} {
    if (configuration.kind == ObjectKind::Vector) {
      EXPECT_TRUE(axis.write(1300, 21.0));
    }
    send(0x0006), send(0x0006);
  }

  double shown(std::uint16_t number, std::size_t index = 0) const { return axis.read(number, index).value(); }
  bool has(std::uint16_t number) const { return has_message(axis, number); }
  /// OFF1, then ON.
  void on() {
    for (const int word : {0x0006, 0x0006, 0x0007, 0x000F}) send(static_cast<std::uint16_t>(word));
  }
  /// Selects by @p parameter, gives ON and waits for the end; returns how long that took (s).
  double measure(std::uint16_t parameter, double value = 1.0) {
    EXPECT_TRUE(axis.write(parameter, value));
    on();
    EXPECT_TRUE(state() == State::OperationEnabled || !axis.messages().faults().empty()) << "or fails at once";
    return wait();
  }
  double wait() {
    return run_until([](const Axis& a) { return a.actual().state != State::OperationEnabled; }, kLongest);
  }
  /// The refusal of a write; NoParameter if it is taken.
  Refusal refusal_of(std::uint16_t number, double value) {
    const auto written = axis.write(number, value);
    return written ? Refusal::NoParameter : written.error().reason;
  }
  /// The active fault @p number, or nullptr.
  const FaultEntry* fault(std::uint16_t number) const {
    for (const FaultEntry& entry : axis.messages().faults())
      if (entry.row->number == number) return &entry;
    return nullptr;
  }
  /// Every saved value.
  std::vector<double> parameters() const {
    std::vector<double> values;
    for (const PlacedRow& placed : parameters_of(axis.kind()))
      for (std::size_t i = 0; is_saved(*placed.row) && i < placed.row->count; ++i)
        values.push_back(axis.value(placed, i));
    return values;
  }
};

}  // namespace drive
