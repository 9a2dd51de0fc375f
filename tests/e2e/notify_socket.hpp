#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "os/descriptor.hpp"

namespace e2e {

/// The service manager's end of sd_notify.
class NotifySocket {
 public:
  /// Binds a datagram socket at @p path; throws std::system_error.
  explicit NotifySocket(std::string path);

  /// What the environment of the service must contain.
  std::string environment() const { return "NOTIFY_SOCKET=" + path_; }
  /// Waits for a message with the line @p line; false if none comes. Messages before it are passed over.
  bool wait_for(std::string_view line);
  /// Messages received so far, in order.
  const std::vector<std::string>& messages() const noexcept { return messages_; }

 private:
  std::string path_;
  os::Descriptor socket_;
  std::vector<std::string> messages_;
};

}  // namespace e2e
