#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace injection {

/// Frames that are to be sent later. Those of one identifier stay in their order.
class DelayedFrames {
 public:
  /// More wait for nothing: a frame that finds no room is sent at once.
  static constexpr std::size_t kMost = 1024;

  DelayedFrames() { frames_.reserve(kMost); }

  /// Keeps @p frame until @p due, or until those of its identifier that wait have gone; false if it is to be sent
  /// now.
  bool keep(const canopen::Frame& frame, canopen::TimePoint due, canopen::TimePoint now) noexcept {
    for (const Waiting& waiting : frames_)
      if (waiting.frame.id == frame.id && waiting.frame.extended == frame.extended)
        due = std::max(due, waiting.due);
    if (due <= now || frames_.size() == kMost) return false;
    const auto behind = std::ranges::upper_bound(frames_, due, {}, &Waiting::due);
    frames_.insert(behind, {due, frame});
    return true;
  }
  /// Hands those that are due at @p now to @p sink.
  void send_due(canopen::TimePoint now, canopen::FrameSink& sink) noexcept {
    const auto end = std::ranges::upper_bound(frames_, now, {}, &Waiting::due);
    for (auto waiting = frames_.begin(); waiting != end; ++waiting)
      sink.send(waiting->frame, canopen::Delivery::Ordered);
    frames_.erase(frames_.begin(), end);
  }
  void clear() noexcept { frames_.clear(); }
  canopen::TimePoint deadline() const noexcept { return frames_.empty() ? canopen::kNever : frames_.front().due; }

 private:
  struct Waiting {
    canopen::TimePoint due;
    canopen::Frame frame;
  };
  std::vector<Waiting> frames_;
};

}  // namespace injection
