#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "can/hub/trunk/latency.hpp"
#include "can/hub/trunk/message.hpp"
#include "can/hub/trunk/stream.hpp"
#include "can/hub/trunk/under_way.hpp"

namespace hub::trunk {

/// What a hub sends: the frames of its members, and its beats.
///
/// Without a bit rate frames go into the stream. With one they are asked of an arbiter, who puts them there, those
/// of each station in their order; the hub's beats go to him as well.
class Outgoing {
 public:
  struct Settings {
    std::uint32_t hub = 0;
    std::string name;
    std::uint32_t bit_rate = 0;  ///< of the bus (bit/s); 0: frames take no time
    std::size_t frames_a_message = kMostFrames;
  };

  /// @p stream outlives this.
  Outgoing(Stream& stream, Settings settings) : stream_{stream}, settings_{std::move(settings)} {}

  /// The hub joins the bus, once more; @p seen: what has come from the stream so far.
  void join() noexcept {
    ++epoch_;
    term_ = 0;
  }
  /// Frames pass from now on; with a bit rate those that the arbiter of @p term lets pass, else 0.
  void begin(std::uint32_t term) noexcept { term_ = term; }
  [[nodiscard]] std::uint32_t epoch() const noexcept { return epoch_; }
  /// The message of the stream that has come last has this time stamp (ns); 0: none yet.
  void see(std::int64_t time_ns) noexcept {
    seen_ = time_ns;
    if (time_ns == 0) returned_seen_ = 0;
  }
  [[nodiscard]] std::int64_t seen() const noexcept { return seen_; }

  /// Whether take() may have a frame of @p station.
  [[nodiscard]] bool has_room(std::uint32_t station) const noexcept {
    return !under_way_.full() && (settings_.bit_rate == 0 || under_way_.count(station) < kMostWaiting);
  }
  /// Takes a frame of a member along; it is sent by flush() at the latest.
  void take(const Passage& passage) noexcept;
  /// Leaves a number out: the others miss a frame.
  void skip() noexcept { ++counter_; }
  /// Whether flush() has something to do.
  [[nodiscard]] bool is_waiting() const noexcept { return writer_.frames() > 0 || is_unsent_; }
  /// Sends what has been taken, with one system call.
  void flush() noexcept;
  /// Says that this hub is there, with flush() at the latest; @p own_term: the term in which it is the arbiter, 0
  /// = it is not.
  void beat(std::uint32_t own_term) noexcept;

  /// Whether somebody else has sent once more what this hub has sent in this epoch.
  [[nodiscard]] bool is_repeated(const Reader& reader) const noexcept;
  /// The message of @p header, which this hub has sent, has come back.
  void note_return(const Header& header) noexcept { returned_seen_ = header.seen; }
  /// Frame @p number of @p reader, one of this hub, has come back: takes it off. Nothing if it is not the one that
  /// was to come back.
  [[nodiscard]] std::optional<Passage> take_back(const Reader& reader, std::size_t number) noexcept;
  /// Gives up what has not come back; how many frames that was.
  std::size_t drop() noexcept;
  /// @p participant has left.
  void forget(const Participant& participant) noexcept { under_way_.forget(participant); }

  [[nodiscard]] std::size_t under_way() const noexcept { return under_way_.count(); }
  /// From taking a frame until it came back.
  [[nodiscard]] const Latency& latency() const noexcept { return latency_; }

 private:
  using Way = void (Stream::*)(std::span<const std::byte>);

  [[nodiscard]] Header header(Kind kind) const noexcept;
  void send(Way way, Writer& writer) noexcept;
  void finish_message() noexcept;
  [[nodiscard]] std::uint32_t lane_of(std::uint32_t station) const noexcept {
    return settings_.bit_rate != 0 ? station : 0;
  }
  /// Number of the frame that comes back next, among all of the hub.
  [[nodiscard]] std::uint64_t expected() const noexcept { return counter_ - under_way_.count(); }

  Stream& stream_;
  Settings settings_;
  std::uint32_t epoch_ = 0;
  std::uint32_t term_ = 0;
  std::uint64_t counter_ = 1;  ///< number of the next frame that is taken
  std::int64_t seen_ = 0;
  std::int64_t returned_seen_ = 0;  ///< the same as it was in the last message of this hub that came back
  bool is_unsent_ = false;          ///< the stream has taken a message that it has not sent yet
  Writer writer_;                   ///< frames that are sent at the end of the turn
  UnderWay under_way_;
  Latency latency_;
};

}  // namespace hub::trunk
