// What Eigen would take from the heap becomes an assertion, and assertions are counted here, in optimised builds
// too.
#define EIGEN_RUNTIME_NO_MALLOC
namespace {
int& broken_assertions() {
  static int count = 0;
  return count;
}
}  // namespace
#define eigen_assert(condition) ((condition) ? void() : void(++broken_assertions()))

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "motor/identification/model/least_squares.hpp"
#include "motor/plant/machine/thermal.hpp"

namespace motor {
namespace {

/// Eigen may not allocate while one of these exists.
class NoMalloc {
 public:
  NoMalloc() {
    broken_assertions() = 0;
    Eigen::internal::set_is_malloc_allowed(false);
  }
  ~NoMalloc() { Eigen::internal::set_is_malloc_allowed(true); }
  NoMalloc(const NoMalloc&) = delete;
  NoMalloc& operator=(const NoMalloc&) = delete;
};

template <std::size_t N>
void fit() {
  LeastSquares<N> squares;
  for (std::size_t n = 0; n < 3 * N; ++n) {
    typename LeastSquares<N>::Values x{};
    for (std::size_t i = 0; i < N; ++i) x[i] = static_cast<double>((n * n + 3 * i * n + i) % 11);
    squares.add(x, static_cast<double>(n));
    if (n + 1 == 2 * N) squares.end_group();
  }
  EXPECT_TRUE(squares.solve()) << N;
}

TEST(FixedSizes, OfLeastSquaresTakeNoMemory) {
  const NoMalloc none;

  fit<1>();
  fit<2>();
  fit<4>();
  fit<5>();

  EXPECT_EQ(broken_assertions(), 0);
}

TEST(FixedSizes, OfTheThermalModelTakeNoMemory) {
  const NoMalloc none;
  MotorThermal thermal{{.winding_capacity = 500.0,
                        .frame_capacity = 5000.0,
                        .winding_to_frame = 5.0,
                        .frame_to_ambient = 2.0,
                        .ambient = 20.0}};

  for (const double dt : {125e-6, 1.0, 1e5}) thermal.step(dt, 100.0, 20.0);

  EXPECT_EQ(broken_assertions(), 0);
}

TEST(FixedSizes, AreToldFromOthers) {
  const NoMalloc none;

  const Eigen::MatrixXd grown = Eigen::MatrixXd::Identity(3, 3);

  EXPECT_GT(broken_assertions(), 0);
  EXPECT_EQ(grown.rows(), 3);
}

}  // namespace
}  // namespace motor

// With the assertions of this file.
#include "motor/identification/model/least_squares.cpp"
#include "motor/plant/machine/thermal.cpp"
