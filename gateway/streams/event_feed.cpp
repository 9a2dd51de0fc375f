#include "gateway/streams/event_feed.hpp"

#include <fmt/format.h>

#include "gateway/base/json_text.hpp"
#include "os/clock.hpp"

namespace gateway {
namespace {

using nlohmann::json;

std::string member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

}  // namespace

/// Numbers by the clock: those of a gateway before were lower. A program that counts in doubles has them exactly.
EventFeed::EventFeed(Daemons& daemons)
    : daemons_{daemons},
      last_id_{static_cast<std::uint64_t>(
          std::chrono::duration_cast<std::chrono::microseconds>(os::wall_time()).count())} {
  daemons_.listen(this);
}

void EventFeed::open(const std::shared_ptr<Exchange>& exchange, const Query& query) {
  auto filter = event_filter(query);
  if (!filter) return exchange->answer(filter.error());
  if (viewers_.size() >= kMostViewers)
    return exchange->answer(refuse(Refused::TooMany, fmt::format("{} streams are open already", viewers_.size())));
  const auto stream = viewers_.add(*std::move(filter));
  if (const auto last = exchange->request().header("last-event-id"); !last.empty())
    stream->push(event_text("gap", json_text({{"last_event_id", last.front()},
                                              {"message", "what has happened meanwhile was not kept"}})));
  stream->push(units_text());
  ask_daemons();
  exchange->stream(stream, [this, stream] {
    viewers_.remove(*stream);
    ask_daemons();
  });
}

std::uint64_t EventFeed::follow(Follower* follower) {
  follower_ = follower;
  ask_daemons();
  return ++last_id_;
}

void EventFeed::ask_daemons() {
  daemons_.want_events(!viewers_.is_empty() || follower_ != nullptr);
}

void EventFeed::on_event(const json& event) {
  const std::string unit = member(event, "unit");
  const std::string kind = member(event, "kind");
  ++last_id_;
  viewers_.tell(event_text("event", json_text(event), last_id_), unit, kind);
  if (follower_ != nullptr) follower_->on_event({last_id_, unit, kind, event});
}

void EventFeed::on_units() {
  viewers_.tell(units_text());
}

EventText EventFeed::units_text() const {
  return event_text("units", json_text({{"units", daemons_.units()}}));
}

}  // namespace gateway
