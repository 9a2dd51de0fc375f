#pragma once

#include <optional>
#include <string>

#include "can/userbus/join.hpp"
#include "os/descriptor.hpp"

namespace bus {

/// The program canhub while it begins to serve a path. Nobody waits for it: it is a child whose end is seen.
class HubStart {
 public:
  /// Starts @p hub for @p path, with the bit rate of $CAN_BITRATE and the time of $CAN_TIME. JoinError::None if it
  /// runs now.
  [[nodiscard]] userbus::JoinError begin(const std::string& hub, const userbus::Path& path) noexcept;
  /// True from begin() until finish() has told.
  [[nodiscard]] bool is_running() const noexcept { return static_cast<bool>(process_); }
  /// Polls readable when finish() has something to say.
  [[nodiscard]] int descriptor() const noexcept { return process_.get(); }
  /// What has come of it; nothing while it runs.
  [[nodiscard]] std::optional<userbus::JoinError> finish() noexcept;

 private:
  os::Descriptor process_;
};

}  // namespace bus
