#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "daemon/configuration/configuration.hpp"
#include "daemon/fleet/fleet.hpp"
#include "daemon/program/notification.hpp"
#include "daemon/program/watchdog.hpp"
#include "daemon/server/dispatcher.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// What the program serves.
struct Assignment {
  std::vector<Configuration> units;    ///< at least one
  std::size_t threads = 1;             ///< that the units are spread over
  ControlSocket control;               ///< an empty path: none
  std::filesystem::path state_root{};  ///< the states of the units lie below it
};

/// The running program. Its thread does what is rare for all units: signals, the control socket, systemd; the
/// units run on the threads of the fleet.
class Program final : private InstanceListener {
 public:
  /// Opens all that @p assignment names, which outlives this, as @p time does, nullptr: the machine's. Throws
  /// InstanceError, bus::OpenError or std::system_error.
  Program(const Assignment& assignment, const Log& log, bus::TimeShare* time = nullptr);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() override = default;

  /// Serves until stop(), SIGTERM, SIGINT or SIGHUP.
  void run();
  /// Ends run() after the event being handled: a power-off of all units.
  void stop() noexcept { stopping_ = true; }

 private:
  void on_condition(const Instance& instance, Condition condition) noexcept override {
    notification_.on_condition(instance, condition);
  }
  void on_event(const Instance& instance, const UnitEvent& event) noexcept override {
    queue_.add({&instance.configuration(), instance.started(), event});
  }
  void wait();
  void sleep(canopen::TimePoint until) noexcept;

  const Log& log_;
  bus::TimeShare* time_;
  bus::Party* party_;  ///< in that time
  Notification notification_;
  EventQueue queue_;
  Fleet fleet_;
  ServiceEvents events_;
  Watchdog watchdog_;
  std::optional<Dispatcher> dispatcher_;
  canopen::TimePoint start_over_ = canopen::kNever;
  bool more_ = false;  ///< events wait, whatever the descriptor says
  bool stopping_ = false;
};

}  // namespace axisd
