#pragma once

#include <cstddef>
#include <type_traits>

#include <emmintrin.h>

// Two lanes in a register of SSE2, which every x86-64 has. Conditions stay what a comparison of doubles gives: the
// standard library's take the way over integers, whose comparison SSE2 does not have, lane by lane.
namespace motor {

/// A condition for each of two lanes.
class Sse2Mask {
 public:
  Sse2Mask() = default;
  explicit Sse2Mask(bool value) noexcept : bits_{_mm_set1_epi64x(value ? -1 : 0)} {}
  explicit Sse2Mask(__m128d compared) noexcept : bits_{_mm_castpd_si128(compared)} {}

  /// Of @p a where the condition holds, 0 elsewhere; and the reverse.
  __m128d of(__m128d a) const noexcept { return _mm_castsi128_pd(bits_ & _mm_castpd_si128(a)); }
  __m128d without(__m128d a) const noexcept { return _mm_castsi128_pd(~bits_ & _mm_castpd_si128(a)); }
  bool operator[](std::size_t lane) const noexcept { return bits_[lane] != 0; }

  friend Sse2Mask operator&&(const Sse2Mask& a, const Sse2Mask& b) noexcept { return Sse2Mask{a.bits_ & b.bits_}; }
  friend Sse2Mask operator||(const Sse2Mask& a, const Sse2Mask& b) noexcept { return Sse2Mask{a.bits_ | b.bits_}; }
  Sse2Mask operator!() const noexcept { return Sse2Mask{~bits_}; }
  friend bool any_of(const Sse2Mask& a) noexcept { return a.lanes() != 0; }
  friend bool all_of(const Sse2Mask& a) noexcept { return a.lanes() == 0b11; }

 private:
  explicit Sse2Mask(__m128i bits) noexcept : bits_{bits} {}
  int lanes() const noexcept { return _mm_movemask_pd(_mm_castsi128_pd(bits_)); }

  __m128i bits_;  // all or none of a lane
};

/// A number for each of two lanes.
class Sse2Lanes {
 public:
  using mask_type = Sse2Mask;

  Sse2Lanes() = default;
  Sse2Lanes(double value) noexcept
      : value_{_mm_set1_pd(value)} {}  // NOLINT(google-explicit-constructor): as of one
  explicit Sse2Lanes(__m128d value) noexcept : value_{value} {}
  template <class Flag>
  Sse2Lanes(const double* from, Flag /*alignment*/) noexcept : value_{_mm_loadu_pd(from)} {}
  /// @p value gives the number of each lane, which it is told as a constant.
  template <class Value>
  requires requires(Value value) { value(std::integral_constant<std::size_t, 0>{}); }
  explicit Sse2Lanes(Value value) noexcept
      : value_{_mm_set_pd(value(std::integral_constant<std::size_t, 1>{}),
                          value(std::integral_constant<std::size_t, 0>{}))} {}

  static constexpr std::size_t size() noexcept { return 2; }
  template <class Flag>
  void copy_to(double* to, Flag /*alignment*/) const noexcept {
    _mm_storeu_pd(to, value_);
  }
  double operator[](std::size_t lane) const noexcept { return value_[lane]; }

  friend Sse2Lanes operator+(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{a.value_ + b.value_};
  }
  friend Sse2Lanes operator-(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{a.value_ - b.value_};
  }
  friend Sse2Lanes operator*(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{a.value_ * b.value_};
  }
  friend Sse2Lanes operator/(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{a.value_ / b.value_};
  }
  Sse2Lanes operator-() const noexcept { return Sse2Lanes{-value_}; }
  friend Sse2Mask operator<(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Mask{_mm_cmplt_pd(a.value_, b.value_)};
  }
  friend Sse2Mask operator>(const Sse2Lanes& a, const Sse2Lanes& b) noexcept { return b < a; }
  friend Sse2Mask operator<=(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Mask{_mm_cmple_pd(a.value_, b.value_)};
  }
  friend Sse2Mask operator>=(const Sse2Lanes& a, const Sse2Lanes& b) noexcept { return b <= a; }
  friend Sse2Mask operator==(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Mask{_mm_cmpeq_pd(a.value_, b.value_)};
  }
  friend Sse2Mask operator!=(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Mask{_mm_cmpneq_pd(a.value_, b.value_)};
  }

  friend Sse2Lanes abs(const Sse2Lanes& a) noexcept { return Sse2Lanes{sign_bits().without(a.value_)}; }
  friend Sse2Lanes sqrt(const Sse2Lanes& a) noexcept { return Sse2Lanes{_mm_sqrt_pd(a.value_)}; }
  friend Sse2Lanes copysign(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{either(sign_bits().without(a.value_), sign_bits().of(b.value_))};
  }
  friend Sse2Lanes floor(const Sse2Lanes& a) noexcept {
    constexpr double kWholeFrom = 4503599627370496.0;  // 2^52: from there on every double is a whole number
    const Sse2Lanes size = abs(a);
    const Sse2Lanes nearest = copysign((size + kWholeFrom) - kWholeFrom, a);
    const Sse2Lanes below = nearest - Sse2Lanes{(nearest > a).of(_mm_set1_pd(1.0))};
    return chosen(size < kWholeFrom, copysign(below, a), a);
  }
  /// @p a where @p mask holds, @p b elsewhere.
  friend Sse2Lanes chosen(const Sse2Mask& mask, const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{either(mask.of(a.value_), mask.without(b.value_))};
  }
  /// @p a where a < b, @p b elsewhere; @p a where a > b, @p b elsewhere.
  friend Sse2Lanes lesser(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{_mm_min_pd(a.value_, b.value_)};
  }
  friend Sse2Lanes greater(const Sse2Lanes& a, const Sse2Lanes& b) noexcept {
    return Sse2Lanes{_mm_max_pd(a.value_, b.value_)};
  }

 private:
  static Sse2Mask sign_bits() noexcept { return Sse2Mask{_mm_set1_pd(-0.0)}; }
  static __m128d either(__m128d a, __m128d b) noexcept {
    return _mm_castsi128_pd(_mm_castpd_si128(a) | _mm_castpd_si128(b));
  }

  __m128d value_;
};

}  // namespace motor
