#pragma once

#include <nlohmann/json.hpp>

#include "daemon/instance/instance.hpp"
#include "device/pdo/pdo_objects.hpp"
#include "libcanopen/pdo/settings.hpp"

namespace axisd {

/// A PDO as the control socket shows it: how it is sent, what is mapped, and what was heard of it while somebody
/// counts. @p now is the time that the ages of frames refer to.
nlohmann::json pdo_json(Instance& instance, const canopen::PdoSettings& settings, canopen::Direction direction,
                        canopen::TimePoint now);

}  // namespace axisd
