#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "can/hub/medium/interfaces.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/medium/source.hpp"
#include "can/hub/socketcand/session.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// Serves clients of the socketcand protocol over TCP: raw mode, with the commands open, rawmode, send and echo.
/// Everything else is refused with a line that says so. Remote frames, for which raw mode has no form, do not
/// reach the clients.
class SocketcandServer final : public Source {
 public:
  /// It cannot listen; what() says where and why, in one line.
  struct ListenError : std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  /// Clients at a time; one more is refused.
  static constexpr std::size_t kMostClients = 64;

  /// Listens at @p address, "HOST:PORT", an IPv6 address in brackets; port 0 stands for any that is free.
  /// ListenError, or std::system_error if the kernel gives no descriptor.
  SocketcandServer(Medium& medium, Interfaces& interfaces, std::string_view address);
  SocketcandServer(const SocketcandServer&) = delete;
  SocketcandServer& operator=(const SocketcandServer&) = delete;
  ~SocketcandServer() override;

  /// The port it listens at.
  [[nodiscard]] std::uint16_t port() const noexcept;
  [[nodiscard]] std::size_t clients() const noexcept { return clients_.size(); }

  [[nodiscard]] int descriptor() const noexcept override { return poll_.get(); }
  void on_readable(canopen::TimePoint now) noexcept override;
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept override;
  void on_time(canopen::TimePoint now) noexcept override;
  [[nodiscard]] bool statistics(userbus::MemberStatistics& row) const noexcept override;

 private:
  void accept_clients(canopen::TimePoint now) noexcept;
  void admit(os::Descriptor socket) noexcept;
  void watch_listener(std::uint32_t events) noexcept;
  void let_go_of_those_who_left() noexcept;

  Medium& medium_;
  Interfaces& interfaces_;
  std::string name_;
  os::Descriptor listener_;
  os::Descriptor poll_;  ///< an epoll of the listener and all clients
  std::vector<std::unique_ptr<socketcand::Session>> clients_;
  canopen::TimePoint listen_again_ = canopen::kNever;
  socketcand::Counters of_those_who_left_;
};

}  // namespace hub
