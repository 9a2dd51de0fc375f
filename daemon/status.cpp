#include "daemon/status.hpp"

#include <array>
#include <chrono>
#include <numbers>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "daemon/daemon.hpp"
#include "daemon/version.hpp"
#include "motor/machine_data.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Names of drive::State, in its order, as CiA 402 prints them.
constexpr std::array<std::string_view, drive::kStateCount> kStateNames{
    "Not ready to switch on", "Switch on disabled", "Ready to switch on",    "Switched on", "Operation enabled",
    "OFF1 braking",           "Quick stop active",  "Fault reaction active", "STOP2",       "Fault"};

json messages(std::span<const drive::FaultEntry> entries) {
  json list = json::array();
  for (const drive::FaultEntry& entry : entries) {
    list.push_back({{"number", entry.row->number}, {"text", entry.row->name}});
  }
  return list;
}

/// What the axis is asked to do (rad/s), wherever it is connected.
double target_velocity(const drive::Axis& axis) noexcept {
  return axis.has_setpoint_channel() ? axis.inputs().main_setpoint : axis.inputs().speed_setpoint_1;
}

json axis_status(const Daemon& daemon, std::size_t number) {
  const device::Device& device = daemon.device();
  const drive::Axis& axis = device.axis(number);
  const drive::ActualValues& actual = axis.actual();
  return {{"axis", number},
          {"name", daemon.configuration().axes[number - 1].name},
          {"type", axis.kind() == drive::ObjectKind::Vector ? "vector" : "servo"},
          {"state", kStateNames[static_cast<std::size_t>(actual.state)]},
          {"statusword", fmt::format("0x{:04X}", actual.statusword)},
          {"controlword", fmt::format("0x{:04X}", axis.process_data().controlword)},
          {"speed_rpm", actual.speed / motor::kRpm},
          {"setpoint_rpm", target_velocity(axis) / motor::kRpm},
          {"torque_Nm", actual.torque},
          {"load_torque_Nm", daemon.load_torque(number).constant},
          {"load_friction_Nm", daemon.load_torque(number).friction},
          {"current_A", axis.signals().current / std::numbers::sqrt2},
          {"motor_temperature_C", axis.signals().winding_temperature},
          {"position", actual.encoder_position},
          {"faults", messages(axis.messages().faults())},
          {"alarms", messages(axis.messages().alarms())}};
}

json axes_status(const Daemon& daemon) {
  json axes = json::array();
  for (std::size_t number = 1; number <= daemon.configuration().axes.size(); ++number)
    axes.push_back(axis_status(daemon, number));
  return axes;
}

/// The numbers of the bits of @p word that are 1.
json terminals(drive::Terminals::Word word) {
  json list = json::array();
  for (unsigned number = 0; number <= drive::Terminals::kHighest; ++number)
    if ((word >> number & 1U) != 0) list.push_back(number);
  return list;
}

json control_unit_status(const Daemon& daemon) {
  const drive::ControlUnit& unit = daemon.device().unit().control_unit();
  return {{"faults", messages(unit.messages().faults())},
          {"alarms", messages(unit.messages().alarms())},
          {"inputs", terminals(unit.terminals().status())},
          {"outputs", terminals(unit.terminals().outputs() & unit.terminals().directions)}};
}

json infeed_status(const drive::Infeed& infeed, const std::string& name) {
  return {{"drive_object", infeed.number()},
          {"name", name},
          {"state", kStateNames[static_cast<std::size_t>(infeed.state())]},
          {"operates", infeed.operates()},
          {"faults", messages(infeed.messages().faults())},
          {"alarms", messages(infeed.messages().alarms())}};
}

json leds_status(const device::IndicatorLeds& leds) {
  return {{"run", name_of(leds.run)}, {"error", name_of(leds.error)}};
}

json bus_status(const Daemon& daemon) {
  const auto& sent = daemon.transmit_queue().counters();
  return {{"state", bus::name_of(daemon.bus_state())},
          {"link", daemon.link_is_up() ? "up" : "down"},
          {"received", daemon.received()},
          {"sent", sent.sent},
          {"dropped", daemon.receive_overflows()},
          {"queued", sent.queued},
          {"refused", sent.refused},
          {"replaced", sent.replaced},
          {"send_dropped", sent.dropped},
          {"foreign", daemon.foreign_frames()},
          {"lost_telegrams", daemon.device().lost_telegrams()},
          {"short_rpdos", daemon.device().node().short_rpdos()}};
}

}  // namespace

json status_of(const Daemon& daemon) {
  json status{{"version", kVersion},
              {"interface", daemon.configuration().address.text},
              {"node_id", daemon.device().node_id()},
              {"nmt_state", canopen::name_of(daemon.device().node().state())},
              {"uptime_s", daemon.uptime_s()},
              {"bus", bus_status(daemon)},
              {"leds", leds_status(daemon.device().leds())},
              {"dc_link_V", daemon.device().unit().dc_link().voltage()},
              {"cycle_ms", std::chrono::duration<double, std::milli>{daemon.device().cycle()}.count()},
              {"skipped_cycles", daemon.device().skipped_cycles()},
              {"memory",
               {{"parameters", daemon.memory().parameters_text()}, {"retained", daemon.memory().retained_text()}}},
              {"control_unit", control_unit_status(daemon)},
              {"axes", axes_status(daemon)}};
  if (const drive::Infeed* const infeed = daemon.device().unit().infeed())
    status["infeed"] = infeed_status(*infeed, daemon.configuration().infeed->name);
  return status;
}

}  // namespace axisd
