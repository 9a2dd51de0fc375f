#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/QR>

namespace motor {

/// Linear least squares of y = sum of c_i x_i over observations that are taken in one by one and not kept.
template <std::size_t N>
class LeastSquares {
 public:
  using Values = std::array<double, N>;
  /// Which coefficients are looked for; the others are 0.
  using Wanted = std::array<bool, N>;

  /// Takes in that @p x gave @p y.
  void add(const Values& x, double y) noexcept {
    Extended observation;
    observation << Eigen::Map<const Coefficients>{x.data()}, y;
    group_.sum += observation;
    group_.square.noalias() += observation * observation.transpose();
    ++group_.count;
  }
  /// What was added since the last call had an unknown constant of its own.
  void end_group() noexcept {
    if (group_.count > 0) {
      square_ += group_.square;
      square_.noalias() -= (1.0 / group_.count) * group_.sum * group_.sum.transpose();
      count_ += group_.count - 1;
    }
    group_ = {};
  }
  /// Observations that count.
  int count() const noexcept { return count_ + group_.count; }
  /// The coefficients, unless what was observed does not tell them: the normal equations, scaled to a diagonal of
  /// 1, have to be of full rank.
  std::optional<Values> solve(const Wanted& wanted = all()) const noexcept {
    const Matrix sums = square_ + group_.square;
    Coefficients scale = Coefficients::Zero();
    for (Eigen::Index i = 0; i < kCount; ++i) {
      if (!wanted[static_cast<std::size_t>(i)]) continue;
      if (!(sums(i, i) > 0.0)) return std::nullopt;
      scale[i] = 1.0 / std::sqrt(sums(i, i));
    }
    Equations equations = scale.asDiagonal() * sums.template topLeftCorner<kCount, kCount>() * scale.asDiagonal();
    for (Eigen::Index i = 0; i < kCount; ++i)
      if (!wanted[static_cast<std::size_t>(i)]) equations(i, i) = 1.0;
    Eigen::ColPivHouseholderQR<Equations> decomposition;
    decomposition.setThreshold(kSingular);
    decomposition.compute(equations);
    if (!decomposition.isInvertible()) return std::nullopt;
    const Coefficients right = scale.cwiseProduct(sums.template topRightCorner<kCount, 1>());
    const Coefficients found = scale.cwiseProduct(decomposition.solve(right));
    Values result{};
    std::copy(found.begin(), found.end(), result.begin());
    return result;
  }

 private:
  static constexpr Eigen::Index kCount = N;
  using Coefficients = Eigen::Matrix<double, kCount, 1>;
  using Equations = Eigen::Matrix<double, kCount, kCount>;
  using Extended = Eigen::Matrix<double, kCount + 1, 1>;  // y last
  using Matrix = Eigen::Matrix<double, kCount + 1, kCount + 1>;

  /// Observations with a constant in common.
  struct Group {
    Extended sum = Extended::Zero();
    Matrix square = Matrix::Zero();
    int count = 0;
  };

  static constexpr double kSingular = 1e-10;  // share of the largest pivot that counts as none

  static constexpr Wanted all() noexcept {
    Wanted wanted{};
    wanted.fill(true);
    return wanted;
  }

  Group group_{};
  Matrix square_ = Matrix::Zero();
  int count_ = 0;
};

}  // namespace motor
