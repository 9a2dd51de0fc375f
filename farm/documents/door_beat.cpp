#include "farm/documents/door_beat.hpp"

#include <fmt/format.h>

#include "farm/documents/field_reader.hpp"
#include "farm/documents/numbers.hpp"

namespace farm {
namespace {

using nlohmann::json;

constexpr std::uint32_t kMostParts = 10'000;
constexpr std::uint32_t kMostAxes = 8;
constexpr std::uint32_t kHighestNode = 255;

tl::expected<DoorUnit, std::string> read_unit(std::string subject, const json& object) {
  FieldReader fields{std::move(subject), object};
  DoorUnit unit;
  const auto name = parse_unit_name(fields.text("unit"));
  if (name)
    unit.name = *name;
  else
    fields.fail("unit", "BUS/NODE", object.is_object() ? object.value("unit", json{}) : json{});
  unit.is_on = fields.flag("on", true);
  unit.axes = static_cast<std::uint32_t>(fields.number("axes", 0, kMostAxes, 1));
  unit.profile = fields.text("profile");
  unit.node_id = static_cast<std::uint32_t>(fields.number("node_id", 0, kHighestNode, 0));
  return fields.result(std::move(unit));
}

json json_of(const DoorUnit& unit) {
  return {{"unit", unit.name.text()},
          {"on", unit.is_on},
          {"axes", unit.axes},
          {"profile", unit.profile},
          {"node_id", unit.node_id}};
}

}  // namespace

tl::expected<DoorBeat, std::string> parse_door_beat(std::string_view subject, std::string_view text) {
  FieldReader fields{subject, text};
  DoorBeat beat;
  beat.host = fields.name("host");
  if (beat.host.empty()) fields.fail("host", "a name", nullptr);
  beat.instance = fields.number("instance", 1, kGreatestNumber);
  beat.version = fields.text("version");
  beat.parts = static_cast<std::uint32_t>(fields.number("parts", 1, kMostParts, 1));
  beat.part = static_cast<std::uint32_t>(fields.number("part", 1, beat.parts, 1));
  for (const json& object : fields.objects("units")) {
    auto unit = read_unit(fmt::format("{}: units[{}]", subject, beat.units.size()), object);
    if (unit)
      beat.units.push_back(*std::move(unit));
    else
      fields.take(unit.error());
  }
  return fields.result(std::move(beat));
}

std::string text_of(const DoorBeat& beat) {
  json document{
      {"host", beat.host}, {"instance", beat.instance}, {"version", beat.version}, {"units", json::array()}};
  for (const DoorUnit& unit : beat.units) document["units"].push_back(json_of(unit));
  if (beat.parts > 1) {
    document["part"] = beat.part;
    document["parts"] = beat.parts;
  }
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace farm
