#include "gateway/streams/event_feed.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/methods.hpp"
#include "gateway/base/json_text.hpp"
#include "gateway/base/percent.hpp"

namespace gateway {
namespace {

using nlohmann::json;

std::string member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

bool is_kind(const std::string& name) {
  return std::ranges::find(control::kEventKind, name) != control::kEventKind.end();
}

/// What the keys of @p query ask for, which the router knows; an error names a kind that there is not.
tl::expected<EventFilter, Error> filter_of(const Query& query) {
  EventFilter filter;
  for (const auto& [key, text] : query)
    for (std::string& item : list_of(text)) {
      if (key == kUnitFilter) {
        filter.units.insert(std::move(item));
      } else if (is_kind(item)) {
        filter.kinds.insert(std::move(item));
      } else {
        return tl::unexpected{refuse(
            Refused::BadRequest,
            fmt::format("kinds: expected some of {}, got \"{}\"", fmt::join(control::kEventKind, ", "), item))};
      }
    }
  return filter;
}

}  // namespace

EventFeed::EventFeed(Daemons& daemons) : daemons_{daemons} {
  daemons_.listen(this);
}

void EventFeed::open(const std::shared_ptr<Exchange>& exchange, const Query& query) {
  auto filter = filter_of(query);
  if (!filter) return exchange->answer(filter.error());
  if (viewers_.size() >= kMostViewers)
    return exchange->answer(refuse(Refused::TooMany, fmt::format("{} streams are open already", viewers_.size())));
  const auto stream = viewers_.add(*std::move(filter));
  if (const auto last = exchange->request().header("last-event-id"); !last.empty())
    stream->push(event_text("gap", json_text({{"last_event_id", last.front()},
                                              {"message", "what has happened meanwhile was not kept"}})));
  stream->push(units_text());
  daemons_.want_events(true);
  exchange->stream(stream, [this, stream] {
    viewers_.remove(*stream);
    if (viewers_.is_empty()) daemons_.want_events(false);
  });
}

void EventFeed::on_event(const json& event) {
  viewers_.tell(event_text("event", json_text(event), ++last_id_), member(event, "unit"), member(event, "kind"));
}

void EventFeed::on_units() {
  viewers_.tell(units_text());
}

EventText EventFeed::units_text() const {
  return event_text("units", json_text({{"units", daemons_.units()}}));
}

}  // namespace gateway
