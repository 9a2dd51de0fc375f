#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "can/port/address.hpp"
#include "can/port/filter_list.hpp"
#include "can/port/link.hpp"
#include "can/port/port.hpp"
#include "can/port/retry_timer.hpp"
#include "can/port/socketcand/socketcand_client.hpp"
#include "os/pollable.hpp"

namespace bus {

/// A client of a socketcand server in raw mode, which has data frames only: no remote frames, no error states.
class SocketcandPort final : public Port {
 public:
  /// Connects and opens the bus of @p place; throws OpenError if that fails or takes more than five seconds.
  explicit SocketcandPort(SocketcandServer place);

  [[nodiscard]] SendStatus send(const canopen::Frame& frame) noexcept override;
  [[nodiscard]] Received receive(canopen::Frame& frame) noexcept override;
  [[nodiscard]] ErrorState error_state() const noexcept override { return ErrorState::Active; }
  /// Messages of the server that were none.
  [[nodiscard]] std::uint64_t dropped() const noexcept override { return rejected_; }
  [[nodiscard]] int descriptor() const noexcept override { return pollable_.descriptor(); }
  void accept_only(std::span<const Filter> filters) noexcept override { filters_.assign(filters); }
  [[nodiscard]] bool reopen() noexcept override;
  [[nodiscard]] bool carries_remote_frames() const noexcept override { return false; }

  /// True until the server is found to be gone.
  [[nodiscard]] bool is_open() const noexcept { return client_.stage() == socketcand::Client::Stage::Raw; }
  /// Polls readable when advance() has something to do.
  [[nodiscard]] int attempt_descriptor() const noexcept { return attempt_.descriptor(); }
  /// Begins, goes on with or gives up an attempt to connect, as its time has come. True if it is open now.
  [[nodiscard]] bool advance();

 private:
  void resolve();
  void begin();
  void go_on();
  void give_up();
  void watch_attempt() noexcept;
  Received server_lost() noexcept;

  SocketcandServer place_;
  std::vector<SocketAddress> addresses_;  ///< of the host, tried in turn
  std::size_t attempts_ = 0;
  socketcand::Client client_;
  os::Pollable pollable_;  ///< stands for the socket in raw mode
  os::Pollable attempt_;   ///< stands for the timer, and for the socket until raw mode
  RetryTimer timer_;
  FilterList filters_;
  std::uint64_t rejected_ = 0;
};

/// Up while the port is connected; after the server has gone it makes the port try again until it is.
class SocketcandLink final : public Link {
 public:
  /// @p port outlives it.
  explicit SocketcandLink(SocketcandPort& port) : port_{port} {}

  [[nodiscard]] int descriptor() const noexcept override { return port_.attempt_descriptor(); }
  [[nodiscard]] std::optional<LinkState> read() noexcept override;
  [[nodiscard]] LinkState state() const noexcept override {
    return port_.is_open() ? LinkState::Up : LinkState::Down;
  }

 private:
  SocketcandPort& port_;
};

}  // namespace bus
