#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include "os/descriptor.hpp"

namespace fakes {

/// The server's end of one connection. Nothing here waits longer than ten seconds; then it throws.
class SocketcandPeer {
 public:
  explicit SocketcandPeer(os::Descriptor socket) : socket_{std::move(socket)} {}

  void say(std::string_view text) const {
    if (::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(text.size()))
      throw std::runtime_error{"the client has gone"};
  }
  /// The next message of the client; empty if it has closed the connection.
  std::string hear() {
    std::string text;
    for (char letter = 0; letter != '>'; text += letter)
      if (!readable() || ::recv(socket_.get(), &letter, 1, 0) != 1) return "";
    return text;
  }
  void expect(std::string_view message) {
    if (const std::string heard = hear(); heard != message) throw std::runtime_error{"unexpected: " + heard};
  }
  /// Greets, opens the bus vcan0 and goes to raw mode.
  void shake_hands() {
    say("< hi >");
    expect("< open vcan0 >");
    say("< ok >");
    expect("< rawmode >");
    say("< ok >");
  }

 private:
  bool readable() const {
    constexpr int kPatience = 10'000;  // ms
    pollfd wanted{socket_.get(), POLLIN, 0};
    return ::poll(&wanted, 1, kPatience) == 1;
  }

  os::Descriptor socket_;
};

/// A TCP socket that is bound to a free port of the loopback interface, which @p port becomes, and does not
/// listen.
inline os::Descriptor bind_to_loopback(std::uint16_t& port) {
  os::Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof address;
  auto* const common = reinterpret_cast<sockaddr*>(&address);
  if (::bind(socket.get(), common, length) != 0 || ::getsockname(socket.get(), common, &length) != 0)
    throw std::runtime_error{"cannot bind to the loopback interface"};
  port = ntohs(address.sin_port);
  return socket;
}

/// A server on the loopback interface that does what a test tells it to: one script a connection.
class SocketcandServer {
 public:
  using Script = std::function<void(SocketcandPeer&)>;

  explicit SocketcandServer(std::vector<Script> scripts) : listener_{listen()} {
    thread_ = std::thread{[this, todo = std::move(scripts)] { serve(todo); }};
  }
  SocketcandServer(const SocketcandServer&) = delete;
  SocketcandServer& operator=(const SocketcandServer&) = delete;
  ~SocketcandServer() { join(); }

  /// Waits until all scripts are done.
  void join() {
    if (thread_.joinable()) thread_.join();
  }
  std::uint16_t port() const { return port_; }
  /// What went wrong in a script, empty if nothing; to be asked after join().
  const std::string& problem() const { return problem_; }

 private:
  os::Descriptor listen() {
    os::Descriptor socket = bind_to_loopback(port_);
    if (::listen(socket.get(), 1) != 0) throw std::runtime_error{"cannot listen"};
    return socket;
  }
  void serve(const std::vector<Script>& scripts) {
    try {
      for (const Script& script : scripts) {
        SocketcandPeer peer{os::Descriptor{::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC)}};
        script(peer);
      }
    } catch (const std::exception& error) {
      problem_ = error.what();
    }
  }

  std::uint16_t port_ = 0;
  os::Descriptor listener_;
  std::string problem_;
  std::thread thread_;
};

}  // namespace fakes
