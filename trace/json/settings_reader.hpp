#pragma once

#include <span>
#include <string_view>

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include "trace/settings.hpp"
#include "trace/signal/problem.hpp"

namespace trace {

/// The keys that read_settings() knows.
std::span<const std::string_view> settings_keys() noexcept;

/// What @p value says of a trace, the parameters of `trace.start` and key "trace" of a configuration: keys as
/// docs/reference/trace.md has them. Whether a unit has the signals is not looked at.
tl::expected<Settings, Problem> read_settings(const nlohmann::json& value);

}  // namespace trace
