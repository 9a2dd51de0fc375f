#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "tools/axisctl/page/recording.hpp"

namespace axisctl {

/// What a page has of a unit.
struct PageUnit {
  std::string unit;                                     ///< BUS/NODE
  std::string name{};                                   ///< what a scenario calls it; empty: none
  nlohmann::json resources = nlohmann::json::object();  ///< of take_snapshot()
  std::string eds{};                                    ///< text; empty: none
  std::vector<Recording> recordings{};                  ///< the oldest first
};
/// The profile of @p unit, as it tells it itself, else its newest recording; "s120" if neither does.
[[nodiscard]] std::string profile_of(const PageUnit& unit);

/// What came of a scenario.
struct PageVerdict {
  bool passed = false;
  std::string text{};                                ///< the report for people
  nlohmann::json report = nlohmann::json::object();  ///< that for programs
};

/// What a page shows (docs/reference/session.md).
struct Page {
  std::string title;
  std::string made_at{};  ///< ISO 8601, UTC
  std::optional<PageVerdict> verdict{};
  std::vector<PageUnit> units{};
};

/// @p page as docs/reference/session.md describes it.
[[nodiscard]] nlohmann::json json_of(const Page& page);

/// What may stand between the tags of a script: @p value without any `<`.
[[nodiscard]] std::string script_text(const nlohmann::json& value);

/// @p blank, which is installed, with @p page in the place for it. The error is one line: it has no such place, or
/// several.
[[nodiscard]] tl::expected<std::string, std::string> fill_page(std::string blank, const Page& page);

/// The present time for Page::made_at, to the second.
[[nodiscard]] std::string time_of_making();

}  // namespace axisctl
