#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "can/userbus/protocol.hpp"
#include "os/descriptor.hpp"

namespace bus {

/// Whether errno @p error of a member's socket says that the hub has closed it.
[[nodiscard]] bool means_no_hub(int error) noexcept;

/// What has come from a hub to one of its members, a frame at a time, also where a message has several.
class FrameInbox {
 public:
  /// What next() has found; Gone: the hub.
  enum class Outcome : std::uint8_t { Frame, Nothing, Gone };

  /// std::system_error if the kernel gives no descriptor.
  FrameInbox();

  /// Polls readable while frames wait here that have left the socket.
  [[nodiscard]] int descriptor() const noexcept { return waits_.get(); }
  /// True while they do.
  [[nodiscard]] bool has_frames() const noexcept { return next_ < count_; }
  /// Takes the next frame of the member @p socket into @p message, which is touched only when there is one.
  [[nodiscard]] Outcome next(int socket, userbus::FrameMessage& message) noexcept;
  /// Forgets what waits here.
  void clear() noexcept;

 private:
  [[nodiscard]] Outcome read(int socket) noexcept;

  os::Descriptor waits_;
  std::array<userbus::FrameMessage, userbus::kMostFrames> frames_{};  ///< of the last message
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace bus
