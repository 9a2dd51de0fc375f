#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace hub::socketcand {

/// Text on its way into a TCP connection: what the socket has no room for waits here, within bounds.
class TextQueue {
 public:
  /// Characters that may wait: about a thousand frames.
  static constexpr std::size_t kRoom = 65536;

  /// Takes all of @p text, or nothing if it has no room.
  [[nodiscard]] bool push(std::string_view text) noexcept;
  /// Gives to @p socket what it takes; false if the connection is broken.
  [[nodiscard]] bool flush(int socket) noexcept;
  [[nodiscard]] bool empty() const noexcept { return begin_ == end_; }

 private:
  std::array<char, kRoom> text_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace hub::socketcand
