#include "record/event.hpp"

#include <algorithm>
#include <chrono>
#include <span>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace record {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kOrigins{"unit", "sdo", "control"};

constexpr std::uint8_t kControlUnit = 1;

/// Where it happened: the drive object, and the place as control methods name it.
void add_place(json& line, const Event& event) {
  if (event.object == 0) return;
  line["drive_object"] = event.object;
  if (event.axis != 0 || event.object == kControlUnit) {
    line["axis"] = event.axis;
  } else {
    line["axis"] = "infeed";
  }
}

/// A state in place of another.
void add_states(json& line, const Event& event) {
  add_place(line, event);
  line["state"] = event.text;
  line["before"] = event.text_before;
}

void add_message(json& line, const Event& event) {
  add_place(line, event);
  line["number"] = event.number;
  line["name"] = fmt::format("{}{:05}", event.kind == EventKind::Fault ? 'F' : 'A', event.number);
  line["text"] = event.text;
  line["value"] = event.code;
  line["active"] = event.active;
}

void add_origin(json& line, const Event& event) {
  line["by"] = name_of(event.origin);
  if (event.origin == Origin::Sdo) line["server"] = event.server;
}

void add_values(json& line, const Event& event) {
  if (event.value) line["value"] = *event.value;
  if (event.before) line["before"] = *event.before;
  add_origin(line, event);
}

void add_parameter(json& line, const Event& event) {
  add_place(line, event);
  line["parameter"] = fmt::format("p{:04}[{}]", event.number, event.index);
  add_values(line, event);
}

void add_object(json& line, const Event& event) {
  line["object"] = fmt::format("{:04X}:{:02X}", event.number, event.index);
  add_values(line, event);
}

void add_refusal(json& line, const Event& event) {
  line["object"] = fmt::format("{:04X}:{:02X}", event.number, event.index);
  line["abort_code"] = fmt::format("0x{:08X}", event.code);
  line["text"] = event.text;
  add_origin(line, event);
}

void add_emergency(json& line, const Event& event) {
  std::string data;
  for (const std::uint8_t byte : event.data) data += fmt::format("{:02X}", byte);
  line["code"] = fmt::format("0x{:04X}", event.number);
  line["data"] = data;
}

void add_action(json& line, const Event& event) {
  line["method"] = event.text;
  line["text"] = event.note.text();
  add_origin(line, event);
}

/// What further members the lines of each kind have, in the order of the kinds.
using AddMembers = void (*)(json& line, const Event& event);
constexpr std::array<AddMembers, kEventKinds> kMembers{
    [](json& line, const Event& event) { line["on"] = event.active; },
    [](json& line, const Event& event) { line["node_id"] = event.number; },
    &add_states,
    [](json& line, const Event& event) { line["up"] = event.active; },
    &add_states,
    &add_states,
    &add_message,
    &add_message,
    &add_emergency,
    &add_parameter,
    &add_object,
    &add_refusal,
    [](json& line, const Event& event) { line["done"] = event.active; },
    [](json&, const Event&) {},
    &add_action,
};

}  // namespace

Note::Note(std::string_view text) noexcept {
  std::size_t size = std::min(text.size(), kLongest);
  const auto goes_on = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
  while (size > 0 && size < text.size() && goes_on(size)) --size;
  std::ranges::copy(text.substr(0, size), bytes_.begin());
  size_ = static_cast<std::uint8_t>(size);
}

std::optional<EventKind> kind_named(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kEventRows, name, &EventRow::name);
  return row == kEventRows.end() ? std::nullopt : std::optional{row->kind};
}

std::string_view name_of(Origin origin) noexcept {
  return kOrigins[static_cast<std::size_t>(origin)];
}

json json_of(const Event& event, canopen::TimePoint start) {
  json line{{"t", std::chrono::duration<double>{event.time - start}.count()}, {"kind", row_of(event.kind).name}};
  kMembers[static_cast<std::size_t>(event.kind)](line, event);
  return line;
}

}  // namespace record
