#include "gateway/live/live_feeds.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "gateway/live/live_answer.hpp"
#include "os/clock.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds kPeriod{1};

/// What is subscribed to, in the order of LiveFeeds::What.
struct Row {
  std::string_view method;
  std::string_view notice;
};
constexpr std::array kRows{Row{"samples.subscribe", "samples"}, Row{"frames.subscribe", "frames"}};

template <class What>
constexpr const Row& row_of(What what) noexcept {
  return kRows[static_cast<std::size_t>(what)];
}

/// Where the numbers of feeds begin: those of another gateway are others.
std::uint64_t random_number() {
  std::random_device device;
  return (std::uint64_t{device()} << 32U) + device();
}

}  // namespace

LiveTime live_time() noexcept {
  return std::chrono::duration_cast<LiveTime>(os::monotonic_time());
}

LiveFeeds::LiveFeeds(axisd::ServiceEvents& events, Daemons& daemons, LiveClock clock)
    : events_{events}, daemons_{daemons}, clock_{std::move(clock)}, last_number_{random_number()} {
  sweep_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<LiveFeeds*>(self)->sweep();
        return 0;
      },
      this);
}

/// Whoever still waits is told while there is none that could be found.
LiveFeeds::~LiveFeeds() {
  const std::list<Feed> last = std::exchange(feeds_, {});
  settle();
}

void LiveFeeds::answer(const std::shared_ptr<Exchange>& exchange, const std::string& unit, const json& params) {
  if (const auto daemon = daemons_.find(unit); !daemon) return exchange->answer(daemon.error());
  const auto wanted = live_request(unit, params);
  if (!wanted) return exchange->answer(wanted.error());
  Poll poll{exchange, wanted->after};
  for (const auto& [what, subscription] :
       {std::pair{What::Samples, &wanted->samples}, std::pair{What::Frames, &wanted->frames}}) {
    if (subscription->is_null()) continue;
    const auto feed = feed_of(what, *subscription);
    if (!feed) return exchange->answer(feed.error());
    poll.feeds.push_back((*feed)->number);
  }
  if (!settle(poll)) polls_.push_back(std::move(poll));
}

tl::expected<LiveFeeds::Feed*, Error> LiveFeeds::feed_of(What what, const json& params) {
  const auto daemon = daemons_.find(params.at("unit").get_ref<const std::string&>());
  if (!daemon) return tl::unexpected{daemon.error()};
  const std::string& path = (*daemon)->path();
  const auto is_it = [&](const Feed& feed) {
    return feed.what == what && feed.params == params && feed.client->path() == path && !feed.refusal;
  };
  const auto known = std::ranges::find_if(feeds_, is_it);
  if (known == feeds_.end()) return begin(what, params, path);
  known->asked = clock_();
  return &*known;
}

tl::expected<LiveFeeds::Feed*, Error> LiveFeeds::begin(What what, const json& params, const std::string& path) {
  const auto is_like_it = [&](const Feed& feed) { return feed.what == what && feed.client->path() == path; };
  if (static_cast<std::size_t>(std::ranges::count_if(feeds_, is_like_it)) >= kMostFeeds)
    return tl::unexpected{refuse(Refused::TooMany, fmt::format("{} different feeds of {} are open at this daemon",
                                                               kMostFeeds, row_of(what).notice))};
  auto opened = daemons_.connect(path, *this);
  if (!opened) return tl::unexpected{refuse(Refused::NoDaemon, opened.error())};
  DaemonClient& client = **opened;
  Feed& feed = feeds_.emplace_back(Feed{what, params, ++last_number_, *std::move(opened), clock_()});
  if (feeds_.size() == 1) axisd::ServiceEvents::start(sweep_, kPeriod);
  client.ask(row_of(what).method, params, [this, &client](const Answer& answer) { take_answer(client, answer); });
  return &feed;
}

void LiveFeeds::take_answer(const DaemonClient& client, const Answer& answer) {
  Feed* const feed = find(client);
  if (feed == nullptr) return;
  feed->is_granted = answer.has_value();
  if (!answer) feed->refusal = answer.error();
  settle();
  if (!answer) sweep_soon();
}

void LiveFeeds::settle() {
  std::erase_if(polls_, [this](const Poll& poll) { return settle(poll); });
}

/// Whether it is answered.
bool LiveFeeds::settle(const Poll& poll) {
  std::vector<Positioned> found;
  for (const std::uint64_t number : poll.feeds) {
    Feed* const feed = find(number);
    if (feed == nullptr)
      return poll.exchange->answer(refuse(Refused::NoDaemon, "the connection to the daemon has ended")), true;
    if (feed->refusal) return poll.exchange->answer(*feed->refusal), true;
    if (!feed->is_granted) return false;
    feed->lines.forget(clock_());
    found.push_back({number, row_of(feed->what).notice, &feed->lines});
  }
  poll.exchange->answer(live_answer(found, poll.after));
  return true;
}

/// It is kept as it has come, but looked at: an answer is put together of such texts.
bool LiveFeeds::on_notice_text(DaemonClient& client, std::string_view key, std::string_view value) {
  Feed* const feed = find(client);
  if (feed == nullptr || key != row_of(feed->what).notice || !json::accept(value)) return false;
  feed->lines.push(value, clock_());
  return true;
}

void LiveFeeds::on_notice(DaemonClient&, std::string_view, const json&) {}

void LiveFeeds::on_gone(DaemonClient& client, const std::string&) {
  std::erase_if(feeds_, [&client](const Feed& feed) { return feed.client.get() == &client; });
  settle();
}

/// Not where an answer is taken: its connection is in the midst of telling it.
void LiveFeeds::sweep_soon() {
  axisd::ServiceEvents::start(sweep_, std::chrono::microseconds{0});
}

void LiveFeeds::sweep() {
  const LiveTime now = clock_();
  for (Feed& feed : feeds_) {
    feed.lines.forget(now);
    if (feed.client->is_silent())
      feed.client->give_up(
          refuse(Refused::SilentDaemon, fmt::format("{}: the daemon does not answer", feed.client->path())));
  }
  std::erase_if(feeds_, [now](const Feed& feed) {
    return feed.refusal || (feed.is_granted && now - feed.asked > kPatience);
  });
  settle();
  if (!feeds_.empty()) axisd::ServiceEvents::start(sweep_, kPeriod);
}

LiveFeeds::Feed* LiveFeeds::find(const DaemonClient& client) noexcept {
  const auto found = std::ranges::find(feeds_, &client, [](const Feed& feed) { return feed.client.get(); });
  return found == feeds_.end() ? nullptr : &*found;
}

LiveFeeds::Feed* LiveFeeds::find(std::uint64_t number) noexcept {
  const auto found = std::ranges::find(feeds_, number, &Feed::number);
  return found == feeds_.end() ? nullptr : &*found;
}

}  // namespace gateway
