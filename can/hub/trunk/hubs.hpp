#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "can/hub/trunk/message.hpp"
#include "libcanopen/base/time.hpp"

namespace hub::trunk {

/// What one hub knows of another one on the same stream.
struct Neighbour {
  std::uint32_t hub = 0;  ///< 0: the place is free
  std::uint32_t epoch = 0;
  std::uint64_t next = 0;      ///< number of the frame that is expected next; 0 = not known yet
  std::uint64_t received = 0;  ///< frames of it that have passed here
  std::uint64_t missed = 0;    ///< frames of it that have not
  canopen::TimePoint heard{};  ///< when its last message came
  bool is_present = false;
  std::array<char, kLongestName + 1> name{};  ///< ended by zeros

  [[nodiscard]] std::string_view text() const noexcept { return name.data(); }
};

/// The other hubs of a bus, and the account of what was missed of each: every hub numbers its frames, so a number
/// that is left out is a frame that has not come here.
class Hubs {
 public:
  /// Hubs that are kept apart; of more those that were heard last.
  static constexpr std::size_t kMost = 64;
  /// Without a message of it for so long a hub counts as gone.
  static constexpr canopen::Duration kPatience = std::chrono::milliseconds{1000};

  /// What a message tells of its hub.
  enum class News : std::uint8_t { None, Joined, Returned };
  struct Outcome {
    Neighbour& hub;
    News news = News::None;
    std::size_t repeated = 0;  ///< frames at the beginning of the message that have been here before
  };

  /// Whether the message of @p header was sent before its hub has returned, and has come behind that: its frames
  /// count as missed already.
  [[nodiscard]] bool is_outdated(const Header& header) const noexcept;
  /// Takes the message of @p header into the account; @p frames: it has so many.
  Outcome note(const Header& header, std::size_t frames, canopen::TimePoint now) noexcept;
  /// @p frames of @p hub, which note() has counted, have not passed here.
  void miss(Neighbour& hub, std::size_t frames) noexcept;
  /// One that has gone silent, told once; nullptr if there is none.
  Neighbour* take_gone(canopen::TimePoint now) noexcept;
  /// Nobody goes silent while nothing can be heard: all count as heard at @p now.
  void forgive(canopen::TimePoint now) noexcept;

  /// All places.
  [[nodiscard]] std::span<const Neighbour> all() const noexcept { return hubs_; }
  /// Frames of others that were missed.
  [[nodiscard]] std::uint64_t missed() const noexcept { return missed_; }
  /// Frames that came a second time and were left out.
  [[nodiscard]] std::uint64_t repeated() const noexcept { return repeated_; }

 private:
  Neighbour& place_of(std::uint32_t hub) noexcept;

  std::array<Neighbour, kMost> hubs_{};
  std::uint64_t missed_ = 0;
  std::uint64_t repeated_ = 0;
};

}  // namespace hub::trunk
