#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
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
    std::deque<std::vector<std::byte>> requested;  ///< likewise, beside the stream
    std::deque<std::vector<std::byte>> requests;   ///< of all, while it listens
    bool listens = false;
    bool is_open = false;
    bool is_lost = false;
    bool is_held = false;  ///< nothing that is published reaches the server
    unsigned opened = 0;
  };

  canopen::TimePoint now = kStart;
  bool is_stopped = false;
  hub::trunk::Lease::Entry lease;

  /// Takes in what @p line has published and gives it to all.
  void serve(Line& line) {
    if (is_stopped || line.is_held) return;
    for (; !line.requested.empty(); line.requested.pop_front()) request(line.requested.front());
    for (; !line.asked.empty(); line.asked.pop_front()) put(line.asked.front());
  }
  void request(const std::vector<std::byte>& bytes) {
    for (Line* const each : lines)
      if (each->is_open && each->listens) each->requests.push_back(bytes);
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
    line_.listens = false;
    line_.given.clear();  // what was published stays on its way
    line_.requests.clear();
  }
  [[nodiscard]] std::string take_problem() override { return {}; }
  void ask(std::span<const std::byte> bytes) noexcept override {
    line_.requested.emplace_back(bytes.begin(), bytes.end());
  }
  void listen(bool on) noexcept override { line_.listens = on; }
  [[nodiscard]] bool receive_request(Message& message) noexcept override {
    if (line_.requests.empty()) return false;
    last_request_ = line_.requests.front();
    line_.requests.pop_front();
    message = {.bytes = last_request_};
    return true;
  }

 private:
  Server& server_;
  Server::Line& line_;
  Server::Kept last_;
  std::vector<std::byte> last_request_;
};

/// The lease that the server keeps, as hub @p hub sees it.
class Lease final : public hub::trunk::Lease {
 public:
  Lease(Server& server, std::uint32_t hub) : server_{server}, hub_{hub} {}

  void look() noexcept override { is_asked_ = true; }
  void take(std::uint64_t revision, std::uint32_t term) noexcept override {
    is_asked_ = true;
    if (server_.lease.revision == revision) server_.lease = {.revision = revision + 1, .term = term, .hub = hub_};
  }
  [[nodiscard]] std::optional<Entry> take_answer() noexcept override {
    if (server_.is_stopped || !std::exchange(is_asked_, false)) return std::nullopt;
    return server_.lease;
  }
  [[nodiscard]] std::string take_problem() override { return {}; }

 private:
  Server& server_;
  std::uint32_t hub_;
  bool is_asked_ = false;
};

/// A host: a medium with a listener, joined to the others by a server.
struct Host {
  Host(Server& server, std::string name, std::uint32_t bit_rate = 0)
      : medium{bit_rate},
        trunk{medium,
              std::make_unique<Stream>(server, line),
              {.url = "nats://told/bus", .name = std::move(name), .bit_rate = bit_rate},
              [this](bool up, canopen::TimePoint) {
                medium.set_up(up);
                links.push_back(up);
              },
              [this](std::string_view text) { notices.emplace_back(text); },
              std::make_unique<Lease>(server, medium.number_of_hub())},
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
  void send(std::string_view text) { send(member, text); }
  void send(Listener& sender, std::string_view text) { medium.send(passage(sender, text), server_.now); }
  [[nodiscard]] bool is_arbiter() const { return trunk.arbitration()->is_arbiter(); }

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
