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
/// each with a time stamp of the stream; and what hubs of a bus with a bit rate ask of its arbiter, beside the
/// stream. All numbers are little endian.
namespace hub::trunk {

inline constexpr std::uint8_t kVersion = 1;

/// What a message is.
enum class Kind : std::uint8_t {
  Frames,       ///< frames that are on the bus with it; beside the stream: that are to be on the bus
  Beat,         ///< its hub is there; the text behind the header names it
  Granted,      ///< a frame of a hub that the arbiter lets pass
  ArbiterBeat,  ///< a Beat of the hub that is the arbiter
  Lost,         ///< the arbiter has lost frames of a hub
};

/// Whether a message of @p kind comes from the arbiter, whatever hub it is about.
[[nodiscard]] constexpr bool is_of_arbiter(Kind kind) noexcept {
  return kind >= Kind::Granted;
}
/// Whether a message of @p kind says that its hub is there.
[[nodiscard]] constexpr bool is_beat(Kind kind) noexcept {
  return kind == Kind::Beat || kind == Kind::ArbiterBeat;
}

/// What every message begins with.
struct Header {
  Kind kind = Kind::Frames;
  std::uint16_t count = 0;  ///< frames that follow, 1..kMostFrames, or 1 that is Granted; of a beat: bytes of the
                            ///< name, 0..kLongestName
  std::uint32_t hub = 0;  ///< whose members have sent the frames: a number that no other hub of the bus has, not 0
  std::uint32_t epoch = 0;    ///< how often the hub has joined the bus: what is under way of an older one is lost
  std::uint32_t origin = 0;   ///< hub on which the frames came up, another one than `hub` if a bridge brought them
  std::uint64_t counter = 0;  ///< number of the first frame among all of the hub; of a beat: that of its next one
  std::int64_t seen =
      0;  ///< time stamp of the last message that the sender had got from the stream, 0 = none yet (ns)
  std::uint32_t term = 0;  ///< of the arbiter from whom it comes, or whom its hub obeys; 0 = none
  std::uint32_t detail =
      0;  ///< of a beat: bit rate of the bus (bit/s), 0 = none; of frames with a term: station of the hub

  [[nodiscard]] std::uint32_t bit_rate() const noexcept { return detail; }
  [[nodiscard]] std::uint32_t station() const noexcept { return detail; }
  /// Whether a message of the stream is of a bus at @p rate (bit/s, 0 = none).
  [[nodiscard]] bool is_of_bus_at(std::uint32_t rate) const noexcept {
    return is_beat(kind) ? bit_rate() == rate : is_of_arbiter(kind) == (rate != 0);
  }
};
/// Room of it in a message (bytes).
inline constexpr std::size_t kHeaderSize = 40;
/// Room of a frame: identifier with flags (4), length (1), number of its mark (3), data (8).
inline constexpr std::size_t kFrameSize = 16;
/// Room of the end of a frame that is Granted, before it.
inline constexpr std::size_t kTimeSize = 8;
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
  /// Puts the frame that is Granted behind, and its end on the bus (CLOCK_REALTIME, ns).
  void add_granted(const MarkedFrame& frame, std::int64_t end) noexcept;
  /// Puts the name behind, cut to kLongestName.
  void add_name(std::string_view name) noexcept;
  [[nodiscard]] std::size_t frames() const noexcept { return is_beat(header_.kind) ? 0 : header_.count; }
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
  [[nodiscard]] std::size_t frames() const noexcept { return is_beat(header_.kind) ? 0 : header_.count; }
  /// Frame @p number, 0..frames() - 1.
  [[nodiscard]] MarkedFrame frame(std::size_t number) const noexcept;
  /// When its frames have passed (CLOCK_REALTIME, ns): as the arbiter says, or when the stream has taken it in, at
  /// @p taken_in.
  [[nodiscard]] std::int64_t time(std::int64_t taken_in) const noexcept;
  /// Name in a beat.
  [[nodiscard]] std::string_view name() const noexcept;

 private:
  explicit Reader(std::span<const std::byte> bytes) noexcept : bytes_{bytes} {}
  template <class Number>
  [[nodiscard]] Number get(std::size_t at) const noexcept;
  void read_header() noexcept;
  [[nodiscard]] std::string_view fault() const noexcept;
  [[nodiscard]] std::string_view fault_of_frames() const noexcept;
  [[nodiscard]] std::size_t frames_at() const noexcept;

  std::span<const std::byte> bytes_;
  Header header_;
};

}  // namespace hub::trunk
