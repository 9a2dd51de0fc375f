#pragma once

#include <memory>

#include "daemon/watch/streams/frame_buffer.hpp"

namespace axisd {

/// Puts the frames of a unit into a buffer from which another thread takes them, while somebody wants that.
class FrameStream final : private FrameListener {
 public:
  /// @p tap outlives this; @p started is zero of the times.
  FrameStream(FrameTap& tap, canopen::TimePoint started) noexcept : tap_{tap}, started_{started} {}
  ~FrameStream() override = default;
  FrameStream(const FrameStream&) = delete;
  FrameStream& operator=(const FrameStream&) = delete;

  /// Frames go to @p buffer from now on. False if too many listen to them.
  [[nodiscard]] bool begin(std::shared_ptr<FrameBuffer> buffer) noexcept;
  void end() noexcept;

 private:
  void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept override {
    buffer_->add({time - started_, direction, frame});
  }

  FrameTap& tap_;
  canopen::TimePoint started_;
  std::shared_ptr<FrameBuffer> buffer_;
};

}  // namespace axisd
