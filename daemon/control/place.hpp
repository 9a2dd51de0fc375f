#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "daemon/control/arguments.hpp"
#include "daemon/control/handler.hpp"
#include "daemon/instance/instance.hpp"

namespace axisd {

/// The drives that @p call acts on.
inline drive::DriveUnit& unit_of(const Call& call) noexcept {
  return call.instance.device().runner().unit();
}

/// How the control socket names drive object @p object: 0 = control unit, 1.. = axis, "infeed".
nlohmann::json place_of(const drive::DriveObject& object);
/// The same for a sentence: "the control unit", "the infeed", "axis 1".
std::string place_text(const drive::DriveObject& object);

/// The drive object of @p unit that @p place names, a value of place_of() or its text.
Taken<drive::DriveObject*> find_place(drive::DriveUnit& unit, const nlohmann::json& place);

/// The drive object that key "axis" of @p params names.
Taken<drive::DriveObject*> required_place(drive::DriveUnit& unit, const nlohmann::json& params);
/// The same; nullptr if there is no such key.
Taken<drive::DriveObject*> optional_place(drive::DriveUnit& unit, const nlohmann::json& params);
/// The axis that key "axis" of @p params names, 1..axes.
Taken<std::size_t> required_axis(const Instance& instance, const nlohmann::json& params);

}  // namespace axisd
