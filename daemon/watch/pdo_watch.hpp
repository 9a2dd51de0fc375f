#pragma once

#include <cstdint>
#include <vector>

#include "daemon/watch/frame_tap.hpp"

namespace axisd {

/// Counts the data frames of a unit by their 11-bit identifier, while somebody wants that.
class PdoWatch final : private FrameListener {
 public:
  /// What was heard under an identifier.
  struct Heard {
    std::uint64_t frames = 0;
    canopen::TimePoint last{};    ///< the last one
    canopen::TimePoint before{};  ///< the one before it, with two frames or more
    canopen::Frame frame{};       ///< the last one
  };

  /// @p tap outlives this.
  explicit PdoWatch(FrameTap& tap) noexcept : tap_{tap} {}
  ~PdoWatch() override = default;
  PdoWatch(const PdoWatch&) = delete;
  PdoWatch& operator=(const PdoWatch&) = delete;

  /// Begins to count at @p now, from 0; it goes on if it counts already. False if too many listen to the frames.
  /// Allocates.
  [[nodiscard]] bool begin(canopen::TimePoint now);
  /// Counts no longer, and forgets.
  void end() noexcept;
  bool is_on() const noexcept { return !heard_.empty(); }
  /// Since when, while it is on.
  canopen::TimePoint since() const noexcept { return since_; }
  /// What was heard under @p identifier; nullptr if it is off, or the identifier a long one.
  const Heard* heard(std::uint32_t identifier) const noexcept {
    return identifier < heard_.size() ? &heard_[identifier] : nullptr;
  }

 private:
  void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept override;

  FrameTap& tap_;
  std::vector<Heard> heard_;
  canopen::TimePoint since_{};
};

}  // namespace axisd
