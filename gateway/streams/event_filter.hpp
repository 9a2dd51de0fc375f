#pragma once

#include <set>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "gateway/base/error.hpp"
#include "gateway/routes/arguments.hpp"

namespace gateway {

/// What somebody wants of the events; an empty set: all.
struct EventFilter {
  std::set<std::string, std::less<>> units{};
  std::set<std::string, std::less<>> kinds{};

  /// Whether an event of @p unit and @p kind is wanted.
  [[nodiscard]] bool takes(std::string_view unit, std::string_view kind) const;
};

/// What `unit` and `kinds` of @p query, each a list, ask for; an error names a kind that there is not.
[[nodiscard]] tl::expected<EventFilter, Error> event_filter(const Query& query);

}  // namespace gateway
