#pragma once

#include <cstdint>
#include <deque>
#include <list>
#include <optional>
#include <string>
#include <string_view>

#include "control/error.hpp"
#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace farm {

/// In which order a client gets its answers.
enum class Order : std::uint8_t {
  AsAsked,    ///< as a control socket gives them
  AsAnswered  ///< as they come: a unit that is slow keeps nobody waiting
};

/// The ends of streams at which clients speak the protocol of the control socket: lines come, each is answered
/// once, and lines that nobody has asked for go between the answers.
class Connections {
 public:
  /// A connection; no number comes twice.
  using Id = std::uint64_t;
  /// A line of a connection, until it is answered.
  struct Ticket {
    Id client = 0;
    std::uint64_t number = 0;
  };

  /// Most lines of one client that wait for an answer; it is read from again when there are fewer.
  static constexpr std::size_t kMostWaiting = 512;
  /// Most that a client may leave unread (bytes).
  static constexpr std::size_t kMostUnread = std::size_t{4} << 20U;

  /// Who answers.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// @p line has come, without its newline; answer() follows, in the call or later.
    virtual void on_line(const Ticket& ticket, std::string_view line) = 0;
    /// @p client is gone.
    virtual void on_gone(Id client) = 0;
  };

  /// @p events and @p listener outlive it.
  Connections(axisd::ServiceEvents& events, Listener& listener) noexcept : events_{events}, listener_{listener} {}
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;
  ~Connections() = default;

  /// Serves the client at the other end of @p socket, a stream. Throws std::system_error.
  void add(os::Descriptor socket, Order order);
  /// Answers the line of @p ticket by @p line, with its newline, if the client is still there.
  void answer(const Ticket& ticket, std::string line);
  /// Tells @p client @p line, with its newline. One that has left too much unread is cut off.
  void tell(Id client, std::string_view line);
  /// Tells @p client @p why and ends its connection.
  void end(Id client, const control::Error& why);

  [[nodiscard]] bool has(Id client) const noexcept;
  [[nodiscard]] std::size_t size() const noexcept { return all_.size(); }
  /// Connections that were cut off.
  [[nodiscard]] std::uint64_t cut_off() const noexcept { return cut_off_; }

 private:
  struct Connection {
    Connections* owner;
    Id id;
    os::Descriptor socket;
    Order order;
    axisd::EventSource source{};
    std::string input{};
    std::string output{};
    std::deque<std::optional<std::string>> answers{};  ///< of the lines from `first` on, as far as they are there
    std::uint64_t first = 0;
    std::uint64_t next = 0;  ///< number of the next line
    std::size_t waiting = 0;
    bool is_ending = false;  ///< nothing more is read, and it is closed when the output is out
  };

  static int on_ready(sd_event_source* source, int descriptor, std::uint32_t events, void* connection) noexcept;
  Connection* find(Id id) noexcept;
  bool serve(Connection& connection, std::uint32_t events);
  void take_lines(Connection& connection);
  static bool may_ask(const Connection& connection) noexcept;
  static bool read(Connection& connection);
  static bool flush(Connection& connection) noexcept;
  static void put(Connection& connection, std::uint64_t number, std::string line);
  static void listen_to(Connection& connection) noexcept;

  axisd::ServiceEvents& events_;
  Listener& listener_;
  std::list<Connection> all_;
  Id last_ = 0;
  std::uint64_t cut_off_ = 0;
};

}  // namespace farm
