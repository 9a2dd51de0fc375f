#pragma once

#include "gateway/api/api.hpp"
#include "gateway/program/options.hpp"
#include "gateway/server/http_server.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"
#include "service/service_loop.hpp"

namespace gateway {

/// The running program: one loop for the clients, the daemons and systemd.
class Program {
 public:
  /// Opens all that @p options name. Throws std::runtime_error with one line.
  Program(const Options& options, const axisd::Log& log);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() = default;

  /// Serves until SIGTERM, SIGINT or SIGHUP.
  void run();

 private:
  void beat();

  const axisd::Log& log_;
  bool is_stopping_ = false;
  axisd::ServiceEvents events_;
  axisd::ServiceLoop loop_;
  Daemons daemons_;
  EventFeed event_feed_;
  UnitFeed sample_feed_;
  UnitFeed frame_feed_;
  LiveFeeds live_feeds_;
  RecentEvents recent_events_;
  PageFiles page_;
  EdsFiles eds_;
  Api api_;
  HttpServer server_;
  axisd::EventSource beat_;
};

}  // namespace gateway
