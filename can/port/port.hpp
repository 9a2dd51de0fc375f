#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "libcanopen/base/frame.hpp"

namespace bus {

/// What became of a frame that was handed to a port.
enum class SendStatus : std::uint8_t {
  Sent,    ///< the bus has taken it
  Full,    ///< no room at the moment (ENOBUFS, EAGAIN): try later
  Down,    ///< the interface is down or gone (ENETDOWN, ENODEV, ENXIO)
  Failed,  ///< refused for good; trying again is of no use
};

/// What became of several frames that were handed over together.
struct SentMany {
  std::size_t count = 0;                 ///< that the bus has taken, from the first on
  SendStatus status = SendStatus::Sent;  ///< of the one behind them; Sent: there is none
};

/// Error state of the CAN controller (ISO 11898-1: error active, error passive, bus-off; warning at 96 errors).
enum class ErrorState : std::uint8_t { Active, Warning, Passive, BusOff };

/// Name of @p state as SocketCAN's tools print it.
constexpr std::string_view name_of(ErrorState state) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"error-active", "error-warning", "error-passive", "bus-off"};
  return kNames[static_cast<std::size_t>(state)];
}

/// What one call of Port::receive() found.
struct Received {
  enum class Kind : std::uint8_t {
    Frame,    ///< a frame was stored
    Nothing,  ///< nothing waits
    Down,     ///< the interface went down or is gone; told once an event
    Error,    ///< the controller's error state changed to `state`
  };
  using enum Kind;

  Kind kind = Nothing;
  ErrorState state = ErrorState::Active;  ///< error state after this call

  friend constexpr bool operator==(const Received&, const Received&) = default;
};

/// One of several that were received together.
struct Arrival {
  Received received;
  canopen::Frame frame;  ///< of Received::Frame
};

/// What came of an attempt to bring a controller back from bus-off.
enum class Restart : std::uint8_t {
  Done,     ///< the bus can be used
  Started,  ///< the controller starts again: Received::Error tells when it is there
  Refused,  ///< the program may not (CAP_NET_ADMIN): the interface has to do it by itself (restart-ms)
};

/// One identifier that a port shall deliver; frame format and remote bit must match too.
struct Filter {
  std::uint32_t identifier = 0;  ///< 0..7FFh, with `extended` 0..1FFFFFFFh
  bool remote = false;           ///< true: remote frames only, false: data frames only
  bool extended = false;         ///< 29-bit identifier

  friend constexpr bool operator==(const Filter&, const Filter&) = default;
};

/// Room for frames that have arrived and were not read yet.
struct ReceiveBuffer {
  std::size_t bytes;   ///< as got
  std::size_t wanted;  ///< as asked for

  friend constexpr bool operator==(const ReceiveBuffer&, const ReceiveBuffer&) = default;
};

/// Where a frame came up among hubs that are bridged to each other: which hub, and the number that it got there.
struct Mark {
  static constexpr std::uint32_t kLargestNumber = 0xFFFFF;  ///< after which numbers begin anew

  std::uint32_t hub = 0;  ///< 0: unknown
  std::uint32_t number = 0;

  friend constexpr bool operator==(const Mark&, const Mark&) = default;
};

/// A connection to one CAN bus; nothing here blocks, and send() and receive() neither allocate nor throw.
class Port {
 public:
  Port() = default;
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  virtual ~Port() = default;

  /// Tries to send @p frame now.
  [[nodiscard]] virtual SendStatus send(const canopen::Frame& frame) noexcept = 0;
  /// Tries to send all of @p frames now, in their order.
  [[nodiscard]] virtual SentMany send_all(std::span<const canopen::Frame> frames) noexcept {
    for (std::size_t i = 0; i < frames.size(); ++i)
      if (const SendStatus status = send(frames[i]); status != SendStatus::Sent) return {i, status};
    return {frames.size(), SendStatus::Sent};
  }
  /// True if send_all() costs less than the frames would one by one.
  [[nodiscard]] virtual bool sends_together() const noexcept { return false; }
  /// Takes one frame into @p frame, which is touched only when the answer is Received::Frame.
  [[nodiscard]] virtual Received receive(canopen::Frame& frame) noexcept = 0;
  /// As receive(), as often as @p arrivals has room and something waits, or as often as one look at the bus
  /// allows: how many it has filled.
  [[nodiscard]] virtual std::size_t receive_all(std::span<Arrival> arrivals) noexcept {
    std::size_t count = 0;
    for (; count < arrivals.size(); ++count) {
      arrivals[count].received = receive(arrivals[count].frame);
      if (arrivals[count].received.kind == Received::Nothing) break;
    }
    return count;
  }
  /// True if receive() has more to give without a look at the bus.
  [[nodiscard]] virtual bool has_frames() const noexcept { return false; }
  /// When the frame that receive() has given last came from the bus (since the epoch of CLOCK_REALTIME), if the
  /// port can tell; may be a system call.
  [[nodiscard]] virtual std::optional<std::chrono::nanoseconds> frame_arrival() const noexcept {
    return std::nullopt;
  }
  /// For bridges between hubs, on a bus that has hubs: from now on frames carry marks.
  virtual void carry_marks() noexcept {}
  /// As send(), with the mark of the frame.
  [[nodiscard]] virtual SendStatus send_marked(const canopen::Frame& frame, const Mark&) noexcept {
    return send(frame);
  }
  /// The mark of the frame that receive() gave last.
  [[nodiscard]] virtual Mark mark() const noexcept { return {}; }
  /// Error state as last reported by the controller.
  [[nodiscard]] virtual ErrorState error_state() const noexcept = 0;
  /// Number of received frames that were lost because nobody read them in time.
  [[nodiscard]] virtual std::uint64_t dropped() const noexcept = 0;
  /// File descriptor that polls readable when receive() has something to say; the port keeps it for its lifetime.
  [[nodiscard]] virtual int descriptor() const noexcept = 0;
  /// Delivers from now on only frames that match one of @p filters; without a filter no frame at all.
  virtual void accept_only(std::span<const Filter> filters) noexcept = 0;
  /// Connects the same port again and forgets what was received before; to be called whenever the Link has told
  /// Up, also if it was up before. After Received::Down nothing is sent or received until then. False: not there.
  [[nodiscard]] virtual bool reopen() noexcept = 0;
  /// Brings the controller back from bus-off; where there is none, the bus can be used at once.
  [[nodiscard]] virtual Restart restart() noexcept { return Restart::Done; }
  /// False if the bus cannot carry remote frames: send() fails with them, and none arrives.
  [[nodiscard]] virtual bool carries_remote_frames() const noexcept { return true; }
  /// The receive buffer, where its size is up to the system.
  [[nodiscard]] virtual std::optional<ReceiveBuffer> receive_buffer() const noexcept { return std::nullopt; }
};

}  // namespace bus
