#include "gateway/live/recent_events.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "gateway/base/json_text.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kLookPeriod{1};
constexpr const char* kAfter = "after";

}  // namespace

RecentEvents::RecentEvents(axisd::ServiceEvents& events, const Daemons& daemons, EventFeed& feed, LiveClock clock)
    : daemons_{daemons}, feed_{feed}, clock_{std::move(clock)} {
  sweep_ = events.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<RecentEvents*>(self)->sweep();
        return 0;
      },
      this);
}

RecentEvents::~RecentEvents() {
  if (is_keeping()) feed_.follow(nullptr);
}

void RecentEvents::begin() {
  first_ = feed_.follow(this);
  axisd::ServiceEvents::start(sweep_, kLookPeriod);
}

void RecentEvents::sweep() {
  if (!is_keeping()) return;
  if (clock_() - asked_ <= kPatience) return axisd::ServiceEvents::start(sweep_, kLookPeriod);
  feed_.follow(nullptr);
  kept_.clear();
  first_ = 0;
}

void RecentEvents::on_event(const EventFeed::Told& told) {
  json event = told.event;
  event["id"] = told.id;
  kept_.push_back({told.id, told.unit, told.kind, json_text(event)});
  if (kept_.size() > kMostEvents) kept_.pop_front();
}

Response RecentEvents::answer(const Query& query, const json& params) {
  const auto filter = event_filter(query);
  if (!filter) return response_of(filter.error());
  const bool is_first = !params.contains(kAfter);
  if (!is_first && (!params[kAfter].is_number_integer() || params[kAfter] < 0))
    return response_of(
        refuse(Refused::BadRequest, "after: expected `last` of an answer before, or the id of an event"));
  asked_ = clock_();
  if (!is_keeping()) begin();
  const std::uint64_t last = feed_.last_id();
  const auto given = params.value(kAfter, std::uint64_t{0});
  // A number of which it is not known what has come since: all that are kept are told.
  const bool is_known = first_ <= given && given <= last;
  const std::uint64_t after = is_known ? given : 0;
  const std::uint64_t before_kept = kept_.empty() ? last : kept_.front().id - 1;
  std::string body;
  for (const Event& event : kept_)
    if (event.id > after && filter->takes(event.unit, event.kind))
      body.append(body.empty() ? "" : ",").append(event.text);
  return {.body = fmt::format("{{\"last\":{},\"events\":[{}],\"lost\":{},\"restarted\":{},\"units\":{}}}\n", last,
                              body, is_known && before_kept > after ? before_kept - after : 0,
                              !is_first && !is_known, json_text(daemons_.units()))};
}

}  // namespace gateway
