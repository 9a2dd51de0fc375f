// The measurements of a motor, and what they have found.
#include <array>
#include <cmath>

#include "daemon/control/handlers.hpp"
#include "daemon/control/parameters/parameter_name.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"
#include "drive/explain/views/identification_view.hpp"

namespace axisd {
namespace {

using nlohmann::json;

json result_json(const drive::IdentifiedValue& found) {
  const drive::ParameterRow& row = *found.row;
  json told{{"parameter", parameter_text(row, 0)},
            {"name", row.name},
            {"unit", drive::row_of(row.unit).text},
            {"value", found.value}};
  if (found.data_sheet) told["data_sheet"] = *found.data_sheet;
  if (const auto deviation = found.deviation()) told["deviation_percent"] = *deviation;
  return told;
}

Outcome show_identification(const Call& call, const json& params) {
  const auto axis = required_axis(call.instance, params);
  if (!axis) return tl::unexpected{axis.error()};
  call.instance.device().tell_time(call.now);
  const drive::IdentificationView view = drive::identification_of(call.instance.device().axis(*axis));
  json results = json::array();
  for (const drive::IdentifiedValue& found : view.results) results.push_back(result_json(found));
  return json{{"axis", *axis},
              {"selected", view.selected},
              {"phase", drive::name_of(view.phase)},
              {"progress_percent", std::lround(view.progress)},
              {"text", view.text},
              {"results", std::move(results)}};
}

constexpr std::array kIdentificationHandlers{Handler{"identification.get", &show_identification}};

}  // namespace

std::span<const Handler> identification_handlers() noexcept {
  return kIdentificationHandlers;
}

}  // namespace axisd
