#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/watch/unit_event.hpp"
#include "device/device.hpp"
#include "device/objects/sdo_channels.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/sdo/command.hpp"

namespace axisd {

/// Follows the downloads of all SDO servers of a unit by their frames, so that the servers themselves know nothing
/// of it, and tells what was written or refused.
class WriteWatch {
 public:
  /// @p device outlives this.
  explicit WriteWatch(const device::Device& device);

  /// A frame that the unit is about to take.
  void on_received(const canopen::Frame& frame) noexcept;
  /// A frame that the unit sends: what that ends, without its time. A read that is refused is nothing.
  std::optional<UnitEvent> on_sent(const canopen::Frame& frame) noexcept;

 private:
  enum class Phase : std::uint8_t { Idle, Initiated, Segments, LastSegment, Block };
  /// A download of one server.
  struct Download {
    Phase phase = Phase::Idle;
    canopen::sdo::Address at{};
    std::optional<device::ParameterWindow::Target> parameter{};
    std::array<std::uint8_t, 8> bytes{};
    std::size_t size = 0;  ///< bytes that have come, more than there is room for included
    std::optional<double> before{};
  };

  canopen::Identifier identifier(std::size_t number, device::SdoWay way) const noexcept;
  void begin(std::size_t server, const canopen::Frame& frame) noexcept;
  static void take(Download& download, const canopen::Frame& frame, std::size_t first, std::size_t size) noexcept;
  std::optional<double> value_of(const Download& download) const noexcept;
  double number_in(const Download& download) const noexcept;
  UnitEvent written(std::size_t server) const noexcept;
  UnitEvent refused(std::size_t server, const canopen::Frame& frame) const noexcept;

  const device::Device& device_;
  std::vector<Download> downloads_;  ///< one a server
};

}  // namespace axisd
