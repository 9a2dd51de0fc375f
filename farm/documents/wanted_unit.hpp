#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace farm {

/// A unit that is wanted: the value of a key of the bucket of units.
struct WantedUnit {
  nlohmann::json configuration = nlohmann::json::object();  ///< keys of a unit, without what its key says
  std::vector<std::string> hosts;                           ///< where it may be; empty: anywhere

  /// Whether it may be on @p host.
  [[nodiscard]] bool allows(std::string_view host) const noexcept;

  friend bool operator==(const WantedUnit&, const WantedUnit&) = default;
};

/// Reads @p text, the value of @p key; the error is one line: "line1.5: host: expected ..., got 5". Whether
/// `configuration` is one, axisd says.
[[nodiscard]] tl::expected<WantedUnit, std::string> parse_wanted_unit(std::string_view key, std::string_view text);
[[nodiscard]] std::string text_of(const WantedUnit& unit);

}  // namespace farm
