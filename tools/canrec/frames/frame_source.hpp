#pragma once

#include <chrono>
#include <optional>

#include <linux/can.h>

#include "tools/canrec/frames/failure.hpp"

namespace canrec {

/// A frame, and when it was on the bus.
struct TimedFrame {
  std::chrono::nanoseconds at{};  ///< since 1970
  can_frame frame{};              ///< identifier with its flags
};

/// Where frames come from, one after the other.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  virtual ~FrameSource() = default;

  /// The next frame, nothing at the end. After a failure there is no further one.
  [[nodiscard]] virtual Expected<std::optional<TimedFrame>> next() = 0;
};

}  // namespace canrec
