#include "drive/positioning/profile/sliding_mean.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drive {

void SlidingMean::start(std::size_t cycles) noexcept {
  const std::size_t length = std::min(cycles, cycles_.size());
  if (length == length_ && is_settled()) return;
  length_ = length;
  std::fill_n(cycles_.begin(), length_, Cycle{});
  next_ = 0;
  still_ = length_;
  settle();
}

void SlidingMean::add(const MotionStretch& stretch, double velocity) noexcept {
  if (length_ == 0) return;
  const bool moved = std::abs(stretch.way) > 0.0 || std::abs(stretch.area) > 0.0 || std::abs(velocity) > 0.0;
  still_ = moved ? 0 : std::min(still_ + 1, length_);
  const Cycle newest{stretch.way, stretch.area / kMotionCycle, velocity};
  const Cycle oldest = cycles_[next_];
  cycles_[next_] = newest;
  ++next_;
  if (is_settled()) return settle();
  const auto count = static_cast<double>(length_);
  // The end moves away from all cycles by the way; the oldest one, which ended a whole window ago, is left out.
  sums_.behind += count * newest.way - newest.offset - (sums_.way - oldest.offset);
  sums_.way += newest.way - oldest.way;
  fresh_.behind += static_cast<double>(next_) * newest.way - newest.offset;
  fresh_.way += newest.way;
  if (next_ == length_) {
    next_ = 0;
    sums_ = std::exchange(fresh_, Sums{});
  }
  lag_ = sums_.behind / count;
  velocity_ = sums_.way / (count * kMotionCycle);
  acceleration_ = (newest.velocity - oldest.velocity) / (count * kMotionCycle);
}

/// The setpoint and its mean are at rest in one place; the ring holds nothing but rest.
void SlidingMean::settle() noexcept {
  next_ = 0;
  sums_ = fresh_ = {};
  lag_ = velocity_ = acceleration_ = 0.0;
}

}  // namespace drive
