#pragma once

#include "gateway/api/api.hpp"
#include "gateway/program/options.hpp"
#include "gateway/server/http_server.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

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
  void wait();
  void beat();
  void feed_watchdog();

  const axisd::Log& log_;
  bool is_stopping_ = false;
  axisd::ServiceEvents events_;
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
  axisd::EventSource watchdog_;
  std::chrono::microseconds watchdog_period_{0};
  bool more_ = false;  ///< events wait, whatever the descriptor says
};

}  // namespace gateway
