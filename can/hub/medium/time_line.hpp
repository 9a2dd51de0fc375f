#pragma once

#include <cstdint>

#include <linux/can.h>

#include "can/hub/loop/clock.hpp"
#include "libcanopen/base/time.hpp"

namespace hub {

/// The time of a bus on which frames take that of their bits: a frame begins where the one before ended, or when
/// it was handed over to an idle bus, however late anybody looks.
class TimeLine {
 public:
  /// @p bit_rate in bit/s; 0: frames take no time, and begin() and occupy() are not called. On the time line of
  /// @p clock, which outlives this.
  explicit TimeLine(std::uint32_t bit_rate, const Clock& clock = kMachineClock) noexcept
      : bit_rate_{bit_rate}, clock_{clock} {}

  [[nodiscard]] std::uint32_t bit_rate() const noexcept { return bit_rate_; }
  /// The end of what is on the bus keeps its place.
  void set_bit_rate(std::uint32_t bit_rate) noexcept;

  /// @p frame begins at @p start, which is not before end().
  void begin(const can_frame& frame, canopen::TimePoint start) noexcept;
  /// The bus is busy with @p frame behind what is on it.
  void occupy(const can_frame& frame) noexcept;
  /// End of what is on the bus, or was on it last.
  [[nodiscard]] canopen::TimePoint end() const noexcept;
  /// The same on CLOCK_REALTIME (ns).
  [[nodiscard]] std::int64_t real_end() const noexcept { return end().time_since_epoch().count() + to_real_time_; }

 private:
  std::uint32_t bit_rate_;
  const Clock& clock_;
  // The end is bits_ bit times after since_.
  canopen::TimePoint since_ = canopen::TimePoint::min();
  std::uint64_t bits_ = 0;
  std::int64_t to_real_time_ = 0;  ///< CLOCK_REALTIME minus the told time (ns)
};

}  // namespace hub
