#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "can/hub/trunk/trunk.hpp"
#include "os/descriptor.hpp"
#include "tests/can/hub/told.hpp"

namespace told {

/// A server that gives messages one order, at times that a test tells.
class Server {
 public:
  struct Kept {
    std::vector<std::byte> bytes;
    std::uint64_t sequence = 0;
    std::int64_t time_ns = 0;
  };
  /// A hub's connection to it.
  struct Line {
    std::deque<std::vector<std::byte>> asked;  ///< published, and not taken in yet
    std::deque<Kept> given;
    bool is_open = false;
    bool is_lost = false;
    bool is_held = false;  ///< nothing that is published reaches the server
    unsigned opened = 0;
  };

  canopen::TimePoint now = kStart;
  bool is_stopped = false;

  /// Takes in what @p line has published and gives it to all.
  void serve(Line& line) {
    if (is_stopped || line.is_held) return;
    for (; !line.asked.empty(); line.asked.pop_front()) put(line.asked.front());
  }
  void put(const std::vector<std::byte>& bytes) {
    ++sequence_;
    for (Line* const each : lines)
      if (each->is_open) each->given.push_back({bytes, sequence_, now.time_since_epoch().count()});
  }
  /// A message is lost for all.
  void skip() { ++sequence_; }

  std::vector<Line*> lines;

 private:
  std::uint64_t sequence_ = 0;
};

/// The stream of that server.
class Stream final : public hub::trunk::Stream {
 public:
  Stream(Server& server, Server::Line& line) : server_{server}, line_{line} { server.lines.push_back(&line); }

  [[nodiscard]] int descriptor() const noexcept override { return -1; }
  [[nodiscard]] State advance() noexcept override {
    if (line_.is_lost) return State::Lost;
    return line_.is_open ? State::Open : State::Opening;
  }
  [[nodiscard]] bool receive(Message& message) noexcept override {
    if (line_.given.empty()) return false;
    last_ = line_.given.front();
    line_.given.pop_front();
    message = {.bytes = last_.bytes, .sequence = last_.sequence, .time_ns = last_.time_ns};
    return true;
  }
  void publish(std::span<const std::byte> bytes) noexcept override {
    line_.asked.emplace_back(bytes.begin(), bytes.end());
  }
  void flush() noexcept override { server_.serve(line_); }
  void reopen() noexcept override {
    ++line_.opened;
    line_.is_open = false;
    line_.is_lost = false;
    line_.given.clear();  // what was published stays on its way
  }
  [[nodiscard]] std::string take_problem() override { return {}; }

 private:
  Server& server_;
  Server::Line& line_;
  Server::Kept last_;
};

/// A host: a medium with a listener, joined to the others by a server.
struct Host {
  explicit Host(Server& server, std::string name)
      : trunk{medium,
              std::make_unique<Stream>(server, line),
              {.url = "nats://told/bus", .name = std::move(name)},
              [this](bool up, canopen::TimePoint) {
                medium.set_up(up);
                links.push_back(up);
              },
              [this](std::string_view text) { notices.emplace_back(text); }},
        server_{server} {
    medium.attach(member);
  }
  ~Host() { medium.detach(member); }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// The connection is made.
  void open() {
    line.is_open = true;
    turn();
  }
  /// One turn of the hub's loop.
  void turn() {
    trunk.on_readable(server_.now);
    if (trunk.next_deadline() <= server_.now) trunk.on_time(server_.now);
    server_.serve(line);
  }
  void send(std::string_view text) { medium.send(passage(member, text), server_.now); }

  hub::Medium medium;
  Listener member;
  Server::Line line;
  std::vector<bool> links;
  std::vector<std::string> notices;
  hub::trunk::Trunk trunk;

 private:
  Server& server_;
};

}  // namespace told
