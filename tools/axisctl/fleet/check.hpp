#pragma once

#include <cstdint>
#include <string>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace fleet {

/// What a configuration was found to be.
enum class Checked : std::uint8_t {
  Right,
  NotAtAll  ///< there is no axisd to ask
};

/// Has the axisd in @p folder look at @p configuration, which messages call @p file. The error is one line: what
/// is wrong with it, or why that cannot be said.
[[nodiscard]] tl::expected<Checked, std::string> check_configuration(const std::string& folder,
                                                                     const nlohmann::json& configuration,
                                                                     const std::string& file);

}  // namespace fleet
