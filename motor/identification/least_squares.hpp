#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace motor {

/// Linear least squares of y = sum of c_i x_i over observations that are taken in one by one and not kept.
template <std::size_t N>
class LeastSquares {
 public:
  using Row = std::array<double, N>;
  /// Which coefficients are looked for; the others are 0.
  using Wanted = std::array<bool, N>;

  /// Takes in that @p row gave @p y.
  void add(const Row& row, double y) noexcept {
    const Extended values = extended(row, y);
    for (std::size_t i = 0; i <= N; ++i) {
      group_.sum[i] += values[i];
      for (std::size_t j = 0; j <= N; ++j) group_.square[i][j] += values[i] * values[j];
    }
    ++group_.count;
  }
  /// What was added since the last call had an unknown constant of its own.
  void end_group() noexcept {
    if (group_.count > 0) {
      const double share = 1.0 / group_.count;
      for (std::size_t i = 0; i <= N; ++i)
        for (std::size_t j = 0; j <= N; ++j)
          square_[i][j] += group_.square[i][j] - share * group_.sum[i] * group_.sum[j];
      count_ += group_.count - 1;
    }
    group_ = {};
  }
  /// Observations that count.
  int count() const noexcept { return count_ + group_.count; }
  /// The coefficients, unless what was observed does not tell them.
  std::optional<Row> solve(const Wanted& wanted = all()) const noexcept {
    Extended scale{};
    Matrix equations{};
    for (std::size_t i = 0; i < N; ++i) {
      const double own = square_[i][i] + group_.square[i][i];
      if (wanted[i] && !(own > 0.0)) return std::nullopt;
      scale[i] = wanted[i] ? 1.0 / std::sqrt(own) : 0.0;
    }
    scale[N] = 1.0;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j <= N; ++j)
        equations[i][j] = scale[i] * scale[j] * (square_[i][j] + group_.square[i][j]);
      if (!wanted[i]) equations[i][i] = 1.0;
    }
    if (!eliminate(equations)) return std::nullopt;
    return back_substituted(equations, scale);
  }

 private:
  using Extended = std::array<double, N + 1>;  // y last
  using Matrix = std::array<Extended, N + 1>;

  struct Group {
    Extended sum{};
    Matrix square{};
    int count = 0;
  };

  static constexpr double kSingular = 1e-10;  // pivot of equations whose diagonal was 1

  static constexpr Wanted all() noexcept {
    Wanted wanted{};
    wanted.fill(true);
    return wanted;
  }
  static Extended extended(const Row& row, double y) noexcept {
    Extended values{};
    std::copy(row.begin(), row.end(), values.begin());
    values[N] = y;
    return values;
  }
  /// To a triangle, by the largest pivots.
  static bool eliminate(Matrix& equations) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
      std::size_t best = i;
      for (std::size_t k = i + 1; k < N; ++k)
        if (std::abs(equations[k][i]) > std::abs(equations[best][i])) best = k;
      std::swap(equations[i], equations[best]);
      if (!(std::abs(equations[i][i]) > kSingular)) return false;
      for (std::size_t k = i + 1; k < N; ++k) subtract(equations[k], equations[i], i);
    }
    return true;
  }
  static void subtract(Extended& from, const Extended& pivot, std::size_t column) noexcept {
    const double factor = from[column] / pivot[column];
    for (std::size_t j = column; j <= N; ++j) from[j] -= factor * pivot[j];
  }
  static Row back_substituted(const Matrix& equations, const Extended& scale) noexcept {
    Row result{};
    for (std::size_t i = N; i-- > 0;) {
      double rest = equations[i][N];
      for (std::size_t j = i + 1; j < N; ++j) rest -= equations[i][j] * result[j];
      result[i] = rest / equations[i][i];
    }
    for (std::size_t i = 0; i < N; ++i) result[i] *= scale[i];
    return result;
  }

  Group group_{};
  Matrix square_{};
  int count_ = 0;
};

}  // namespace motor
