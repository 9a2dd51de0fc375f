#pragma once

#include <vector>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace zoo {

/// A node on some bus: fed with frames and time, as libcanopen is.
class Station {
 public:
  Station() = default;
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;
  virtual ~Station() = default;

  virtual void on_frame(const canopen::Frame& frame, canopen::TimePoint now) = 0;
  virtual void on_time(canopen::TimePoint now) = 0;
  [[nodiscard]] virtual canopen::TimePoint next_deadline() const = 0;
  /// What it has sent since the last call.
  [[nodiscard]] virtual std::vector<canopen::Frame> take_frames() = 0;
};

}  // namespace zoo
