#include "daemon/control/event_json.hpp"

#include "daemon/instance/instance.hpp"

namespace axisd {

nlohmann::json event_json(const Instance& instance, const UnitEvent& event) {
  return record::json_of(event, instance.started());
}

}  // namespace axisd
