#include "gateway/streams/event_filter.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/methods.hpp"
#include "gateway/base/percent.hpp"

namespace gateway {
namespace {

constexpr std::string_view kKinds = "kinds";

bool is_kind(const std::string& name) {
  return std::ranges::find(control::kEventKind, name) != control::kEventKind.end();
}

bool has(const std::set<std::string, std::less<>>& wanted, std::string_view name) {
  return wanted.empty() || wanted.contains(name);
}

}  // namespace

bool EventFilter::takes(std::string_view unit, std::string_view kind) const {
  return has(units, unit) && has(kinds, kind);
}

tl::expected<EventFilter, Error> event_filter(const Query& query) {
  EventFilter filter;
  for (const auto& [key, text] : query)
    for (std::string& item : list_of(text)) {
      if (key == kUnitFilter) filter.units.insert(std::move(item));
      if (key != kKinds) continue;
      if (!is_kind(item))
        return tl::unexpected{refuse(
            Refused::BadRequest,
            fmt::format("kinds: expected some of {}, got \"{}\"", fmt::join(control::kEventKind, ", "), item))};
      filter.kinds.insert(std::move(item));
    }
  return filter;
}

}  // namespace gateway
