#include "daemon/watch/streams/frame_stream.hpp"

#include <utility>

namespace axisd {

bool FrameStream::begin(std::shared_ptr<FrameBuffer> buffer) noexcept {
  if (!tap_.add(*this)) return false;
  buffer_ = std::move(buffer);
  return true;
}

void FrameStream::end() noexcept {
  tap_.remove(*this);
  buffer_.reset();
}

}  // namespace axisd
