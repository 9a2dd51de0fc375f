#pragma once

#include <memory>
#include <string_view>

#include "gateway/api/all_units.hpp"
#include "gateway/api/eds_files.hpp"
#include "gateway/api/overview.hpp"
#include "gateway/live/live_feeds.hpp"
#include "gateway/live/recent_events.hpp"
#include "gateway/page/page_files.hpp"
#include "gateway/routes/router.hpp"
#include "gateway/security/access.hpp"
#include "gateway/server/http_server.hpp"
#include "gateway/streams/event_feed.hpp"
#include "gateway/streams/unit_feed.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// What is behind the routes.
struct Sources {
  Daemons& daemons;
  EventFeed& events;
  UnitFeed& samples;
  UnitFeed& frames;
  LiveFeeds& live;
  RecentEvents& recent;
  const PageFiles& page;
  EdsFiles& eds;
};

/// Does what the route of a request says, if the request may have it.
class Api final : public HttpServer::Requests {
 public:
  /// All that @p sources names outlives it.
  Api(AccessRules rules, const Sources& sources)
      : rules_{std::move(rules)}, sources_{sources}, all_units_{sources.daemons} {}

  /// Whose counters `/metrics` shows; outlives it.
  void show(const Counters& counters) noexcept { counters_ = &counters; }

 private:
  void on_headers(Exchange& exchange) override;
  void on_request(const std::shared_ptr<Exchange>& exchange) override;
  [[nodiscard]] tl::expected<void, Error> check(const Request& request) const;
  void call(const std::shared_ptr<Exchange>& exchange, const Match& match, nlohmann::json params) const;
  void send_eds(const std::shared_ptr<Exchange>& exchange, const Match& match) const;

  AccessRules rules_;
  Sources sources_;
  AllUnits all_units_;
  const Counters* counters_ = nullptr;
};

}  // namespace gateway
