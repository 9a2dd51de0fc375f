#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "tools/axisctl/scenario/run/context.hpp"

namespace scenario {

/// Loads @p fault into the unit that @p keys names, or into the bus; what it is called there. All errors here are
/// one line.
[[nodiscard]] tl::expected<Injected, std::string> load_fault(Context& context, const nlohmann::json& keys,
                                                             const nlohmann::json& fault);
/// Takes back what was loaded under @p name.
[[nodiscard]] tl::expected<void, std::string> take_back_fault(Context& context, const std::string& name);
/// What has come of it: state, events, opportunities, hits, hit_at.
[[nodiscard]] tl::expected<nlohmann::json, std::string> state_of_fault(Context& context, const std::string& name);

}  // namespace scenario
