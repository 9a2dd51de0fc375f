#pragma once

#include <optional>

namespace cia402 {

/// From `low` to `high`, low below high.
struct Span {
  double low = 0.0;
  double high = 0.0;

  friend bool operator==(const Span&, const Span&) = default;
};

/// What bounds every motion, whatever the mode is.
struct Limits {
  double velocity = 0.0;           ///< min(607Fh, 6080h), positive (position units/s)
  double acceleration = 0.0;       ///< 60C5h, positive (position units/s²)
  double deceleration = 0.0;       ///< 60C6h, likewise
  std::optional<Span> software{};  ///< 607Dh in the coordinates of 6064h, if it is in force
  std::optional<Span> range{};     ///< 607Bh, if it is: the modulus is high - low + 1

  friend bool operator==(const Limits&, const Limits&) = default;
};

}  // namespace cia402
