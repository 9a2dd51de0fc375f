#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/axisctl/print/printer.hpp"

namespace axisctl {

namespace {

using nlohmann::json;

/// How a member of the result is shown.
struct Label {
  std::string_view key;
  std::string_view text;
  std::string_view unit;
};

constexpr std::array kUnitLabels{
    Label{"interface", "interface", ""},
    Label{"node_id", "node-ID", ""},
    Label{"nmt_state", "NMT state", ""},
    Label{"uptime_s", "up for", " s"},
    Label{"utc", "UTC", ""},
    Label{"bus", "bus", ""},
    Label{"leds", "LEDs", ""},
    Label{"dc_link_V", "DC link", " V"},
    Label{"cycle_ms", "cycle", " ms"},
    Label{"skipped_cycles", "skipped cycles", ""},
    Label{"version", "axisd version", ""},
};
constexpr std::array kControlUnitLabels{
    Label{"faults", "faults", ""},
    Label{"alarms", "alarms", ""},
    Label{"inputs", "inputs at 1", ""},
    Label{"outputs", "outputs at 1", ""},
};
constexpr std::array kInfeedLabels{
    Label{"drive_object", "drive object", ""},
    Label{"state", "state", ""},
    Label{"operates", "operates", ""},
    Label{"faults", "faults", ""},
    Label{"alarms", "alarms", ""},
};
constexpr std::array kAxisLabels{
    Label{"state", "state", ""},
    Label{"controlword", "controlword", ""},
    Label{"statusword", "statusword", ""},
    Label{"setpoint_rpm", "speed setpoint", " rpm"},
    Label{"speed_rpm", "speed", " rpm"},
    Label{"torque_Nm", "torque", " N·m"},
    Label{"load_torque_Nm", "load torque", " N·m"},
    Label{"load_friction_Nm", "load friction", " N·m"},
    Label{"current_A", "current", " A"},
    Label{"motor_temperature_C", "motor", " °C"},
    Label{"position", "position", ""},
    Label{"positioner", "positioner", ""},
    Label{"if1", "IF1", ""},
    Label{"faults", "faults", ""},
    Label{"alarms", "alarms", ""},
};
// Shown in the heading of an axis or below the unit.
constexpr std::array<std::string_view, 6> kElsewhere{"axis", "name", "type", "axes", "control_unit", "infeed"};
constexpr int kIndent = 2;
constexpr int kLabelWidth = 16;
constexpr std::size_t kStateWidth = 22, kCodeWidth = 6;

/// F07860, A07860: how the manuals print the number of a message.
std::string message(char letter, const json& entry) {
  if (!entry.is_object()) return entry.dump();
  const json number = entry.value("number", json{});
  const std::string code =
      number.is_number_unsigned() ? fmt::format("{}{:05}", letter, number.get<unsigned>()) : "?";
  const json text = entry.value("text", json{});
  return text.is_string() ? code + ' ' + text.get<std::string>() : code;
}

std::string list(std::string_view key, const json& value) {
  std::string text;
  for (const json& entry : value) {
    const std::string item = key == "faults"   ? message('F', entry)
                             : key == "alarms" ? message('A', entry)
                                               : entry.dump();
    text.append(text.empty() ? "" : ", ").append(item);
  }
  return text.empty() ? "none" : text;
}

std::string to_text(std::string_view key, const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.3f}", value.get<double>());
  if (value.is_array()) return list(key, value);
  if (!value.is_object()) return value.dump();
  std::string text;
  for (const auto& [name, member] : value.items())
    text.append(text.empty() ? "" : ", ").append(name).append(" ").append(to_text(name, member));
  return text;
}

void print_line(std::ostream& out, int indent, std::string_view label, std::string_view text) {
  out << fmt::format("{:{}}{:<{}}{}\n", "", indent, label, kLabelWidth, text);
}

/// Prints the members of @p object in the order of @p labels, then those that no label knows.
template <class Labels>
void print_members(std::ostream& out, int indent, const Labels& labels, const json& object) {
  for (const Label& label : labels)
    if (const auto found = object.find(label.key); found != object.end())
      print_line(out, indent, label.text, to_text(label.key, *found).append(label.unit));
  for (const auto& [key, value] : object.items()) {
    const auto is_key = [&name = key](const Label& label) { return label.key == name; };
    const bool known = std::any_of(labels.begin(), labels.end(), is_key) ||
                       std::find(kElsewhere.begin(), kElsewhere.end(), key) != kElsewhere.end();
    if (!known) print_line(out, indent, key, to_text(key, value));
  }
}

void print_axis(std::ostream& out, json axis, Style style) {
  if (const auto state = axis.find("state"); state != axis.end() && state->is_string())
    *state = coloured_state(state->get<std::string>(), style);
  out << "axis " << to_text("axis", axis.value("axis", json{}));
  if (const auto name = axis.find("name"); name != axis.end()) out << ' ' << to_text("name", *name);
  if (const auto type = axis.find("type"); type != axis.end()) out << " (" << to_text("type", *type) << ')';
  out << '\n';
  print_members(out, kIndent, kAxisLabels, axis);
}

/// One line: axis, name, state, speed, torque, active messages.
void print_briefly(std::ostream& out, const json& axis, Style style) {
  const auto member = [&axis](std::string_view key) { return to_text(key, axis.value(key, json{})); };
  const auto number = [&axis](const char* key) {
    const json value = axis.value(key, json{});
    return value.is_number() ? fmt::format("{:.1f}", value.get<double>()) : "?";
  };
  std::string state = member("state");
  const std::string blanks(kStateWidth - std::min(kStateWidth, state.size()), ' ');
  state = coloured_state(state, style) + blanks;
  std::string messages;
  for (const auto& [key, letter] : {std::pair{"faults", 'F'}, {"alarms", 'A'}})
    for (const json& entry : axis.value(key, json::array()))
      messages += ' ' + message(letter, entry).substr(0, kCodeWidth);
  out << fmt::format("{} {:<8} {} {:>8} rpm {:>8} N·m{}\n", member("axis"), member("name"), state,
                     number("speed_rpm"), number("torque_Nm"), messages);
}

}  // namespace

void print_status(std::ostream& out, const json& result, Style style) {
  if (!result.is_object()) {
    out << result.dump() << '\n';
    return;
  }
  const json axes = result.value("axes", json::array());
  if (style.brief) {
    for (const json& axis : axes)
      if (axis.is_object()) print_briefly(out, axis, style);
    return;
  }
  print_members(out, 0, kUnitLabels, result);
  if (const auto unit = result.find("control_unit"); unit != result.end() && unit->is_object()) {
    out << "control unit\n";
    print_members(out, kIndent, kControlUnitLabels, *unit);
  }
  if (const auto infeed = result.find("infeed"); infeed != result.end() && infeed->is_object()) {
    out << "infeed " << to_text("name", infeed->value("name", json{})) << '\n';
    print_members(out, kIndent, kInfeedLabels, *infeed);
  }
  if (!axes.is_array()) return;
  for (const json& axis : axes)
    if (axis.is_object()) print_axis(out, axis, style);
}

}  // namespace axisctl
