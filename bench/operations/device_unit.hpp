#pragma once

#include <vector>

#include "bench/operations/frames.hpp"
#include "device/device.hpp"
#include "profidrive/interface/interface.hpp"

namespace bench {

/// The drive unit of the daemon on a counting bus, with a clock that the measurement moves.
struct DeviceUnit final : device::Listener {
  explicit DeviceUnit(std::size_t axes = 1)
      : unit{{.node_id = kNodeId, .axes = std::vector<device::AxisSetup>(axes)}, sink, *this} {
    unit.attach(if1);
    unit.start(now);
  }

  static constexpr std::uint8_t kNodeId = 2;

  void on_subscriptions_changed() noexcept override {}
  void on_foreign_frame(std::uint32_t) noexcept override {}

  /// NMT start of the node.
  void enter_operational();
  /// SDO download of @p size bytes that has to succeed.
  void download(canopen::sdo::Address at, std::uint32_t value, unsigned size);
  /// SDO upload; the four value bytes.
  std::uint32_t upload(canopen::sdo::Address at);
  /// Gives the unit the process-data cycle @p milliseconds (p8848) by the restart that it takes.
  void set_cycle(float milliseconds);
  /// Lets @p time pass in process-data cycles.
  void pass(canopen::Duration time);
  /// Switches every axis on and lets it reach 100 rad/s.
  void turn_axes();

  canopen::TimePoint now{std::chrono::hours{1}};
  CountingSink sink;
  device::Device unit;
  profidrive::Interface if1{unit.runner()};
};

}  // namespace bench
