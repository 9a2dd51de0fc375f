#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "can/connection/connection.hpp"
#include "os/descriptor.hpp"
#include "os/timer.hpp"
#include "tools/canrec/frames/frame_source.hpp"
#include "tools/canrec/frames/time_range.hpp"
#include "tools/canrec/play/pace.hpp"

namespace canrec {

/// Opens the bus at @p address to play onto it.
[[nodiscard]] Expected<bus::Connection> open_bus(const bus::Address& address);

/// Sends frames onto a bus when they are due, as a member that hears nothing.
class Player {
 public:
  struct Figures {
    std::uint64_t sent = 0;
    std::uint64_t refused = 0;            ///< that the bus cannot carry
    std::uint64_t errors = 0;             ///< error frames, which nobody can send
    std::chrono::nanoseconds latest{};    ///< by which a frame was sent late at most
    std::chrono::nanoseconds duration{};  ///< from the first frame to the last one
  };

  /// Onto the bus of @p connection, which messages call @p name, at @p pace. SIGINT and SIGTERM end play() from
  /// now on. Throws std::system_error if the kernel gives no descriptor.
  Player(bus::Connection connection, std::string name, Pace pace);

  /// Plays those frames of @p source that are in @p range. False if a signal has ended it, which signal() says.
  [[nodiscard]] Expected<bool> play(FrameSource& source, const TimeRange& range);
  [[nodiscard]] int signal() const noexcept { return signal_; }
  [[nodiscard]] const Figures& figures() const noexcept { return figures_; }

 private:
  /// Why a wait has ended.
  enum class Woken : std::uint8_t { Time, Signal, Down };

  [[nodiscard]] Expected<bool> present(const TimedFrame& frame);
  [[nodiscard]] Expected<bool> send(const can_frame& frame);
  [[nodiscard]] Woken wait_until(canopen::TimePoint when);
  [[nodiscard]] bool hears_of_end();
  [[nodiscard]] tl::unexpected<Failure> down() const;

  bus::Connection connection_;
  std::string name_;
  Pace pace_;
  os::Descriptor signals_;
  os::Timer timer_;
  canopen::TimePoint begin_{};
  unsigned unheard_ = 0;  ///< frames sent since wait_until()
  Figures figures_;
  int signal_ = 0;
};

}  // namespace canrec
