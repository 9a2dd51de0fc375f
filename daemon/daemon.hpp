#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bus/link_monitor.hpp"
#include "bus/socket_can.hpp"
#include "bus/transmit_queue.hpp"
#include "daemon/configuration.hpp"
#include "daemon/control_server.hpp"
#include "daemon/instance_lock.hpp"
#include "daemon/log.hpp"
#include "daemon/service_events.hpp"
#include "daemon/timer.hpp"
#include "device/device.hpp"

namespace axisd {

/// The running program: one drive unit on one CAN interface, moved by one poll over the CAN socket, one timer and
/// the rare events.
class Daemon final : private device::Listener {
 public:
  /// Opens everything that @p configuration names, with the state below @p state_root and the control socket at
  /// @p control (empty: none). Throws InstanceError, bus::OpenError or std::system_error.
  Daemon(const Configuration& configuration, const std::filesystem::path& state_root, const std::string& control,
         const Log& log);
  ~Daemon() override = default;
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// Serves until stop(), SIGTERM or SIGINT.
  void run();
  /// Ends run() after the event being handled: a power-off of the unit.
  void stop() noexcept { stopping_ = true; }

  /// Raises a fault or alarm on the axis.
  tl::expected<void, drive::FaultError> raise(std::uint16_t number) noexcept;
  /// Acknowledges the faults of the axis; true if none is left.
  bool acknowledge() noexcept;
  /// Sets the load torque of the axis (N·m).
  void set_load_torque(double torque) noexcept;

  const Configuration& configuration() const noexcept { return configuration_; }
  const device::Device& device() const noexcept { return device_; }
  const bus::TransmitQueue& transmit_queue() const noexcept { return queue_; }
  bus::ErrorState bus_state() const noexcept { return port_.error_state(); }
  bool link_is_up() const noexcept { return link_is_up_; }
  /// Load torque as last set (N·m).
  double load_torque() const noexcept { return load_torque_; }
  /// Frames received, frames lost in the socket, and frames of others under this node's identifiers.
  std::uint64_t received() const noexcept { return received_; }
  std::uint64_t receive_overflows() const noexcept { return port_.dropped(); }
  std::uint64_t foreign_frames() const noexcept { return foreign_frames_; }
  /// Seconds since the start.
  double uptime_s() const noexcept;

 private:
  void on_subscriptions_changed() noexcept override;
  void on_foreign_frame(std::uint32_t identifier) noexcept override;

  void turn() noexcept;
  void receive(canopen::TimePoint now) noexcept;
  bool receive_frame(canopen::TimePoint now) noexcept;
  void log_full_queue() noexcept;
  void log_skipped_cycles(canopen::TimePoint now) noexcept;
  void power_on() noexcept;
  void tell_ready() noexcept;
  void link_up() noexcept;
  void link_down() noexcept;
  static int on_link(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  void log_receive_buffer() const;

  const Configuration& configuration_;
  const Log& log_;
  canopen::TimePoint started_;
  InstanceLock lock_;
  bus::LinkMonitor link_;
  bus::SocketCan port_;
  bus::TransmitQueue queue_;
  device::Device device_;
  Timer timer_;
  ServiceEvents events_;
  EventSource link_source_;
  std::optional<ControlServer> control_;
  std::vector<bus::Filter> filters_;

  bool stopping_ = false;
  bool link_is_up_ = false;
  bool ready_told_ = false;
  bool full_logged_ = false;
  bool in_burst_ = false;
  unsigned turns_with_frames_ = 0;
  double load_torque_;
  std::uint64_t received_ = 0;
  std::uint64_t foreign_frames_ = 0;
  canopen::TimePoint foreign_logged_{};
  std::uint64_t skipped_seen_ = 0;
  canopen::TimePoint skipped_logged_{};
  std::uint64_t sent_before_boot_up_ = 0;
};

}  // namespace axisd
