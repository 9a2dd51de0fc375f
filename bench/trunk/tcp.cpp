#include "bench/trunk/tcp.hpp"

#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "bench/number.hpp"
#include "bench/trunk/sequencer_messages.hpp"

namespace bench {

namespace {

sockaddr_in address_of(std::string_view place) {
  const std::size_t colon = place.find(':');
  const std::string host{place.substr(0, colon)};
  constexpr std::uint16_t kHighestPort = 65535;
  std::uint16_t port = 0;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  if (colon == std::string_view::npos || ::inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1 ||
      !parse<std::uint16_t>(place.substr(colon + 1), 1, kHighestPort, port))
    throw std::runtime_error{"expected ADDRESS:PORT, got " + std::string{place}};
  address.sin_port = htons(port);
  return address;
}

void require(bool holds, std::string_view what) {
  if (!holds) throw std::system_error{errno, std::generic_category(), std::string{what}};
}

void do_not_block(const os::Descriptor& socket) {
  require(::fcntl(socket.get(), F_SETFL, O_NONBLOCK) == 0, "O_NONBLOCK");
}

}  // namespace

os::Descriptor listen_at(std::string_view place) {
  const sockaddr_in address = address_of(place);
  os::Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  const int on = 1;
  ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  require(::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, place);
  require(::listen(socket.get(), SOMAXCONN) == 0, place);
  do_not_block(socket);
  return socket;
}

os::Descriptor connect_to(std::string_view place) {
  const sockaddr_in address = address_of(place);
  os::Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  constexpr int kRoom = 1 << 22;  // for all that may be under way, each frame in a message of its own
  if (::setsockopt(socket.get(), SOL_SOCKET, SO_SNDBUFFORCE, &kRoom, sizeof kRoom) != 0)
    ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDBUF, &kRoom, sizeof kRoom);
  require(::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0, place);
  send_at_once(socket);
  do_not_block(socket);
  return socket;
}

void send_at_once(const os::Descriptor& socket) {
  const int on = 1;
  require(::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on) == 0, "TCP_NODELAY");
}

Transfer read_some(const os::Descriptor& socket, ByteQueue& queue) {
  const std::span<std::byte> room = queue.room(kReadAtOnce);
  const ssize_t size = ::recv(socket.get(), room.data(), room.size(), MSG_DONTWAIT);
  if (size > 0) queue.fill(static_cast<std::size_t>(size));
  if (size > 0) return Transfer::Done;
  return size < 0 && (errno == EAGAIN || errno == EINTR) ? Transfer::Waiting : Transfer::Failed;
}

Transfer write_all(const os::Descriptor& socket, ByteQueue& queue) {
  const std::span<const std::byte> waiting = queue.waiting();
  if (waiting.empty()) return Transfer::Done;
  const ssize_t size = ::send(socket.get(), waiting.data(), waiting.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (size < 0) return errno == EAGAIN || errno == EINTR ? Transfer::Waiting : Transfer::Failed;
  queue.take(static_cast<std::size_t>(size));
  return queue.waiting().empty() ? Transfer::Done : Transfer::Waiting;
}

}  // namespace bench
