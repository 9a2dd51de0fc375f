#pragma once

#include <cstdint>
#include <memory>

#include <nlohmann/json.hpp>

#include "can/hub/faults/effects.hpp"
#include "can/hub/faults/frame_range.hpp"
#include "can/hub/faults/side.hpp"
#include "injection/language/fault.hpp"
#include "injection/language/trigger.hpp"

namespace hub::faults {

/// A fault of the bus and what has come of it so far.
class LoadedFault {
 public:
  /// @p fault is one of injection::bus_kinds(), and has number @p number from @p now on; std::bad_alloc.
  LoadedFault(std::uint32_t number, injection::Fault fault, Medium& medium, Interfaces& interfaces,
              canopen::TimePoint now);
  LoadedFault(const LoadedFault&) = delete;
  LoadedFault& operator=(const LoadedFault&) = delete;
  ~LoadedFault() = default;

  /// @p passage has come to its end on the wire at @p end, and becomes what @p fate says so far.
  void judge(const Passage& passage, Fate& fate, canopen::TimePoint end) noexcept;
  /// Looks at the time alone.
  void on_time(canopen::TimePoint now) noexcept;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;

  /// Whether it is a line that is cut at @p now.
  [[nodiscard]] bool is_cut(canopen::TimePoint now) noexcept;
  /// Whether that keeps @p frame from passing between @p one and @p other.
  [[nodiscard]] bool parts(const can_frame& frame, const Identity& one, const Identity& other) const noexcept {
    return range_.has(frame) && side_.has(one) != side_.has(other);
  }
  /// The bit rate that it wants now (bit/s), 0 = none.
  [[nodiscard]] std::uint32_t bit_rate() const noexcept;

  [[nodiscard]] std::uint32_t number() const noexcept { return number_; }
  /// Number, what was said, state and counts.
  [[nodiscard]] nlohmann::json json() const;

 private:
  void follow(const can_frame& frame, const injection::Occurrence& occurrence, canopen::TimePoint now) noexcept;

  std::uint32_t number_;
  injection::Fault fault_;
  const Effect& effect_;
  FrameRange range_;
  Side side_;
  injection::Trigger trigger_;
  std::unique_ptr<Talker> talker_;
};

}  // namespace hub::faults
