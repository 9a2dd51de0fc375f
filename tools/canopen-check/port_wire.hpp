#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "can/clock/sleeper.hpp"
#include "can/connection/connection.hpp"
#include "tools/canopen-check/core/wire.hpp"

namespace conformance {

/// When a wait for frames ends after take_signals() if a signal comes.
enum class SignalEnds : std::uint8_t {
  WaitsAfterAWhile,  ///< for who has something to clean up on the bus
  WaitsAtOnce,       ///< though the bus's time stands
};

/// A bus that was opened. Frames carry the time at which they were read.
class PortWire final : public Wire {
 public:
  /// Opens the bus at @p address and lives by its @p time, which outlives it; nullptr: by the machine's. Throws
  /// bus::OpenError if it is not there or down.
  explicit PortWire(const bus::Address& address, bus::TimeShare* time = nullptr,
                    SignalEnds signal = SignalEnds::WaitsAfterAWhile);

  bool send(const canopen::Frame& frame) override;
  std::optional<TimedFrame> receive(canopen::TimePoint until) override;
  canopen::TimePoint now() override;
  /// Frames that were lost because they were not read in time.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return connection_.port->dropped(); }
  /// When the frame that receive() gave last came from the bus (since 1970), if the bus can tell.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> arrival() const noexcept {
    return connection_.port->frame_arrival();
  }
  bool up() const override { return up_; }
  bool interrupted() const override;
  bool carries_remote_frames() const override { return connection_.port->carries_remote_frames(); }

 private:
  /// Waits until something can be read, @p until the latest; false if nothing can.
  bool wait(canopen::TimePoint until);
  [[nodiscard]] bool is_over() const;

  bus::Connection connection_;
  bus::Sleeper sleeper_;
  SignalEnds signal_;
  bool up_ = true;
};

/// From now on SIGINT and SIGTERM interrupt every PortWire instead of ending the program.
void take_signals();

}  // namespace conformance
