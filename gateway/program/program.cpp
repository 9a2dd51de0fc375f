#include "gateway/program/program.hpp"

#include <stdexcept>

#include <systemd/sd-daemon.h>

#include "gateway/page/share_folder.hpp"
#include "gateway/program/farm_reach.hpp"
#include "gateway/security/token.hpp"

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

}  // namespace

Program::Program(const Options& options, const axisd::Log& log)
    : log_{log},
      events_{[this] { is_stopping_ = true; }},
      loop_{events_, log},
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
  while (!daemons_.are_known() && !is_late && !is_stopping_) loop_.turn();
  for (const Authority& address : server_.addresses()) {
    log_.info("ready: http://{}/", address.text());
    if (!is_loopback(address.host))
      log_.notice("{} can be reached from other machines: whoever reaches it may read without a token",
                  address.text());
  }
  sd_notify(0, "READY=1");
  while (!is_stopping_) loop_.turn();
  sd_notify(0, "STOPPING=1");
}

void Program::beat() {
  event_feed_.beat();
  sample_feed_.beat();
  frame_feed_.beat();
  axisd::ServiceEvents::start(beat_, kHeartbeat);
}

}  // namespace gateway
