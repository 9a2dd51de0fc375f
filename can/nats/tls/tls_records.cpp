#include "can/nats/tls/tls_records.hpp"

#include <array>
#include <cerrno>

#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

namespace nats {

bool TlsRecords::is_whole(int socket, std::uint32_t events) noexcept {
  if ((events & (EPOLLRDHUP | EPOLLHUP | EPOLLERR)) != 0) return true;  // the end is behind what there is
  constexpr std::size_t kHeader = 5;                                    // type, version, length
  std::array<std::uint8_t, kHeader> header{};
  const ssize_t size = recv(socket, header.data(), header.size(), MSG_PEEK | MSG_DONTWAIT);
  if (size < 0) return errno != EAGAIN;
  int wanted = kHeader;
  constexpr int kHighByte = 256;
  if (size == kHeader) wanted += header[3] * kHighByte + header[4];
  int present = 0;
  const bool is_whole = size == 0 || ioctl(socket, FIONREAD, &present) != 0 || present >= wanted;
  poll_from(socket, is_whole ? 1 : wanted);
  return is_whole;
}

void TlsRecords::poll_from(int socket, int bytes) noexcept {
  if (bytes == polled_from_) return;
  setsockopt(socket, SOL_SOCKET, SO_RCVLOWAT, &bytes, sizeof bytes);
  polled_from_ = bytes;
}

}  // namespace nats
