#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace farm {

/// Where a unit is: the value of a key of the bucket of places.
struct Place {
  std::string host{};          ///< whose agent has it; empty: nobody's
  std::uint64_t instance = 0;  ///< of that agent
  std::uint64_t term = 0;      ///< how often the unit was taken so far
  std::uint64_t restarts = 0;  ///< how often it was started again there because it had ended
  std::string problem{};       ///< why it does not run as it is wanted, in one line; empty: it does

  friend bool operator==(const Place&, const Place&) = default;
};

/// Reads @p text, the value of @p key; the error is one line.
[[nodiscard]] tl::expected<Place, std::string> parse_place(std::string_view key, std::string_view text);
[[nodiscard]] std::string text_of(const Place& place);

}  // namespace farm
