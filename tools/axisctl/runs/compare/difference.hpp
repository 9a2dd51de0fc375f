#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meaning/cob_ids.hpp"
#include "tools/axisctl/runs/log/log_reader.hpp"

namespace runs {

/// What two frames of the same place differ in, the first of it.
enum class DifferenceKind : std::uint8_t {
  Identifier,
  Format,  ///< 11 or 29 bits, data or remote frame, frame or error frame
  Length,
  Data,
  Time,
  End,  ///< one log has no more frames
};
inline constexpr std::array<std::string_view, 6> kDifferenceKinds{"identifier", "format", "length",
                                                                  "data",       "time",   "end"};

/// A frame of both logs.
struct FramePair {
  std::optional<LoggedFrame> a{}, b{};
};

/// A byte that differs; `bits`: which of its bits do.
struct ByteDifference {
  unsigned byte = 0;
  std::uint8_t a = 0, b = 0;
  [[nodiscard]] std::uint8_t bits() const noexcept { return a ^ b; }
};

/// A frame that both logs have before the difference, and what it says.
struct Former {
  std::string what;  ///< "same identifier", "SDO request", "NMT", "SYNC", "PDO"
  LoggedFrame frame{};
  std::string words{};
};

/// How the times of frames differ that are the same, each since the first frame of its log.
struct TimeFigures {
  std::chrono::nanoseconds largest{};  ///< b less a, of the largest amount
  std::uint64_t largest_place = 0;     ///< in a
  std::chrono::nanoseconds first{};    ///< the first that differs
  std::uint64_t first_place = 0;       ///< in a; 0: none does
};

/// The first difference, with its surroundings.
struct Difference {
  DifferenceKind kind = DifferenceKind::Data;
  FramePair at{};
  std::vector<FramePair> before{}, after{};
  std::vector<ByteDifference> bytes{};
  std::string words_a{}, words_b{};
  std::vector<Former> formers{};
  /// So many frames behind, 1 or more, the other log has the same frame; 0: not within the surroundings.
  std::size_t a_in_b = 0, b_in_a = 0;
};

/// What came of a comparison.
struct Compared {
  std::uint64_t frames = 0;  ///< that are the same
  std::chrono::nanoseconds begin_a{}, begin_b{};
  bool has_times = false;  ///< both logs have
  TimeFigures times{};
  std::optional<Difference> difference{};
  std::vector<std::string> remarks{};
};

}  // namespace runs
