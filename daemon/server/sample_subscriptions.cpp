#include "daemon/server/sample_subscriptions.hpp"

#include <algorithm>
#include <utility>

#include "daemon/control/trace/trace_view.hpp"
#include "daemon/server/stream_lines.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Beyond what comes in the time of a line: samples of so many lines, and some more.
constexpr std::size_t kSpareLines = 4;
constexpr std::size_t kSpareSamples = 64;

SampleBuffer::Plan plan_of(const json& params) {
  const json& signals = params.at("signals");
  return {.signals = signals.is_string() ? std::vector{signals.get<std::string>()}
                                         : signals.get<std::vector<std::string>>(),
          .period = std::chrono::milliseconds{params.at("period_ms").get<std::int64_t>()}};
}

Outcome begun(const Call& call, const std::shared_ptr<SampleBuffer>& buffer) {
  const auto outcome = call.instance.sample_stream().begin(buffer);
  if (!outcome) return tl::unexpected{error_of(outcome.error())};
  return json::object();
}

}  // namespace

void SampleSubscriptions::subscribe(ClientId client, ServedUnit& unit, const json& params,
                                    std::function<void(Outcome)> done) {
  const std::chrono::milliseconds period{params.at("batch_ms").get<std::int64_t>()};
  SampleBuffer::Plan plan = plan_of(params);
  const auto in_a_line = static_cast<std::size_t>(period / plan.period) + 1;
  auto buffer = std::make_shared<SampleBuffer>(std::move(plan), in_a_line * kSpareLines + kSpareSamples);
  run_(
      unit, [buffer](const Call& call) { return begun(call, buffer); },
      [this, client, &unit, buffer, period, done = std::move(done)](Outcome outcome) {
        if (outcome) begin({this, client, &unit, buffer, period});
        done(std::move(outcome));
      });
}

void SampleSubscriptions::begin(Feed feed) {
  if (!server_.has(feed.client)) return stop(*feed.unit, feed.buffer);
  end(feed.client);
  Feed& begun = feeds_.emplace_back(std::move(feed));
  begun.timer = events_.timer(&SampleSubscriptions::on_period, &begun);
  ServiceEvents::start(begun.timer, begun.period);
}

void SampleSubscriptions::end(ClientId client) {
  const auto feed = std::ranges::find(feeds_, client, &Feed::client);
  if (feed == feeds_.end()) return;
  stop(*feed->unit, feed->buffer);
  feeds_.erase(feed);
}

void SampleSubscriptions::stop(ServedUnit& unit, const std::shared_ptr<SampleBuffer>& buffer) {
  const auto end = [buffer](const Call& call) -> Outcome {
    call.instance.sample_stream().end(*buffer);
    return json::object();
  };
  run_(unit, end, [](const Outcome&) {});
}

bool SampleSubscriptions::has(ClientId client) const noexcept {
  return std::ranges::find(feeds_, client, &Feed::client) != feeds_.end();
}

/// Signals that there were are there again.
void SampleSubscriptions::take_up(const ServedUnit& unit, Instance& instance) {
  for (const Feed& feed : feeds_)
    if (feed.unit == &unit) static_cast<void>(instance.sample_stream().begin(feed.buffer));
}

int SampleSubscriptions::on_period(sd_event_source*, std::uint64_t, void* userdata) noexcept {
  const auto& feed = *static_cast<Feed*>(userdata);
  ServiceEvents::start(feed.timer, feed.period);
  ControlServer& server = feed.owner->server_;
  const ClientId client = feed.client;
  for (const std::string& line : sample_lines(feed.unit->name(), *feed.buffer))
    server.push(client, line);  // which may be the end of the feed
  return 0;
}

}  // namespace axisd
