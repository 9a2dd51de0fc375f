#include "daemon/control/events/event_json.hpp"

#include "daemon/control/parameters/parameter_name.hpp"
#include "daemon/control/parameters/parameter_value.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// A parameter and its values as the methods for parameters show them.
void show_parameter(json& line, const drive::DriveUnit& unit, const UnitEvent& event) {
  const drive::DriveObject* const object = unit.object(event.object);
  if (object == nullptr) return;
  const auto placed = object->parameter(event.number, event.index);
  if (!placed) return;
  const drive::ParameterRow& row = *(*placed)->row;
  line["parameter"] = parameter_text(row, event.index);
  if (event.value) line["value"] = value_json(row, drive::encode(row.type, *event.value), *object);
  if (event.before) line["before"] = value_json(row, drive::encode(row.type, *event.before), *object);
}

}  // namespace

json event_json(const Instance& instance, const UnitEvent& event) {
  json line = record::json_of(event, instance.started());
  if (event.kind == record::EventKind::Parameter) show_parameter(line, instance.device().unit(), event);
  return line;
}

}  // namespace axisd
