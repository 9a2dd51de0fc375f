#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "can/port/port.hpp"
#include "can/port/socket_address.hpp"
#include "can/port/socketcand/socketcand_text.hpp"
#include "os/descriptor.hpp"

namespace bus::socketcand {

/// One TCP connection to a server, from connect(2) to raw mode and to its end. Nothing blocks.
class Client {
 public:
  /// How far it has come.
  enum class Stage : std::uint8_t {
    Closed,      ///< not begun, or ended
    Connecting,  ///< waits until the socket is writable
    Greeting,    ///< waits for "< hi >"
    Opening,     ///< waits until the server has opened the bus
    Switching,   ///< waits until the server is in raw mode
    Raw,         ///< frames come and go
  };

  /// Begins to connect to @p server and to open its bus @p name. False: it failed at once, see problem().
  [[nodiscard]] bool begin(const SocketAddress& server, std::string name);
  /// Goes on as far as the socket allows.
  void advance();
  /// Ends the connection.
  void close() noexcept;

  [[nodiscard]] Stage stage() const noexcept { return stage_; }
  /// Why it was closed before it was in raw mode.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
  [[nodiscard]] int descriptor() const noexcept { return socket_.get(); }

  /// Sends @p frame, no remote frame, in raw mode.
  [[nodiscard]] SendStatus send(const canopen::Frame& frame) noexcept;

  /// What read() has found.
  enum class Found : std::uint8_t {
    Nothing,    ///< nothing more waits
    Text,       ///< one message was stored
    Malformed,  ///< a message that is too long
    End,        ///< the server has closed the connection, or it is broken
  };
  /// Takes one message, "<" and ">" included, into @p text, which is valid until the next call.
  [[nodiscard]] Found read(std::string_view& text) noexcept;

 private:
  void on_connected();
  void on_message(std::string_view text);
  void say(const Message& message);
  void fail(std::string problem);

  os::Descriptor socket_;
  Stage stage_ = Stage::Closed;
  std::string name_;
  std::string problem_;
  MessageReader reader_;
};

}  // namespace bus::socketcand
