#include "motor/validation/validation.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A way to spoil data that are possible, and what is then said of them.
template <class Data>
struct Spoilt {
  const char* name;
  void (*spoil)(Data&);
  const char* said;
};

/// "member: expectation", or "possible".
template <class Data>
std::string said_of(const Data& data) {
  const auto found = find_impossible(data);
  return found ? std::string{found->member} + ": " + std::string{found->expected} : "possible";
}

template <class Data, std::size_t count>
void expect_all(const Spoilt<Data> (&cases)[count], const Data& good = {}) {
  EXPECT_EQ(said_of(good), "possible");
  for (const Spoilt<Data>& c : cases) {
    Data data = good;
    c.spoil(data);
    EXPECT_EQ(said_of(data), c.said) << c.name;
  }
}

TEST(Validation, NamesWhatNoMachineCanBe) {
  using M = MachineData;
  const Spoilt<M> cases[] = {
      {"no inertia", [](M& m) { m.inertia = 0.0; }, "inertia: a number above 0"},
      {"inertia that is no number", [](M& m) { m.inertia = kNaN; }, "inertia: a number above 0"},
      {"negative resistance", [](M& m) { m.stator_resistance = -0.5; }, "stator_resistance: a number above 0"},
      {"no poles", [](M& m) { m.pole_pairs = 0; }, "pole_pairs: an integer 1 to 255"},
      {"rated above maximum speed", [](M& m) { m.rated_speed = 2.0 * m.maximum_speed; },
       "rated_speed: not more than the maximum speed"},
      {"rated above maximum current", [](M& m) { m.rated_current = 29.0; },
       "rated_current: not more than the maximum current"},
      {"faster than anything turns", [](M& m) { m.maximum_speed = 1e6; },
       "maximum_speed: a speed with an electrical frequency below 16 kHz"},
      {"stall above maximum current", [](M& m) { m.stall_current = 29.0; },
       "stall_current: not more than the maximum current"},
      {"no inductance", [](M& m) { m.synchronous.q_inductance = 0.0; },
       "synchronous.q_inductance: a number above 0"},
      {"no magnets", [](M& m) { m.synchronous.magnet_flux = 0.0; }, "synchronous.magnet_flux: a number above 0"},
      {"negative friction", [](M& m) { m.coulomb_friction = -1.0; }, "coulomb_friction: a number not below 0"},
      {"no heat capacity", [](M& m) { m.thermal.winding_capacity = 0.0; },
       "thermal.winding_capacity: a number above 0"},
      {"no pulses", [](M& m) { m.encoder.pulses = 0; }, "encoder.pulses: an integer 1 to 16777215"},
      {"too fine", [](M& m) { m.encoder.fine_bits = 19; }, "encoder.fine_bits: an integer 2 to 18"},
  };
  expect_all(cases);
}

TEST(Validation, LooksAtTheCircuitOfTheMachinesOwnTypeOnly) {
  MachineData machine;
  machine.induction.rotor_resistance = 0.0;
  EXPECT_EQ(said_of(machine), "possible");

  machine.type = MachineType::Induction;
  EXPECT_EQ(said_of(machine), "induction.rotor_resistance: a number above 0");
}

TEST(Validation, NamesWhatNoLoadCanBe) {
  const Spoilt<Load> cases[] = {
      {"negative inertia", [](Load& l) { l.inertia = -1.0; }, "inertia: a number not below 0"},
      {"nothing behind a coupling", [](Load& l) { l.coupling.stiffness = 100.0; },
       "inertia: a number above 0 behind a coupling"},
      {"a stop beyond the start", [](Load& l) { l.end_stops.lower = 1.0; },
       "end_stops.lower: a number not above 0, where the load is at power-on"},
      {"torque without end", [](Load& l) { l.constant_torque = std::numeric_limits<double>::infinity(); },
       "constant_torque: a finite number"},
      {"times that go back",
       [](Load& l) {
         l.profile.points[0].time = 1.0;
         l.profile.points[1].time = 0.5;
         l.profile.count = 2;
       },
       "profile: ascending times"},
      {"a circle without length",
       [](Load& l) {
         l.profile.count = 1;
         l.profile.repeats = true;
       },
       "profile: two points or more, the first at time 0, to repeat"},
      {"more points than there are", [](Load& l) { l.profile.count = 65; }, "profile: at most 64 points"},
      {"a brake that drives", [](Load& l) { l.brake.torque = -1.0; }, "brake.torque: a number not below 0"},
  };
  expect_all(cases);
}

TEST(Validation, NamesWhatIsTooFastForTheMassesThatThereAre) {
  const MachineData machine;
  const auto said = [&](const Load& load) {
    const auto found = find_impossible(machine, load);
    return found ? std::string{found->member} : "possible";
  };

  EXPECT_EQ(said({}), "possible");
  EXPECT_EQ(said({.viscous_friction = 1e3}), "viscous_friction");
  EXPECT_EQ(said({.inertia = 1e-6, .coupling = {.stiffness = 1e6}}), "coupling.stiffness");
  EXPECT_EQ(said({.inertia = 1e-3, .coupling = {.stiffness = 1e3, .damping = 1e3}}), "coupling.damping");
  EXPECT_EQ(said({.end_stops = {.upper = 1.0, .stiffness = 1e9}}), "end_stops.stiffness");
  EXPECT_EQ(said({.end_stops = {.upper = 1.0, .damping = 1e6}}), "end_stops.damping");
}

TEST(Validation, NamesWhatNoPowerUnitOrSupplyCanBe) {
  const Spoilt<InverterData> units[] = {
      {"rated above maximum", [](InverterData& i) { i.rated_current = 37.0; },
       "rated_current: not more than the maximum current"},
      {"trips in operation", [](InverterData& i) { i.trip_current = 20.0; },
       "trip_current: more than the peak of the maximum current"},
  };
  const Spoilt<SupplyData> supplies[] = {
      {"no capacitors", [](SupplyData& s) { s.capacitance = 0.0; }, "capacitance: a number above 0"},
      {"chopper never off", [](SupplyData& s) { s.chopper_off = 780.0; },
       "chopper_off: less than the voltage at which the chopper goes on"},
      {"negative line", [](SupplyData& s) { s.line_voltage = -400.0; }, "line_voltage: 0 or a number 70 to 1000"},
      {"transmission line", [](SupplyData& s) { s.line_voltage = 4000.0; },
       "line_voltage: 0 or a number 70 to 1000"},
      {"line of another voltage class", [](SupplyData& s) { s.line_voltage = 690.0; },
       "line_voltage: a line whose rectified voltage, 1.35 times as high, is less than the overvoltage"},
      {"infeed that trips the unit",
       [](SupplyData& s) {
         s.infeed = Infeed::Active;
         s.active_voltage = 900.0;
       },
       "active_voltage: less than the overvoltage"},
  };
  expect_all(units);
  expect_all(supplies);
}

}  // namespace
}  // namespace motor
