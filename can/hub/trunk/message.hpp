#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <linux/can.h>

#include "can/port/port.hpp"

/// What hubs of one bus tell each other over a stream (docs/reference/trunk-protocol.md): messages in one order,
/// each with a time stamp of the stream. All numbers are little endian.
namespace hub::trunk {

inline constexpr std::uint8_t kVersion = 1;

/// What a message is.
enum class Kind : std::uint8_t {
  Frames,  ///< frames that are on the bus with it
  Beat,    ///< its hub is there; the text behind the header names it
};

/// What every message begins with.
struct Header {
  Kind kind = Kind::Frames;
  std::uint16_t count = 0;  ///< frames that follow, 1..kMostFrames; of a Beat: bytes of the name, 0..kLongestName
  std::uint32_t hub = 0;  ///< whose members have sent the frames: a number that no other hub of the bus has, not 0
  std::uint32_t epoch = 0;  ///< how often the hub has joined the stream: what is under way of an older one is lost
  std::uint32_t origin = 0;   ///< hub on which the frames came up, another one than `hub` if a bridge brought them
  std::uint64_t counter = 0;  ///< number of the first frame among all of the hub; of a Beat: that of its next one
  std::int64_t seen =
      0;  ///< time stamp of the last message that the hub had got from the stream, 0 = none yet (ns)
};
/// Room of it in a message (bytes).
inline constexpr std::size_t kHeaderSize = 40;
/// Room of a frame: identifier with flags (4), length (1), number of its mark (3), data (8).
inline constexpr std::size_t kFrameSize = 16;
inline constexpr std::size_t kMostFrames = 64;
inline constexpr std::size_t kLongestName = 63;
inline constexpr std::size_t kLongestMessage = kHeaderSize + kMostFrames * kFrameSize;

/// A frame, and the number that it got on the hub where it came up (bus::Mark).
struct MarkedFrame {
  can_frame frame{};
  std::uint32_t number = 0;
};

/// A message that is being put together.
class Writer {
 public:
  /// Begins a message with @p header, whose `count` comes of what follows.
  void begin(const Header& header) noexcept;
  /// Puts a frame behind; only while frames() is less than kMostFrames.
  void add(const MarkedFrame& frame) noexcept;
  /// Puts the name behind, cut to kLongestName.
  void add_name(std::string_view name) noexcept;
  [[nodiscard]] std::size_t frames() const noexcept { return header_.kind == Kind::Frames ? header_.count : 0; }
  [[nodiscard]] const Header& header() const noexcept { return header_; }
  /// The whole message.
  [[nodiscard]] std::span<const std::byte> finish() noexcept;

 private:
  template <class Number>
  void put(Number value) noexcept;

  Header header_;
  std::array<std::byte, kLongestMessage> bytes_{};
  std::size_t size_ = 0;
};

/// A message as it came.
class Reader {
 public:
  /// Reads @p bytes, which outlive this; nothing, and one line in problem, if they are no message of this version.
  [[nodiscard]] static std::optional<Reader> read(std::span<const std::byte> bytes,
                                                  std::string_view& problem) noexcept;

  [[nodiscard]] const Header& header() const noexcept { return header_; }
  /// Number of frames.
  [[nodiscard]] std::size_t frames() const noexcept { return header_.kind == Kind::Frames ? header_.count : 0; }
  /// Frame @p number, 0..frames() - 1.
  [[nodiscard]] MarkedFrame frame(std::size_t number) const noexcept;
  /// Name of a Beat.
  [[nodiscard]] std::string_view name() const noexcept;

 private:
  explicit Reader(std::span<const std::byte> bytes) noexcept : bytes_{bytes} {}
  template <class Number>
  [[nodiscard]] Number get(std::size_t at) const noexcept;
  void read_header() noexcept;
  [[nodiscard]] std::string_view fault() const noexcept;

  std::span<const std::byte> bytes_;
  Header header_;
};

}  // namespace hub::trunk
