#include "gateway/program/program.hpp"

#include <algorithm>
#include <stdexcept>

#include <poll.h>
#include <systemd/sd-daemon.h>

#include "gateway/page/share_folder.hpp"
#include "gateway/program/farm_reach.hpp"
#include "gateway/security/token.hpp"
#include "service/clock.hpp"

namespace gateway {
namespace {

constexpr std::chrono::seconds kHeartbeat{15};
constexpr std::chrono::seconds kPatience{1};

AccessRules rules_of(const Options& options) {
  AccessRules rules{.listen = options.listen,
                    .allow_hosts = options.allow_hosts,
                    .allow_origins = options.allow_origins,
                    .read_only = options.read_only};
  if (options.read_only) return rules;
  auto path =
      options.token_file.empty() ? token_path() : tl::expected<std::string, std::string>{options.token_file};
  if (!path) throw std::runtime_error{path.error()};
  auto token = load_token(*path);
  if (!token) throw std::runtime_error{token.error()};
  rules.token = *std::move(token);
  return rules;
}

std::unique_ptr<Reach> reach_of(const Options& options) {
  if (options.farm) return std::make_unique<FarmReach>(*options.farm);
  return std::make_unique<SocketReach>(options.sockets);
}

/// Where the page lies.
std::string page_place(const Options& options) {
  return options.page.empty() ? (share_folder() / "web").string() : options.page;
}

/// Until @p when, rounded up, for poll(); negative: for ever.
int milliseconds_until(canopen::TimePoint when) noexcept {
  constexpr canopen::Duration kLongest = std::chrono::hours{1};
  if (when == canopen::kNever) return -1;
  const canopen::Duration left = std::clamp(when - axisd::read_clock(), canopen::Duration{0}, kLongest);
  return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count());
}

}  // namespace

Program::Program(const Options& options, const axisd::Log& log)
    : log_{log},
      events_{[this] { is_stopping_ = true; }},
      daemons_{events_, reach_of(options), log},
      event_feed_{daemons_},
      sample_feed_{events_, daemons_, kSampleFeed},
      frame_feed_{events_, daemons_, kFrameFeed},
      live_feeds_{events_, daemons_},
      recent_events_{events_, daemons_, event_feed_},
      page_{page_place(options)},
      eds_{share_folder() / "eds"},
      api_{rules_of(options),
           {daemons_, event_feed_, sample_feed_, frame_feed_, live_feeds_, recent_events_, page_, eds_}},
      server_{events_, options.listen, api_} {
  api_.show(server_.counters());
  if (page_.start() == nullptr) log_.notice("{}: no page is there, browsers get a list", page_place(options));
  beat_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<Program*>(self)->beat();
        return 0;
      },
      this);
  beat();
  std::uint64_t period = 0;
  if (sd_watchdog_enabled(0, &period) <= 0) return;
  watchdog_period_ = std::chrono::microseconds{period} / 2;  // as sd_watchdog_enabled(3) recommends
  watchdog_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<Program*>(self)->feed_watchdog();
        return 0;
      },
      this);
  feed_watchdog();
}

/// Who hears that it is ready asks for the units: those that are there are known by then, unless a daemon is slow.
void Program::run() {
  bool is_late = false;
  const axisd::EventSource patience = events_.timer(
      [](sd_event_source*, std::uint64_t, void* late) noexcept {
        *static_cast<bool*>(late) = true;
        return 0;
      },
      &is_late);
  axisd::ServiceEvents::start(patience, kPatience);
  while (!daemons_.are_known() && !is_late && !is_stopping_) wait();
  for (const Authority& address : server_.addresses()) {
    log_.info("ready: http://{}/", address.text());
    if (!is_loopback(address.host))
      log_.notice("{} can be reached from other machines: whoever reaches it may read without a token",
                  address.text());
  }
  sd_notify(0, "READY=1");
  while (!is_stopping_) wait();
  sd_notify(0, "STOPPING=1");
}

void Program::wait() {
  pollfd rare{events_.descriptor(), POLLIN, 0};
  if (!more_) ::poll(&rare, 1, milliseconds_until(log_.due()));
  more_ = events_.dispatch();
  if (const canopen::TimePoint now = axisd::read_clock(); log_.due() <= now) log_.tell_left_out(now);
}

void Program::beat() {
  event_feed_.beat();
  sample_feed_.beat();
  frame_feed_.beat();
  axisd::ServiceEvents::start(beat_, kHeartbeat);
}

void Program::feed_watchdog() {
  sd_notify(0, "WATCHDOG=1");
  axisd::ServiceEvents::start(watchdog_, watchdog_period_);
}

}  // namespace gateway
