#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "can/hub/medium/origins.hpp"
#include "can/hub/trunk/hubs.hpp"
#include "can/hub/trunk/terms.hpp"
#include "tools/canrec/frames/frame_source.hpp"

namespace canrec {

/// A message of a bus as a recording has it.
struct Message {
  std::span<const std::byte> bytes;
  std::uint64_t sequence = 0;                          ///< among all of the stream
  std::chrono::nanoseconds at{};                       ///< when the stream of the bus took it in, since 1970
  std::optional<std::chrono::nanoseconds> log_time{};  ///< that of its frames in the log that they come from
};

/// Which frames of the messages of a bus have passed there, by the rules of the hubs
/// (docs/reference/trunk-protocol.md).
class Transcript {
 public:
  struct Figures {
    std::uint64_t frames = 0;     ///< that have passed
    std::uint64_t missed = 0;     ///< numbers of frames that were left out
    std::uint64_t gaps = 0;       ///< places where some were
    std::uint64_t late = 0;       ///< frames that came too late to pass, or from an arbiter that was it no more
    std::uint64_t repeated = 0;   ///< frames that had passed before
    std::uint64_t malformed = 0;  ///< messages that are none of a hub
  };

  /// Takes the next message, and puts the frames that have passed with it behind @p frames.
  void take(const Message& message, std::vector<TimedFrame>& frames);

  [[nodiscard]] const Figures& figures() const noexcept { return figures_; }
  /// "12 frames, none missed"; "12 frames, 3 missed in 2 gaps; 1 late".
  [[nodiscard]] std::string text() const;

 private:
  /// Whether @p header comes from an arbiter who is none, or none any more.
  [[nodiscard]] bool is_overruled(const hub::trunk::Header& header, bool is_late) noexcept;

  hub::trunk::Hubs hubs_;
  hub::trunk::Terms terms_;
  hub::Origins origins_;
  Figures figures_;
};

}  // namespace canrec
