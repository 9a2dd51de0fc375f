#include "daemon/instance/status.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "daemon/base/utc_text.hpp"
#include "daemon/instance/instance.hpp"
#include "motor/data/machine_data.hpp"
#include "profidrive/telegram/telegrams.hpp"
#include "version/version.hpp"

namespace axisd {
namespace {

using nlohmann::json;

json messages(std::span<const drive::FaultEntry> entries) {
  json list = json::array();
  for (const drive::FaultEntry& entry : entries) {
    list.push_back({{"number", entry.row->number}, {"text", entry.row->name}});
  }
  return list;
}

/// What the axis is asked to do (rad/s), wherever it is connected.
double target_velocity(const drive::Axis& axis) noexcept {
  return axis.block<drive::SetpointChannel>().incoming();
}

/// What a positioning axis does, in whole LU.
json positioner_status(const drive::Axis& axis) {
  constexpr double kPercent = 100.0;
  const auto whole = [](double units) { return std::llround(units); };
  const auto& positioner = axis.block<drive::Positioner>();
  json status{{"enabled", axis.block<drive::PositionControl>().is_enabled()},
              {"referenced", positioner.is_referenced()},
              {"mode", positioner.mode_name()},
              {"position_LU", axis.block<drive::ActualPosition>().shown()},
              {"setpoint_LU", whole(positioner.position())},
              {"override_percent", positioner.effective_override() * kPercent}};
  if (positioner.blocks().is_active()) status["block"] = positioner.blocks().block().number;
  if (!positioner.has_target()) return status;
  status["target_LU"] = whole(positioner.target());
  status["residual_LU"] = whole(positioner.residual_distance());
  return status;
}

/// What IF1 has to do with @p axis; null: nothing.
json if1_status(const profidrive::Interface& if1, const drive::Axis& axis) {
  constexpr std::array kStages{"none", "running", "interrupted", "failed"};
  const profidrive::Telegram* const telegram = if1.selection(axis.number()).telegram;
  const profidrive::Monitoring::Stage stage = if1.stage(axis.number());
  if (telegram == nullptr && stage == profidrive::Monitoring::Stage::Off) return nullptr;
  return {{"telegram", telegram != nullptr ? telegram->number : profidrive::telegrams::kFreeWords},
          {"exchange", kStages[static_cast<std::size_t>(stage)]},
          {"received", fmt::format("0x{:04X}", if1.received(axis.number())[0])},
          {"sent", fmt::format("0x{:04X}", if1.sent(axis.number())[0])}};
}

/// What a CiA 402 axis has beside.
void add_profile(const device::ProfileView& view, json& status) {
  status["mode"] = view.mode;
  status["homed"] = view.is_homed;
  status["position_units"] = view.position;
  status["error_code"] = fmt::format("0x{:04X}", view.error_code);
  status["digital_inputs"] = fmt::format("0x{:08X}", view.inputs);
  status["digital_outputs"] = fmt::format("0x{:08X}", view.outputs);
}

json axis_status(const Instance& instance, std::size_t number) {
  const device::Device& device = instance.device();
  const drive::Axis& axis = device.axis(number);
  const drive::ActualValues& actual = axis.actual();
  const device::AxisView view = device.view(number);
  json status{{"axis", number},
              {"name", instance.configuration().axes[number - 1].name},
              {"type", axis.kind() == drive::ObjectKind::Vector ? "vector" : "servo"},
              {"state", name_of(view.state)},
              {"statusword", fmt::format("0x{:04X}", view.statusword)},
              {"controlword", fmt::format("0x{:04X}", view.controlword)},
              {"speed_rpm", actual.speed / motor::kRpm},
              {"setpoint_rpm", target_velocity(axis) / motor::kRpm},
              {"torque_Nm", actual.torque},
              {"load_torque_Nm", instance.load_torque(number).constant},
              {"load_friction_Nm", instance.load_torque(number).friction},
              {"current_A", axis.signals().current / std::numbers::sqrt2},
              {"motor_temperature_C", axis.signals().winding_temperature},
              {"position", view.position},
              {"faults", messages(axis.messages().faults())},
              {"alarms", messages(axis.messages().alarms())}};
  if (view.profile) add_profile(*view.profile, status);
  if (axis.positions()) status["positioner"] = positioner_status(axis);
  if (json if1 = if1_status(instance.if1(), axis); !if1.is_null()) status["if1"] = std::move(if1);
  return status;
}

json axes_status(const Instance& instance) {
  json axes = json::array();
  for (std::size_t number = 1; number <= instance.configuration().axes.size(); ++number)
    axes.push_back(axis_status(instance, number));
  return axes;
}

/// The numbers of the bits of @p word that are 1.
json terminals(drive::Terminals::Word word) {
  json list = json::array();
  for (unsigned number = 0; number <= drive::Terminals::kHighest; ++number)
    if ((word >> number & 1U) != 0) list.push_back(number);
  return list;
}

json control_unit_status(const Instance& instance) {
  const drive::ControlUnit& unit = instance.device().unit().control_unit();
  return {{"faults", messages(unit.messages().faults())},
          {"alarms", messages(unit.messages().alarms())},
          {"inputs", terminals(unit.terminals().status())},
          {"outputs", terminals(unit.terminals().outputs() & unit.terminals().directions)}};
}

json infeed_status(const drive::Infeed& infeed, const std::string& name) {
  return {{"drive_object", infeed.number()},
          {"name", name},
          {"state", name_of(infeed.state())},
          {"operates", infeed.operates()},
          {"faults", messages(infeed.messages().faults())},
          {"alarms", messages(infeed.messages().alarms())}};
}

/// The clock of the unit, which has UTC.
json utc_status(const drive::UnitClock& clock) {
  using Method = drive::UnitClock::Method;
  const std::string_view method = clock.method() == Method::PingSnap ? "ping-snap"
                                  : clock.method() == Method::Simple ? "simple"
                                                                     : "host";
  return {{"time", utc_text(clock.line().utc().value_or(0))},
          {"synchronised", clock.is_synchronised()},
          {"method", method}};
}

json leds_status(const device::IndicatorLeds& leds) {
  return {{"run", name_of(leds.run)}, {"error", name_of(leds.error)}};
}

json modbus_status(const ModbusServer& server) {
  return {{"address", server.place()},
          {"connections", server.clients()},
          {"turned_away", server.turned_away()},
          {"requests", server.counters().requests},
          {"exceptions", server.counters().exceptions}};
}

json bus_status(const Instance& instance) {
  const auto& sent = instance.bus().queue().counters();
  return {{"state", bus::name_of(instance.bus_state())},
          {"link", instance.bus().is_open() ? "up" : "down"},
          {"received", instance.bus().received()},
          {"sent", sent.sent},
          {"dropped", instance.bus().port().dropped()},
          {"queued", sent.queued},
          {"refused", sent.refused},
          {"replaced", sent.replaced},
          {"send_dropped", sent.dropped},
          {"foreign", instance.reports().foreign_frames()},
          {"lost_telegrams", instance.device().lost_telegrams()},
          {"short_rpdos", instance.device().node().short_rpdos()}};
}

}  // namespace

json status_of(const Instance& instance) {
  json status{
      {"version", version::number()},
      {"interface", instance.configuration().address.text},
      {"profile", name_of(instance.configuration().profile())},
      {"node_id", instance.device().node_id()},
      {"nmt_state", canopen::name_of(instance.device().node().state())},
      {"uptime_s", instance.uptime_s()},
      {"bus", bus_status(instance)},
      {"leds", leds_status(instance.device().leds())},
      {"dc_link_V", instance.device().unit().dc_link().voltage()},
      {"cycle_ms", std::chrono::duration<double, std::milli>{instance.device().cycle()}.count()},
      {"skipped_cycles", instance.device().skipped_cycles()},
      {"memory",
       {{"parameters", instance.memory().parameters_text()}, {"retained", instance.memory().retained_text()}}},
      {"control_unit", control_unit_status(instance)},
      {"axes", axes_status(instance)}};
  const drive::UnitClock& clock = instance.device().unit().control_unit().clock();
  if (clock.is_utc()) status["utc"] = utc_status(clock);
  if (const drive::Infeed* const infeed = instance.device().unit().infeed())
    status["infeed"] = infeed_status(*infeed, instance.configuration().infeed->name);
  if (instance.modbus() != nullptr) status["modbus"] = modbus_status(*instance.modbus());
  return status;
}

}  // namespace axisd
