#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "motor/math/pair.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// Cosine and sine of a small angle (rad) by their series; 1e-9 up to 0.3, 2e-7 up to 0.6.
template <class Number>
[[gnu::always_inline]] inline PairOf<Number> small_rotation(const Number& angle) noexcept {
  const PairOf<Number> s = both(angle * angle);
  const PairOf<Number> series =
      1.0 - s * (constants<Number>(1.0 / 2, 1.0 / 6) -
                 s * (constants<Number>(1.0 / 24, 1.0 / 120) - s * constants<Number>(1.0 / 720, 1.0 / 5040)));
  return series * PairOf<Number>{Number{1.0}, angle};
}

namespace rotation {

/// Cosine and sine of @p quarters of a turn.
inline SpaceVector quarter_turns(double quarters) noexcept {
  constexpr std::array<double, 5> kCircle{1.0, 0.0, -1.0, 0.0, 1.0};
  const auto quadrant = static_cast<std::size_t>(static_cast<std::int64_t>(quarters) & 3);
  return {kCircle[quadrant], kCircle[quadrant + 1]};
}
template <class Number>
SpaceVectorOf<Number> quarter_turns(const Number& quarters) noexcept {
  const Number quadrant = quarters - 4.0 * floor(0.25 * quarters);
  return {select<Number>(quadrant == 0.0, 1.0, select<Number>(quadrant == 2.0, -1.0, 0.0)),
          select<Number>(quadrant == 3.0, 1.0, select<Number>(quadrant == 1.0, -1.0, 0.0))};
}

}  // namespace rotation

/// Cosine and sine of @p angle (rad, below 1e3), 1e-13 or better: 1e-15 within some turns. Cheaper than the
/// mathematical library, which also takes care of huge angles.
template <class Number>
SpaceVectorOf<Number> unit_vector(const Number& angle) noexcept {
  // A quarter turn in two parts, the first short enough to be multiplied exactly.
  constexpr double kQuarter = static_cast<float>(0.5 * std::numbers::pi);
  constexpr double kRest = 0.5 * std::numbers::pi - kQuarter;
  constexpr double kRounding = 6755399441055744.0;  // 1.5·2^52: adding it rounds to whole numbers
  const Number quarters = (angle * (2.0 / std::numbers::pi) + kRounding) - kRounding;
  const Number r = (angle - quarters * kQuarter) - quarters * kRest;
  const PairOf<Number> s = both(r * r);
  const PairOf<Number> s2 = s * s;
  const PairOf<Number> s4 = s2 * s2;
  // Series of cosine and sine, 1/n!, in pairs of pairs: a chain of single steps would take twice as long.
  const PairOf<Number> low =
      (1.0 - s * constants<Number>(1.0 / 2, 1.0 / 6)) +
      s2 * (constants<Number>(1.0 / 24, 1.0 / 120) - s * constants<Number>(1.0 / 720, 1.0 / 5040));
  const PairOf<Number> high =
      (constants<Number>(1.0 / 40320, 1.0 / 362880) - s * constants<Number>(1.0 / 3628800, 1.0 / 39916800)) +
      s2 * (constants<Number>(1.0 / 479001600, 1.0 / 6227020800) -
            s * constants<Number>(1.0 / 87178291200, 1.0 / 1307674368000));
  const PairOf<Number> series = (low + s4 * high) * PairOf<Number>{Number{1.0}, r};
  const SpaceVectorOf<Number> turn = rotation::quarter_turns(quarters);
  return vector(turned_back<Number>(series, turn.re, turn.im));
}

/// The unit vector @p a turned by a small angle (rad) and brought back to length 1.
template <class Number>
[[gnu::always_inline]] inline SpaceVectorOf<Number> turned_a_little(const SpaceVectorOf<Number>& a,
                                                                    const Number& angle) noexcept {
  const PairOf<Number> turn = small_rotation(angle);
  const PairOf<Number> turned = turned_back<Number>(pair(a), turn[0], -turn[1]);
  return vector((1.5 - 0.5 * dot(turned, turned)) * turned);
}

}  // namespace motor
