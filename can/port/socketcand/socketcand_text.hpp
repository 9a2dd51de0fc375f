#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include <tl/expected.hpp>

#include "libcanopen/base/frame.hpp"

/// The text form of the socketcand protocol: messages "< WORD ARGUMENT... >" in both directions over TCP. Pure
/// functions; nothing allocates. Texts in a parsed message lie in the text that was parsed.
namespace bus::socketcand {

/// Longest message that is read or written (characters); the longest frame takes 58.
inline constexpr std::size_t kLongestMessage = 256;

/// "< hi >": the server's greeting.
struct Hi {};
/// "< ok >": the server has done what was asked.
struct Ok {};
/// "< rawmode >": the client wants every frame of the bus.
struct RawMode {};
/// "< echo >": asked by the client, answered with the same by the server.
struct Echo {};
/// "< open NAME >": the client wants the bus called NAME.
struct Open {
  std::string_view name;
};
/// "< error TEXT >": the server refuses something, or tells of an error frame.
struct Error {
  std::string_view text;
};
/// "< send ID LENGTH BYTE... >": the client sends a frame.
struct Send {
  canopen::Frame frame;
};
/// "< frame ID SECONDS.MICROSECONDS BYTES >": the server tells of a frame.
struct FrameSeen {
  canopen::Frame frame;
  std::int64_t time_us = 0;  ///< end of the frame on the bus, microseconds since the epoch
};

using Message = std::variant<Hi, Ok, RawMode, Echo, Open, Error, Send, FrameSeen>;

/// Reads one message, "<" and ">" included; otherwise the reason why it is none, a phrase for "< error ... >".
///
/// The protocol has no remote frames. An identifier is a 29-bit one if it is written with eight digits or does not
/// fit in 11 bits.
[[nodiscard]] tl::expected<Message, std::string_view> parse(std::string_view text) noexcept;

/// Room for one message that is printed.
using Room = std::array<char, kLongestMessage>;

/// Writes @p message to @p room and returns it. Texts that are too long are cut, and a ">" or "<" in them becomes
/// a "?". Remote frames, for which there is no form, give an empty text.
std::string_view print(const Message& message, Room& room) noexcept;

/// Cuts what comes over TCP into messages, wherever the segments end.
class MessageReader {
 public:
  /// What next() found.
  struct Found {
    enum class Kind : std::uint8_t {
      Nothing,   ///< no complete message: read more
      Complete,  ///< `text` is a message, "<" and ">" included; valid until the next room()
      TooLong,   ///< a message of more than kLongestMessage characters begins; it is skipped to its ">"
    };
    Kind kind = Kind::Nothing;
    std::string_view text;
  };

  /// Where to read the next characters to, never empty. To be called when next() has found nothing.
  std::span<char> room() noexcept;
  /// Takes the first @p size characters of room() as read.
  void filled(std::size_t size) noexcept { end_ += size; }
  /// The next message. What stands between messages is ignored.
  Found next() noexcept;

 private:
  static constexpr std::size_t kSize = 4096;

  Found unfinished(std::string_view begun) noexcept;

  std::array<char, kSize> buffer_{};
  std::size_t begin_ = 0;  ///< of what next() has not seen yet
  std::size_t end_ = 0;
  bool skipping_ = false;  ///< inside a message that is too long
};

}  // namespace bus::socketcand
