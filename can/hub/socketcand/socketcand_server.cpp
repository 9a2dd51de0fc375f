#include "can/hub/socketcand/socketcand_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>

namespace hub {

namespace {

/// Without descriptors or memory for another client: when to try again.
constexpr canopen::Duration kPause = std::chrono::milliseconds{100};
/// Clients and events of one turn.
constexpr int kBatch = 16;
constexpr int kOn = 1;
/// Text of a client that the kernel keeps, beside that of the session (bytes).
constexpr int kSendBuffer = 128 * 1024;

struct HostAndPort {
  std::string host;
  std::string port;
};

/// Splits "HOST:PORT" or "[ADDRESS]:PORT".
HostAndPort split(std::string_view address) {
  const std::size_t colon = address.rfind(':');
  std::string_view host = address.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  const bool ambiguous = host.find(':') != std::string_view::npos && host.size() == colon;
  if (colon == std::string_view::npos || host.empty() || colon + 1 == address.size() || ambiguous)
    throw SocketcandServer::ListenError{
        fmt::format("{}: expected HOST:PORT, or [ADDRESS]:PORT for IPv6", address)};
  return {std::string{host}, std::string{address.substr(colon + 1)}};
}

using AddressList = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

AddressList resolve(std::string_view address) {
  const HostAndPort wanted = split(address);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(wanted.host.c_str(), wanted.port.c_str(), &hints, &found);
  if (error != 0) throw SocketcandServer::ListenError{fmt::format("{}: {}", address, gai_strerror(error))};
  return {found, freeaddrinfo};
}

os::Descriptor listen_at(std::string_view address) {
  const AddressList found = resolve(address);
  os::Descriptor socket{::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &kOn, sizeof kOn);
  if (!socket || ::bind(socket.get(), found->ai_addr, found->ai_addrlen) != 0 ||
      ::listen(socket.get(), SOMAXCONN) != 0)
    throw SocketcandServer::ListenError{fmt::format("{}: {}", address, std::generic_category().message(errno))};
  return socket;
}

}  // namespace

SocketcandServer::SocketcandServer(Medium& medium, Interfaces& interfaces, std::string_view address)
    : medium_{medium},
      interfaces_{interfaces},
      name_{fmt::format("socketcand {}", address)},
      listener_{listen_at(address)},
      poll_{::epoll_create1(EPOLL_CLOEXEC)} {
  epoll_event wanted{};
  wanted.events = EPOLLIN;
  if (!poll_ || ::epoll_ctl(poll_.get(), EPOLL_CTL_ADD, listener_.get(), &wanted) != 0)
    throw std::system_error{errno, std::generic_category(), "cannot watch the socketcand server"};
}

SocketcandServer::~SocketcandServer() = default;

std::uint16_t SocketcandServer::port() const noexcept {
  sockaddr_storage address{};
  socklen_t length = sizeof address;
  ::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &length);
  static_assert(offsetof(sockaddr_in, sin_port) == offsetof(sockaddr_in6, sin6_port));
  return ntohs(reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

void SocketcandServer::on_readable(canopen::TimePoint now) noexcept {
  std::array<epoll_event, kBatch> events{};
  const int count = ::epoll_wait(poll_.get(), events.data(), kBatch, 0);
  for (int i = 0; i < count; ++i) {
    const epoll_event& event = events[static_cast<std::size_t>(i)];
    if (event.data.ptr == nullptr)
      accept_clients(now);
    else
      static_cast<socketcand::Session*>(event.data.ptr)->on_events(event.events, now);
  }
  let_go_of_those_who_left();
}

void SocketcandServer::accept_clients(canopen::TimePoint now) noexcept {
  for (int i = 0; i < kBatch; ++i) {
    os::Descriptor socket{::accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (socket) {
      admit(std::move(socket));
      continue;
    }
    if (errno == ECONNABORTED || errno == EINTR) continue;
    if (errno == EAGAIN) return;
    // a listener that polls readable and cannot be accepted from would keep the loop busy
    watch_listener(0);
    listen_again_ = now + kPause;
    return;
  }
}

void SocketcandServer::admit(os::Descriptor socket) noexcept {
  constexpr std::string_view kTooMany = "< error too many clients >";
  ::setsockopt(socket.get(), IPPROTO_TCP, TCP_NODELAY, &kOn, sizeof kOn);
  ::setsockopt(socket.get(), SOL_SOCKET, SO_KEEPALIVE, &kOn, sizeof kOn);
  ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
  if (clients_.size() >= kMostClients) {
    ::send(socket.get(), kTooMany.data(), kTooMany.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    return;
  }
  try {
    clients_.reserve(clients_.size() + 1);
    clients_.push_back(
        std::make_unique<socketcand::Session>(medium_, interfaces_, std::move(socket), poll_.get()));
  } catch (const std::exception&) {  // no memory: the client is told by the end of its connection
  }
}

void SocketcandServer::watch_listener(std::uint32_t events) noexcept {
  epoll_event wanted{};
  wanted.events = events;
  ::epoll_ctl(poll_.get(), EPOLL_CTL_MOD, listener_.get(), &wanted);
}

void SocketcandServer::let_go_of_those_who_left() noexcept {
  std::erase_if(clients_, [this](const auto& client) {
    if (!client->is_over()) return false;
    of_those_who_left_ += client->counters();
    return true;
  });
}

canopen::TimePoint SocketcandServer::next_deadline() const noexcept {
  canopen::TimePoint due = listen_again_;
  for (const auto& client : clients_) due = std::min(due, client->next_deadline());
  return due;
}

void SocketcandServer::on_time(canopen::TimePoint now) noexcept {
  for (const auto& client : clients_) client->on_time(now);
  if (now < listen_again_) return;
  listen_again_ = canopen::kNever;
  watch_listener(EPOLLIN);
}

bool SocketcandServer::statistics(userbus::MemberStatistics& row) const noexcept {
  socketcand::Counters all = of_those_who_left_;
  for (const auto& client : clients_) all += client->counters();
  row = {};
  name_.copy(row.name, sizeof row.name - 1);
  row.sent = all.sent;
  row.received = all.received;
  row.dropped = all.dropped + all.untold;
  return true;
}

}  // namespace hub
