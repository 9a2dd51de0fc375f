#include "tests/daemon/modbus/tcp_client.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

#include "tests/modbus/hexadecimal.hpp"

namespace axisd {
namespace {

/// For what should come at once: machines of others are slow.
constexpr std::chrono::seconds kPatience{20};

os::Descriptor connected(const std::string& place, int receive_buffer) {
  const std::size_t colon = place.rfind(':');
  const bool six = place.front() == '[';
  const std::string address = six ? place.substr(1, colon - 2) : place.substr(0, colon);
  const std::uint16_t port = htons(static_cast<std::uint16_t>(std::stoi(place.substr(colon + 1))));
  os::Descriptor socket{::socket(six ? AF_INET6 : AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  if (receive_buffer != 0)
    ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  sockaddr_in four{.sin_family = AF_INET, .sin_port = port, .sin_addr = {}, .sin_zero = {}};
  sockaddr_in6 with_six{};
  with_six.sin6_family = AF_INET6;
  with_six.sin6_port = port;
  ::inet_pton(AF_INET, address.c_str(), &four.sin_addr);
  ::inet_pton(AF_INET6, address.c_str(), &with_six.sin6_addr);
  const int done = six ? ::connect(socket.get(), reinterpret_cast<sockaddr*>(&with_six), sizeof with_six)
                       : ::connect(socket.get(), reinterpret_cast<sockaddr*>(&four), sizeof four);
  if (done != 0) throw std::runtime_error{"nobody listens at " + place};
  return socket;
}

}  // namespace

TcpClient::TcpClient(const std::string& place, std::function<void()> work, int receive_buffer)
    : socket_{connected(place, receive_buffer)}, work_{std::move(work)} {}

void TcpClient::send(std::string_view text) {
  const std::vector<std::uint8_t> bytes = modbus::bytes_of(text);
  static_cast<void>(::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

std::size_t TcpClient::send_some(const std::vector<std::uint8_t>& bytes) {
  const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  return sent < 0 ? 0 : static_cast<std::size_t>(sent);
}

std::string TcpClient::receive(std::size_t bytes) {
  std::vector<std::uint8_t> received(bytes);
  std::size_t count = 0;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (count < bytes && std::chrono::steady_clock::now() < end) {
    work_();
    pollfd readable{socket_.get(), POLLIN, 0};
    if (::poll(&readable, 1, 1) <= 0) continue;
    const ssize_t got = ::recv(socket_.get(), received.data() + count, bytes - count, 0);
    if (got <= 0) break;
    count += static_cast<std::size_t>(got);
  }
  return modbus::hexadecimal({received.data(), count});
}

std::string TcpClient::receive_some() {
  std::array<std::uint8_t, 4096> bytes{};
  const ssize_t got = ::recv(socket_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  return got <= 0 ? "" : modbus::hexadecimal({bytes.data(), static_cast<std::size_t>(got)});
}

void TcpClient::end() {
  ::shutdown(socket_.get(), SHUT_WR);
}

void TcpClient::reset() {
  const linger at_once{1, 0};
  ::setsockopt(socket_.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  socket_ = os::Descriptor{};
}

bool TcpClient::is_closed() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < end) {
    work_();
    std::uint8_t byte = 0;
    const ssize_t got = ::recv(socket_.get(), &byte, 1, MSG_DONTWAIT);
    if (got == 0 || (got < 0 && errno != EAGAIN)) return true;
  }
  return false;
}

}  // namespace axisd
