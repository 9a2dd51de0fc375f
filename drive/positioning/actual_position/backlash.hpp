#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace drive {

/// Play between encoder and load (p2583): after a reversal the encoder moves through it before the load moves. The
/// compensation (r2667) is what lies between the two, 0 where the reference was set.
class Backlash {
 public:
  /// The play is @p size (LU; negative: the load moves first) from now on.
  void set_size(std::int64_t size) noexcept {
    size_ = size;
    left_ = std::clamp<std::int64_t>(left_, 0, std::abs(size));
    at_reference_ = std::clamp<std::int64_t>(at_reference_, 0, std::abs(size));
  }
  /// From here on the compensation counts, or does not. Where it begins, the load touches the side that the
  /// encoder has come with.
  void activate(bool active) noexcept {
    if (active && !active_) at_reference_ = left_ = backwards_ ? std::abs(size_) : 0;
    active_ = active;
  }
  /// The encoder has moved by @p way (LU).
  void move(std::int64_t way) noexcept {
    left_ = after(way);
    if (way != 0) backwards_ = way < 0;
  }

  /// r2667 (LU): what is to be added to the place of the encoder.
  std::int64_t compensation() const noexcept { return shown(left_); }
  /// The same after a further @p way (LU) of the encoder.
  std::int64_t compensation_after(std::int64_t way) const noexcept { return shown(after(way)); }
  std::int64_t size() const noexcept { return size_; }

 private:
  std::int64_t after(std::int64_t way) const noexcept {
    return std::clamp<std::int64_t>(left_ - way, 0, std::abs(size_));
  }
  std::int64_t shown(std::int64_t left) const noexcept {
    if (!active_) return 0;
    return size_ < 0 ? at_reference_ - left : left - at_reference_;
  }

  std::int64_t size_ = 0;
  std::int64_t left_ = 0;          // LU that the encoder is behind its foremost place against the load
  std::int64_t at_reference_ = 0;  // the same where the compensation began
  bool active_ = false;
  bool backwards_ = false;
};

}  // namespace drive
