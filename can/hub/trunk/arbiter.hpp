#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "can/hub/medium/time_line.hpp"
#include "can/hub/medium/waiting.hpp"
#include "can/hub/trunk/message.hpp"
#include "libcanopen/base/time.hpp"

namespace hub::trunk {

/// Decides which of the frames that the hubs of a bus have asked for is next: when the bus becomes idle, the
/// lowest arbitration field among the first frames of all stations wins, and its frame takes the time of its bits,
/// as on the Medium of one host. How long a frame waits for that is no matter.
///
/// What a hub has asked for is lost, all of it, if a request of it is missing, if it asks for more than it may, or
/// if it had no contact with the stream for 500 ms.
class Arbiter {
 public:
  /// Hubs that are kept apart; of more, those that have no contact make room.
  static constexpr std::size_t kMostHubs = 64;
  /// Stations, of all hubs together, whose frames wait at a time; each may have kMostWaiting.
  static constexpr std::size_t kMostStations = 1024;

  /// A frame that has passed.
  struct Granted {
    Header header;  ///< without `seen` and `term`, which its sender has
    MarkedFrame frame;
    std::int64_t end = 0;  ///< on the bus, CLOCK_REALTIME (ns)
  };

  /// @p bit_rate in bit/s, not 0.
  explicit Arbiter(std::uint32_t bit_rate);
  Arbiter(const Arbiter&) = delete;
  Arbiter& operator=(const Arbiter&) = delete;
  ~Arbiter() = default;

  /// Begins @p term, with nothing that was asked for before.
  void begin(std::uint32_t term) noexcept;
  /// Takes @p request; @p seen is the time stamp of the last message that this hub has got from the stream (ns).
  void take(const Reader& request, std::int64_t seen, canopen::TimePoint now) noexcept;
  /// @p hub has joined the bus anew: what it has asked for in an older epoch is void.
  void on_epoch(std::uint32_t hub, std::uint32_t epoch) noexcept;
  /// Looks which hubs have had no contact with the stream; only while no request waits to be taken.
  void look(std::int64_t seen) noexcept;

  /// The next frame that has come to its end until @p now.
  std::optional<Granted> pass(canopen::TimePoint now) noexcept;
  /// A hub whose frames were lost, told once: `hub` and `epoch` of it; nothing if there is none.
  std::optional<Header> take_lost() noexcept;
  /// When pass() is wanted; kNever while nobody waits.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;

  /// Frames that wait.
  [[nodiscard]] std::size_t waiting() const noexcept;

 private:
  enum class State : std::uint8_t { Heard, Lost, Told };
  struct Client {
    std::uint32_t hub = 0;  ///< 0: the place is free
    std::uint32_t epoch = 0;
    std::uint64_t asked = 0;   ///< number of the frame that it asks for next
    std::uint64_t passed = 0;  ///< number that its next frame gets on the bus
    std::int64_t seen = 0;     ///< when it had contact with the stream (ns)
    State state = State::Heard;
  };
  struct Asked {
    MarkedFrame frame;
    std::uint32_t origin = 0;
  };
  struct Station {
    Client* client = nullptr;
    std::uint32_t number = 0;  ///< as its hub has it
    WaitingFrames<Asked> frames;
  };
  /// The frame on the bus.
  struct Current {
    Client* client = nullptr;  ///< nullptr: what has become of its hub makes it void
    std::uint32_t station = 0;
    Asked asked;
  };

  [[nodiscard]] Client* client_of(const Header& header) noexcept;
  [[nodiscard]] Client* place_of(std::uint32_t hub) noexcept;
  void register_anew(Client& client, const Header& header) noexcept;
  void take_frames(Client& client, const Reader& request, canopen::TimePoint now) noexcept;
  [[nodiscard]] Station* station_of(Client& client, std::uint32_t number) noexcept;
  void lose(Client& client) noexcept;
  void forget_frames(const Client& client) noexcept;
  void begin_frame(canopen::TimePoint start) noexcept;
  [[nodiscard]] Granted granted() noexcept;

  TimeLine line_;
  std::uint32_t term_ = 0;
  std::uint64_t handed_over_ = 0;
  bool on_wire_ = false;  ///< current_ has not reached its end
  Current current_;
  std::array<Client, kMostHubs> clients_{};
  std::optional<Header> without_place_;  ///< a hub that is one too many
  std::vector<Station> places_;
  std::vector<Station*> stations_;  ///< those with frames
  std::vector<Station*> free_;      ///< the others
};

}  // namespace hub::trunk
