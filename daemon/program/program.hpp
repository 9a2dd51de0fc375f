#pragma once

#include <algorithm>
#include <filesystem>
#include <list>
#include <span>
#include <string>

#include "daemon/base/log.hpp"
#include "daemon/instance/instance.hpp"
#include "daemon/program/control_server.hpp"
#include "daemon/program/event_loop.hpp"
#include "daemon/program/instance_lock.hpp"
#include "daemon/program/notification.hpp"
#include "daemon/program/service_events.hpp"
#include "daemon/program/watchdog.hpp"

namespace axisd {

/// A unit to be served.
struct Assignment {
  Configuration configuration;
  std::string control;  ///< path of its control socket; empty: none
};

/// The running program: its instances on one EventLoop; sd-event serves what is rare.
class Program final : private Service {
 public:
  /// Opens all that @p assignments name, which outlive this, with the states below @p state_root. Throws
  /// InstanceError, bus::OpenError or std::system_error.
  Program(std::span<const Assignment> assignments, const std::filesystem::path& state_root, const Log& log);
  ~Program() override = default;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Serves until stop(), SIGTERM, SIGINT or SIGHUP.
  void run();
  /// Ends run() after the event being handled: a power-off of all units.
  void stop() noexcept { stopping_ = true; }

 private:
  /// An instance, and what keeps others from its node.
  struct Unit {
    Unit(const Configuration& configuration, const std::filesystem::path& state_root, const Log& log,
         InstanceListener& listener);
    InstanceLock lock;
    Instance instance;
  };

  std::list<Unit> make_units(std::span<const Assignment> assignments, const std::filesystem::path& state_root);
  bool on_rare_event() noexcept override { return events_.dispatch(); }
  void on_chores(canopen::TimePoint now) noexcept override;
  canopen::TimePoint next_chores() const noexcept override { return std::min(watchdog_.due(), log_.due()); }
  void attach(Instance& instance);
  void open_control(Instance& instance, const std::string& path);
  static int on_rare(sd_event_source* source, int descriptor, std::uint32_t events, void* watched) noexcept;

  const Log& log_;
  Notification notification_;
  std::list<Unit> units_;
  ServiceEvents events_;
  EventLoop loop_;
  Watchdog watchdog_;
  std::list<Instance::RareSource> watched_;
  std::list<EventSource> sources_;
  std::list<ControlServer> controls_;
  bool stopping_ = false;
};

}  // namespace axisd
