#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace motor {

/// Linear least squares of y = sum of c_i x_i over observations that are taken in one by one and not kept. N is 1
/// to 5: least_squares.cpp, which keeps the linear algebra to itself, has these.
template <std::size_t N>
class LeastSquares {
 public:
  using Values = std::array<double, N>;
  /// Which coefficients are looked for; the others are 0.
  using Wanted = std::array<bool, N>;

  /// Takes in that @p x gave @p y.
  void add(const Values& x, double y) noexcept;
  /// What was added since the last call had an unknown constant of its own.
  void end_group() noexcept;
  /// Observations that count.
  int count() const noexcept { return count_ + group_.count; }
  /// The coefficients, unless what was observed does not tell them: the normal equations, scaled to a diagonal of
  /// 1, have to be of full rank.
  std::optional<Values> solve(const Wanted& wanted = all()) const noexcept;

 private:
  static constexpr std::size_t kExtended = N + 1;  // the coefficients, and y last
  using Extended = std::array<double, kExtended>;
  using Matrix = std::array<double, kExtended * kExtended>;

  /// Observations with a constant in common.
  struct Group {
    Extended sum{};
    Matrix square{};
    int count = 0;
  };

  static constexpr Wanted all() noexcept {
    Wanted wanted{};
    wanted.fill(true);
    return wanted;
  }

  Group group_{};
  Matrix square_{};
  int count_ = 0;
};

extern template class LeastSquares<1>;
extern template class LeastSquares<2>;
extern template class LeastSquares<3>;
extern template class LeastSquares<4>;
extern template class LeastSquares<5>;

}  // namespace motor
