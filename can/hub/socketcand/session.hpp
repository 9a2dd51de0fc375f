#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "can/hub/medium/interfaces.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/socketcand/text_queue.hpp"
#include "can/port/socketcand/socketcand_text.hpp"
#include "os/descriptor.hpp"

namespace hub::socketcand {

/// What a session, or all of a server, has done so far.
struct Counters {
  std::uint64_t sent = 0;      ///< frames of clients
  std::uint64_t received = 0;  ///< frames told to clients
  std::uint64_t dropped = 0;   ///< frames that a client did not read in time
  std::uint64_t untold = 0;    ///< remote and error frames, for which raw mode has no form

  Counters& operator+=(const Counters& more) noexcept;
};

/// One client: its handshake, its frames, and its end.
class Session final : public Participant {
 public:
  /// Time after the change to raw mode in which no frame is told, unless the client says something before: a
  /// client that takes all that has come for the answer "< ok >" would fail if a frame stood behind it.
  static constexpr canopen::Duration kSilence = std::chrono::milliseconds{100};

  /// Greets the client at @p socket, a TCP connection that does not block, and has the epoll @p poll watch it,
  /// with this session as data. What the client calls its bus becomes a name in @p interfaces.
  Session(Medium& medium, Interfaces& interfaces, os::Descriptor socket, int poll);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session() override;

  /// The client's socket polls @p events, as epoll(7) has them.
  void on_events(std::uint32_t events, canopen::TimePoint now) noexcept;
  /// When on_time() is wanted.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept { return silent_until_; }
  void on_time(canopen::TimePoint now) noexcept;
  /// True if the connection has ended: the session has no use any more. Its socket then polls a hang-up.
  [[nodiscard]] bool is_over() const noexcept { return over_; }
  [[nodiscard]] const Counters& counters() const noexcept { return counters_; }

  void receive(const Passage& passage) noexcept override;
  void on_room() noexcept override;
  [[nodiscard]] Identity identity() const noexcept override {
    return {.name = {"socketcand"}, .process = 0, .interface_index = interface_index_};
  }

 private:
  struct Handler;

  void read(canopen::TimePoint now) noexcept;
  void handle_messages(canopen::TimePoint now) noexcept;
  void handle(std::string_view text, canopen::TimePoint now) noexcept;
  void send(const canopen::Frame& frame, canopen::TimePoint now) noexcept;
  void answer(const bus::socketcand::Message& message) noexcept;
  void refuse(std::string_view reason, std::string_view what = {}) noexcept;
  void end_silence() noexcept;
  void flush() noexcept;
  void end() noexcept;
  void update_watch() noexcept;

  Medium& medium_;
  Interfaces& interfaces_;
  os::Descriptor socket_;
  int poll_;
  std::uint32_t watched_ = 0;  ///< events; 0 = the socket is not watched
  bus::socketcand::MessageReader reader_;
  TextQueue output_;
  int interface_index_ = 0;  ///< 0 = no bus is open
  bool raw_ = false;
  bool over_ = false;
  canopen::TimePoint silent_until_ = canopen::kNever;
  std::optional<Passage> refused_;  ///< waits for room on the medium; meanwhile the client is not read
  Counters counters_;
};

}  // namespace hub::socketcand
