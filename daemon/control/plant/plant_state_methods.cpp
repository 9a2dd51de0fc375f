// Loads, plants, supply and encoders as they are, and what of a plant is changed while it runs.
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "control/methods.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Limits of the plant, as a configuration has them.
constexpr double kHighestInertia = 1e4;               // kg·m²
constexpr double kHighestFriction = 1e6;              // N·m, N·m·s/rad
constexpr double kColdest = -40.0, kHottest = 100.0;  // °C

constexpr std::array<std::string_view, 3> kInfeeds{"diode", "regenerative", "active"};
/// In the order of motor::EncoderDefect.
constexpr auto kDefects = control::parameter_of("encoder.fail", "defect").choices;

Outcome show_load(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  const drive::Axis& of = call.instance.device().axis(*axis);
  const motor::Load& load = of.context().axis.load;
  const motor::PlantState& state = of.drive_train().plant_state();
  const Instance::LoadTorque& torque = call.instance.load_torque(*axis);
  json told{{"axis", *axis},
            {"torque_Nm", torque.constant},
            {"friction_Nm", torque.friction},
            {"fan_Nms2", load.fan_coefficient},
            {"pendulum_Nm", load.pendulum_torque},
            {"has_profile", load.profile.count != 0},
            {"is_elastic", motor::is_elastic(load)},
            {"speed_rpm", state.load_speed / motor::kRpm},
            {"twist_rad", state.twist}};
  if (motor::is_elastic(load))
    told["coupling"] = {{"stiffness_Nm_rad", load.coupling.stiffness},
                        {"damping_Nms_rad", load.coupling.damping},
                        {"backlash_rad", load.coupling.backlash}};
  return told;
}

json settings_json(const motor::PlantSettings& settings) {
  return {{"load_inertia_kgm2", settings.load_inertia},
          {"coulomb_friction_Nm", settings.coulomb_friction},
          {"viscous_friction_Nms", settings.viscous_friction},
          {"ambient_C", settings.ambient}};
}

Outcome show_plant(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  call.instance.device().tell_time(call.now);
  const drive::Axis& of = call.instance.device().axis(*axis);
  const motor::Signals& signals = of.signals();
  const motor::PlantState& state = of.drive_train().plant_state();
  json told = settings_json(of.plant());
  told["axis"] = *axis;
  told["speed_rpm"] = signals.true_speed / motor::kRpm;
  told["torque_Nm"] = signals.true_torque;
  told["current_A"] = signals.current / std::numbers::sqrt2;
  told["angle_rad"] = state.rotor_angle;
  told["revolutions"] = state.revolutions;
  told["flux_Vs"] = state.flux;
  told["winding_C"] = signals.winding_temperature;
  told["frame_C"] = signals.frame_temperature;
  told["heat_sink_C"] = signals.heat_sink_temperature;
  told["is_held_back"] = of.drive_train().is_held_back();
  return told;
}

/// A quantity that can be set.
struct Quantity {
  std::string_view key;
  double motor::PlantSettings::*member;
  double low;
  double high;
};
constexpr std::array kQuantities{
    Quantity{"load_inertia_kgm2", &motor::PlantSettings::load_inertia, 0.0, kHighestInertia},
    Quantity{"coulomb_friction_Nm", &motor::PlantSettings::coulomb_friction, 0.0, kHighestFriction},
    Quantity{"viscous_friction_Nms", &motor::PlantSettings::viscous_friction, 0.0, kHighestFriction},
    Quantity{"ambient_C", &motor::PlantSettings::ambient, kColdest, kHottest},
};

Outcome set_plant(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  const drive::Axis& of = call.instance.device().axis(*axis);
  motor::PlantSettings settings = of.plant();
  for (const Quantity& quantity : kQuantities) {
    const auto value =
        Arguments{params}.number(quantity.key, quantity.low, quantity.high, settings.*quantity.member);
    if (!value) return tl::unexpected{value.error()};
    settings.*quantity.member = *value;
  }
  if (motor::is_elastic(of.context().axis.load) && !(settings.load_inertia > 0.0))
    return refuse(control::ErrorCode::OutOfRange, "load_inertia_kgm2: behind a coupling it is above 0",
                  {{"limits", {{"minimum", 0.0}, {"maximum", kHighestInertia}, {"unit", "kgm²"}}}});
  call.instance.device().set_plant(*axis, settings, call.now);
  return settings_json(settings);
}

Outcome show_supply(const Call& call, const json&) {
  const drive::DriveUnit& unit = call.instance.device().unit();
  const motor::DcLink& link = unit.dc_link();
  return json{{"line_voltage_V", unit.line_voltage()},
              {"dc_link_V", link.voltage()},
              {"infeed", kInfeeds[static_cast<std::size_t>(link.data().infeed)]},
              {"is_drive_object", unit.infeed() != nullptr},
              {"chopper_is_on", link.chopper_on()},
              {"chopper_W", link.chopper_power()},
              {"overvoltage_V", link.data().overvoltage},
              {"undervoltage_V", link.data().undervoltage}};
}

Outcome show_encoder(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  const drive::Axis& of = call.instance.device().axis(*axis);
  const motor::Encoder& encoder = of.drive_train().encoder();
  return json{{"axis", *axis},
              {"defect", kDefects[static_cast<std::size_t>(encoder.defect())]},
              {"signal_is_lost", encoder.status().signal_lost},
              {"zero_mark_deviation", encoder.status().zero_mark_deviation},
              {"counts", encoder.counts()},
              {"pulses", of.context().axis.machine.encoder.pulses},
              {"speed_rpm", encoder.speed() / motor::kRpm},
              {"true_speed_rpm", of.signals().true_speed / motor::kRpm}};
}

constexpr std::array kPlantStateHandlers{
    Handler{"load.get", &show_load},     Handler{"plant.get", &show_plant},     Handler{"plant.set", &set_plant},
    Handler{"supply.get", &show_supply}, Handler{"encoder.get", &show_encoder},
};

}  // namespace

std::span<const Handler> plant_state_handlers() noexcept {
  return kPlantStateHandlers;
}

}  // namespace axisd
