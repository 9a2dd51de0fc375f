#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tools/canrec/frames/frame_source.hpp"

namespace canrec_test {

/// Frames of a list, and at the end a failure if there is one.
class ListSource final : public canrec::FrameSource {
 public:
  explicit ListSource(std::vector<canrec::TimedFrame> frames, std::optional<canrec::Failure> failure = {})
      : frames_{std::move(frames)}, failure_{std::move(failure)} {}

  canrec::Expected<std::optional<canrec::TimedFrame>> next() override {
    if (given_ < frames_.size()) return frames_[given_++];
    if (failure_) return tl::unexpected{*failure_};
    return std::nullopt;
  }

 private:
  std::vector<canrec::TimedFrame> frames_;
  std::optional<canrec::Failure> failure_;
  std::size_t given_ = 0;
};

/// A frame of identifier @p id at @p at.
inline canrec::TimedFrame frame(std::chrono::nanoseconds at, canid_t id) {
  canrec::TimedFrame made{.at = at};
  made.frame.can_id = id;
  return made;
}

}  // namespace canrec_test
