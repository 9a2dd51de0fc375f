#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

/// The equations of motor/ are written for any @p Number: a double, or lanes of them, one for each of several axes
/// side by side (motor/lockstep). They calculate alike to the last bit.
namespace motor {

using std::abs;
using std::copysign;
using std::floor;
using std::sqrt;

/// What a comparison of two numbers gives: bool, or one for each lane.
template <class Number>
using Condition = decltype(std::declval<Number>() < std::declval<Number>());

/// Whether it holds in a lane.
template <class Mask>
[[gnu::always_inline]] inline bool any(const Mask& condition) noexcept {
  if constexpr (std::is_same_v<Mask, bool>)
    return condition;
  else
    return any_of(condition);
}
/// Whether it holds in every lane.
template <class Mask>
[[gnu::always_inline]] inline bool all(const Mask& condition) noexcept {
  if constexpr (std::is_same_v<Mask, bool>)
    return condition;
  else
    return all_of(condition);
}

/// @p a where @p condition holds, @p b elsewhere.
template <class Number>
[[gnu::always_inline]] inline Number select(const Condition<Number>& condition, const Number& a,
                                            const std::type_identity_t<Number>& b) noexcept {
  if constexpr (std::is_same_v<Number, double>) {
    return condition ? a : b;
  } else if constexpr (requires { chosen(condition, a, b); }) {
    return chosen(condition, a, b);
  } else {
    Number result = b;
    where(condition, result) = a;
    return result;
  }
}

/// The same of conditions.
template <class Mask>
[[gnu::always_inline]] inline Mask select_condition(const Mask& condition, const Mask& a, const Mask& b) noexcept {
  return (condition && a) || (!condition && b);
}

/// As std::min, std::max and std::clamp have them.
template <class Number>
[[gnu::always_inline]] inline Number minimum(const Number& a, const std::type_identity_t<Number>& b) noexcept {
  if constexpr (requires { lesser(Number{b}, a); })
    return lesser(Number{b}, a);
  else
    return select<Number>(b < a, b, a);
}
template <class Number>
[[gnu::always_inline]] inline Number maximum(const Number& a, const std::type_identity_t<Number>& b) noexcept {
  if constexpr (requires { greater(Number{b}, a); })
    return greater(Number{b}, a);
  else
    return select<Number>(a < b, b, a);
}
template <class Number>
[[gnu::always_inline]] inline Number bounded(const Number& a, const std::type_identity_t<Number>& lower,
                                             const std::type_identity_t<Number>& upper) noexcept {
  return select<Number>(a < lower, lower, minimum<Number>(a, upper));
}

/// Where @p condition does not hold, @p now is again what it was @p before. @p Values consist of numbers only.
template <class Number, class Values>
void keep(const Condition<Number>& condition, Values& now, const Values& before) noexcept {
  if constexpr (std::is_same_v<Number, double>) {
    if (!condition) now = before;
  } else {
    static_assert(std::is_trivially_copyable_v<Values> && sizeof(Values) % sizeof(Number) == 0);
    using Numbers = std::array<Number, sizeof(Values) / sizeof(Number)>;
    auto changed = std::bit_cast<Numbers>(now);
    const auto old = std::bit_cast<Numbers>(before);
    for (std::size_t i = 0; i < changed.size(); ++i) changed[i] = select<Number>(condition, changed[i], old[i]);
    now = std::bit_cast<Values>(changed);
  }
}

/// Cosine and sine of @p angle (rad), of each lane by the mathematical library.
template <class Number>
Number cosine(const Number& angle) noexcept {
  if constexpr (std::is_same_v<Number, double>)
    return std::cos(angle);
  else
    return Number{[&](auto lane) { return std::cos(angle[lane]); }};
}
template <class Number>
Number sine(const Number& angle) noexcept {
  if constexpr (std::is_same_v<Number, double>)
    return std::sin(angle);
  else
    return Number{[&](auto lane) { return std::sin(angle[lane]); }};
}

/// A condition that is kept: as a number, so that what holds it consists of numbers only.
template <class Number>
class Flag {
 public:
  Flag() = default;
  Flag(const Condition<Number>& condition) noexcept  // NOLINT(google-explicit-constructor): it is the same thing
      : value_{select<Number>(condition, 1.0, 0.0)} {}

  Condition<Number> holds() const noexcept { return value_ != 0.0; }

 private:
  Number value_ = 0.0;
};

/// @p a where @p condition holds, @p b elsewhere.
template <class Number>
[[gnu::always_inline]] inline Flag<Number> select(const Condition<Number>& condition, const Flag<Number>& a,
                                                  const Flag<Number>& b) noexcept {
  return select_condition(condition, a.holds(), b.holds());
}

}  // namespace motor
