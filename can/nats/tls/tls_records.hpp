#pragma once

#include <cstddef>
#include <cstdint>

namespace nats {

/// What has come in on a socket with TLS. The library can only read whole records and waits for the rest of one,
/// for ever if the wire is cut in the middle: so it is not let read before a record has come in whole.
class TlsRecords {
 public:
  /// Whether reading from @p socket, for which epoll has told @p events, ends without waiting. If it would not,
  /// the socket polls readable from now on when it does.
  [[nodiscard]] bool is_whole(int socket, std::uint32_t events) noexcept;

 private:
  void poll_from(int socket, int bytes) noexcept;

  int polled_from_ = 1;  ///< bytes that have to be there for the socket to poll readable
};

}  // namespace nats
