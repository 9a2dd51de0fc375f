#pragma once

#include <cstdint>
#include <string>

#include "daemon/configuration/configuration.hpp"
#include "daemon/instance/bus_turn.hpp"
#include "daemon/watch/active_messages.hpp"
#include "device/device.hpp"
#include "service/log.hpp"

namespace axisd {

/// What is logged of a unit and its bus while it runs: faults and alarms as they come and go; what others on the
/// bus can cause is told once or now and then.
class BusReports {
 public:
  /// All arguments must outlive this.
  BusReports(const Configuration& configuration, const device::Device& device, const Log& log)
      : configuration_{configuration}, device_{device}, log_{log} {}

  /// At the start: what @p port has got and what it cannot carry.
  void on_open(const bus::Port& port) const;
  /// A frame of another station has come under @p identifier, one of node @p node_id.
  void on_foreign_frame(std::uint32_t identifier, int node_id) noexcept;
  /// Life guarding was asked for and stays off.
  void on_life_guarding_withheld() noexcept;
  /// The controller was to be restarted, with @p outcome.
  void on_restart(bus::Restart outcome) const noexcept;
  /// What may have changed without being told: of @p bus and of the unit.
  void look_at(const BusTurn& bus) noexcept;

  /// Frames of others under this node's identifiers.
  std::uint64_t foreign_frames() const noexcept { return foreign_frames_; }

 private:
  void log_message(std::uint8_t object, const ActiveMessages::Message& message, bool active) const;
  LogField axis_of(std::uint8_t object) const;
  void log_skipped_cycles() noexcept;
  void log_held_back(std::uint32_t axes) noexcept;
  const std::string& bus_name() const noexcept { return configuration_.address.text; }

  const Configuration& configuration_;
  const device::Device& device_;
  const Log& log_;
  ActiveMessages messages_{device_};
  bool full_logged_ = false;
  bool withheld_logged_ = false;
  std::uint64_t foreign_frames_ = 0;
  canopen::TimePoint foreign_logged_{};
  std::uint64_t skipped_seen_ = 0;
  canopen::TimePoint skipped_logged_{};
  std::uint32_t held_back_seen_ = 0;  ///< axes, as Device::held_back_axes()
};

}  // namespace axisd
