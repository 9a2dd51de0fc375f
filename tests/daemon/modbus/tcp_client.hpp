#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "os/descriptor.hpp"

namespace axisd {

/// A client of Modbus TCP on the thread of the test. While it waits it lets the other side work.
class TcpClient {
 public:
  /// Connects to @p place, "ADDRESS:PORT" or "[ADDRESS]:PORT"; @p work is what the other side does. The kernel
  /// keeps
  /// @p receive_buffer bytes for it, about; 0: as many as it likes.
  TcpClient(const std::string& place, std::function<void()> work, int receive_buffer = 0);

  /// Sends what hexadecimal @p text says; nothing is waited for.
  void send(std::string_view text);
  /// Sends as much of @p bytes as the kernel takes; how much that was.
  std::size_t send_some(const std::vector<std::uint8_t>& bytes);
  /// The next @p bytes that come, hexadecimal; fewer where the connection ends before.
  std::string receive(std::size_t bytes);
  /// What is there now, without waiting.
  std::string receive_some();
  /// The same of an answer to what @p text says.
  std::string ask(std::string_view text, std::size_t bytes) {
    send(text);
    return receive(bytes);
  }
  /// It will send no more.
  void end();
  /// It goes away with a reset, as when its program is killed in the midst of something.
  void reset();
  /// Waits until the other side has closed the connection; false if it has not.
  bool is_closed();

 private:
  os::Descriptor socket_;
  std::function<void()> work_;
};

}  // namespace axisd
