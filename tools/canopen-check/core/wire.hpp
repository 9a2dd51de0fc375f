#pragma once

#include <optional>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace conformance {

/// A frame on the bus, and when it passed.
struct TimedFrame {
  canopen::TimePoint time{};
  canopen::Frame frame{};
  bool sent = false;  ///< by the tester itself
};

/// The tester's way to the bus, and its clock.
class Wire {
 public:
  Wire() = default;
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;
  virtual ~Wire() = default;

  /// Sends @p frame, as soon as there is room; false if the bus is down or refuses it.
  [[nodiscard]] virtual bool send(const canopen::Frame& frame) = 0;
  /// The next frame of another station, at @p until the latest; nothing if none has come, and at once while the
  /// bus is down.
  [[nodiscard]] virtual std::optional<TimedFrame> receive(canopen::TimePoint until) = 0;
  [[nodiscard]] virtual canopen::TimePoint now() = 0;
  /// False while the bus is down or gone.
  [[nodiscard]] virtual bool up() const = 0;
  /// True from the moment on in which the user asked for the end.
  [[nodiscard]] virtual bool interrupted() const { return false; }
  /// False if the bus carries no remote frames.
  [[nodiscard]] virtual bool carries_remote_frames() const { return true; }
};

}  // namespace conformance
