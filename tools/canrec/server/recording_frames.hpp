#pragma once

#include <memory>
#include <vector>

#include "tools/canrec/frames/frame_source.hpp"
#include "tools/canrec/frames/transcript.hpp"
#include "tools/canrec/server/messages.hpp"

namespace canrec {

/// The frames of a recording that have passed on its bus.
class RecordingFrames final : public FrameSource {
 public:
  explicit RecordingFrames(Messages messages)
      : messages_{std::move(messages)}, transcript_{std::make_unique<Transcript>()} {}

  [[nodiscard]] Expected<std::optional<TimedFrame>> next() override;
  /// What was found so far.
  [[nodiscard]] const Transcript& transcript() const noexcept { return *transcript_; }

 private:
  Messages messages_;
  std::unique_ptr<Transcript> transcript_;
  std::vector<TimedFrame> frames_;  ///< of the last message
  std::size_t given_ = 0;           ///< of these
};

}  // namespace canrec
