#include "motor/identification/model/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

namespace motor {
namespace {

constexpr double kSingular = 1e-10;  // share of the largest pivot that counts as none

template <std::size_t N>
using Vector = Eigen::Matrix<double, static_cast<Eigen::Index>(N), 1>;
template <std::size_t N>
using Square = Eigen::Matrix<double, static_cast<Eigen::Index>(N), static_cast<Eigen::Index>(N)>;

}  // namespace

template <std::size_t N>
void LeastSquares<N>::add(const Values& x, double y) noexcept {
  Vector<kExtended> observation;
  observation << Eigen::Map<const Vector<N>>{x.data()}, y;
  Eigen::Map<Vector<kExtended>>{group_.sum.data()} += observation;
  Eigen::Map<Square<kExtended>>{group_.square.data()}.noalias() += observation * observation.transpose();
  ++group_.count;
}

template <std::size_t N>
void LeastSquares<N>::end_group() noexcept {
  if (group_.count > 0) {
    const Eigen::Map<const Vector<kExtended>> sum{group_.sum.data()};
    Eigen::Map<Square<kExtended>> square{square_.data()};
    square += Eigen::Map<const Square<kExtended>>{group_.square.data()};
    square.noalias() -= (1.0 / group_.count) * sum * sum.transpose();
    count_ += group_.count - 1;
  }
  group_ = {};
}

template <std::size_t N>
auto LeastSquares<N>::solve(const Wanted& wanted) const noexcept -> std::optional<Values> {
  constexpr auto kCount = static_cast<Eigen::Index>(N);
  const Square<kExtended> sums = Eigen::Map<const Square<kExtended>>{square_.data()} +
                                 Eigen::Map<const Square<kExtended>>{group_.square.data()};
  Vector<N> scale = Vector<N>::Zero();
  for (Eigen::Index i = 0; i < kCount; ++i) {
    if (!wanted[static_cast<std::size_t>(i)]) continue;
    if (!(sums(i, i) > 0.0)) return std::nullopt;
    scale[i] = 1.0 / std::sqrt(sums(i, i));
  }
  Square<N> equations = scale.asDiagonal() * sums.template topLeftCorner<kCount, kCount>() * scale.asDiagonal();
  for (Eigen::Index i = 0; i < kCount; ++i)
    if (!wanted[static_cast<std::size_t>(i)]) equations(i, i) = 1.0;
  Eigen::ColPivHouseholderQR<Square<N>> decomposition;
  decomposition.setThreshold(kSingular);
  decomposition.compute(equations);
  if (!decomposition.isInvertible()) return std::nullopt;
  const Vector<N> right = scale.cwiseProduct(sums.template topRightCorner<kCount, 1>());
  const Vector<N> found = scale.cwiseProduct(decomposition.solve(right));
  Values result{};
  std::copy(found.begin(), found.end(), result.begin());
  return result;
}

template class LeastSquares<1>;
template class LeastSquares<2>;
template class LeastSquares<3>;
template class LeastSquares<4>;
template class LeastSquares<5>;

}  // namespace motor
