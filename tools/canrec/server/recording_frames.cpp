#include "tools/canrec/server/recording_frames.hpp"

namespace canrec {

Expected<std::optional<TimedFrame>> RecordingFrames::next() {
  while (given_ == frames_.size()) {
    const auto message = messages_.next();
    if (!message) return tl::unexpected{message.error()};
    if (!*message) return std::nullopt;
    frames_.clear();
    given_ = 0;
    transcript_->take(**message, frames_);
  }
  return frames_[given_++];
}

}  // namespace canrec
