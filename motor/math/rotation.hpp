#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "motor/math/pair.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// Cosine and sine of a small angle (rad) by their series; 1e-9 up to 0.3, 2e-7 up to 0.6.
[[gnu::always_inline]] inline Pair small_rotation(double angle) noexcept {
  const Pair s = both(angle * angle);
  const Pair series =
      1.0 - s * (Pair{1.0 / 2, 1.0 / 6} - s * (Pair{1.0 / 24, 1.0 / 120} - s * Pair{1.0 / 720, 1.0 / 5040}));
  return series * Pair{1.0, angle};
}

/// Cosine and sine of @p angle (rad, below 1e3), 1e-13 or better: 1e-15 within some turns. Cheaper than the
/// mathematical library, which also takes care of huge angles.
inline SpaceVector unit_vector(double angle) noexcept {
  // A quarter turn in two parts, the first short enough to be multiplied exactly.
  constexpr double kQuarter = static_cast<float>(0.5 * std::numbers::pi);
  constexpr double kRest = 0.5 * std::numbers::pi - kQuarter;
  constexpr double kRounding = 6755399441055744.0;  // 1.5·2^52: adding it rounds to whole numbers
  constexpr std::array<double, 5> kCircle{1.0, 0.0, -1.0, 0.0, 1.0};
  // Coefficients of cosine and sine, 1/n!.
  constexpr std::array<Pair, 7> kSeries{Pair{1.0 / 2, 1.0 / 6},
                                        Pair{1.0 / 24, 1.0 / 120},
                                        Pair{1.0 / 720, 1.0 / 5040},
                                        Pair{1.0 / 40320, 1.0 / 362880},
                                        Pair{1.0 / 3628800, 1.0 / 39916800},
                                        Pair{1.0 / 479001600, 1.0 / 6227020800},
                                        Pair{1.0 / 87178291200, 1.0 / 1307674368000}};
  const double quarters = (angle * (2.0 / std::numbers::pi) + kRounding) - kRounding;
  const double r = (angle - quarters * kQuarter) - quarters * kRest;
  const Pair s = both(r * r);
  const Pair s2 = s * s;
  const Pair s4 = s2 * s2;
  // In pairs of pairs: a chain of single steps would take twice as long.
  const Pair low = (1.0 - s * kSeries[0]) + s2 * (kSeries[1] - s * kSeries[2]);
  const Pair high = (kSeries[3] - s * kSeries[4]) + s2 * (kSeries[5] - s * kSeries[6]);
  const Pair series = (low + s4 * high) * Pair{1.0, r};
  const auto quadrant = static_cast<std::size_t>(static_cast<std::int64_t>(quarters) & 3);
  return vector(turned_back(series, kCircle[quadrant], kCircle[quadrant + 1]));
}

/// The unit vector @p a turned by a small angle (rad) and brought back to length 1.
[[gnu::always_inline]] inline SpaceVector turned_a_little(SpaceVector a, double angle) noexcept {
  const Pair turn = small_rotation(angle);
  const Pair turned = turned_back(pair(a), turn[0], -turn[1]);
  return vector((1.5 - 0.5 * dot(turned, turned)) * turned);
}

}  // namespace motor
