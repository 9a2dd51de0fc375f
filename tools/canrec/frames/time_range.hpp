#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace canrec {

/// A moment in a log: behind its first frame, or on the clock.
struct Moment {
  std::chrono::nanoseconds time{};  ///< since the first frame, or since 1970
  bool is_absolute = false;

  friend bool operator==(const Moment&, const Moment&) = default;
};

/// Reads `12.5` (seconds behind the first frame) or `@1700000000.123456` (time stamp). The error says what was
/// expected.
[[nodiscard]] tl::expected<Moment, std::string> read_moment(std::string_view text);

/// Which part of a log is meant: from one moment, included, to another, left out.
struct TimeRange {
  std::optional<Moment> from;
  std::optional<Moment> to;

  enum class Place { Before, Within, Behind };
  /// Where a frame of time stamp @p at lies, in a log that begins with one of @p first.
  [[nodiscard]] Place place_of(std::chrono::nanoseconds at, std::chrono::nanoseconds first) const noexcept;
};

}  // namespace canrec
