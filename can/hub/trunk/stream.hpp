#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace hub::trunk {

/// A connection to what gives the messages of all hubs of a bus one order. Nothing here waits for anybody.
class Stream {
 public:
  Stream() = default;
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  virtual ~Stream() = default;

  /// A message of the stream, the hub's own ones included.
  struct Message {
    std::span<const std::byte> bytes;  ///< until the next call
    std::uint64_t sequence = 0;        ///< of all messages of the stream, without gaps
    std::int64_t time_ns = 0;          ///< when the stream took it in, since the epoch of the stream's own clock
  };
  /// Whether messages come and go.
  enum class State : std::uint8_t {
    Opening,  ///< not yet; it is tried again and again
    Open,     ///< every message that is taken in from now on comes here
    Lost,     ///< not any more: reopen() makes a new connection
  };

  /// File descriptor that polls readable when advance() or receive() has something to do; it stays the same.
  [[nodiscard]] virtual int descriptor() const noexcept = 0;
  /// Does what can be done; the state that it comes to.
  [[nodiscard]] virtual State advance() noexcept = 0;
  /// Takes the next message that has come in; false if there is none. Only while Open.
  [[nodiscard]] virtual bool receive(Message& message) noexcept = 0;
  /// Takes @p bytes for the stream, which go with flush() at the latest; what becomes of them shows when they come
  /// back. Only while Open.
  virtual void publish(std::span<const std::byte> bytes) noexcept = 0;
  /// Sends what publish() has taken.
  virtual void flush() noexcept = 0;
  /// Gives up the connection with all that is under way in both directions, and makes a new one.
  virtual void reopen() noexcept = 0;
  /// One line that says why it is not open, as far as that is known; empty if there is nothing new to say.
  [[nodiscard]] virtual std::string take_problem() = 0;

  // What hubs of a bus with a bit rate ask of its arbiter goes beside the stream, of each hub in its order.

  /// Takes @p bytes, a request, for who listens, which go with flush() at the latest. Only while Open.
  virtual void ask([[maybe_unused]] std::span<const std::byte> bytes) noexcept {}
  /// Requests of all hubs, this one's included, come here from now on, or do so no more. Only while Open.
  virtual void listen([[maybe_unused]] bool on) noexcept {}
  /// Takes the next request that has come in, its `bytes`; false if there is none. Only while Open.
  [[nodiscard]] virtual bool receive_request([[maybe_unused]] Message& message) noexcept { return false; }
};

}  // namespace hub::trunk
