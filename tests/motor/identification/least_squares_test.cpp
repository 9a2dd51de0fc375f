#include "motor/identification/model/least_squares.hpp"

#include <gtest/gtest.h>

namespace motor {
namespace {

TEST(LeastSquares, FindsTheCoefficientsOfALine) {
  LeastSquares<2> line;
  for (const double x : {-1.0, 0.0, 2.0, 5.0}) line.add({1.0, x}, 3.0 - 2.0 * x);

  const auto found = line.solve();

  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 3.0, 1e-12);
  EXPECT_NEAR((*found)[1], -2.0, 1e-12);
  EXPECT_EQ(line.count(), 4);
}

TEST(LeastSquares, LetsEachGroupHaveAConstantOfItsOwn) {
  LeastSquares<2> shaft;
  for (const double constant : {100.0, -7.0, 3.0}) {
    for (const double x : {1.0, 2.0, 4.0}) shaft.add({x, x * x}, constant + 0.5 * x + 0.25 * x * x);
    shaft.end_group();
  }

  const auto found = shaft.solve();

  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 0.5, 1e-10);
  EXPECT_NEAR((*found)[1], 0.25, 1e-10);
  EXPECT_EQ(shaft.count(), 6);
}

TEST(LeastSquares, LeavesOutWhatIsNotWanted) {
  LeastSquares<3> some;
  for (const double x : {1.0, 2.0, 4.0}) some.add({x, x, 1.0}, 5.0 * x + 1.0);

  EXPECT_FALSE(some.solve()) << "two columns are alike";
  const auto found = some.solve({true, false, true});

  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 5.0, 1e-10);
  EXPECT_EQ((*found)[1], 0.0);
  EXPECT_NEAR((*found)[2], 1.0, 1e-10);
}

TEST(LeastSquares, KnowsThatACoefficientIsToldByTheOthersHoweverTheyAreScaled) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    LeastSquares<3> shaft;
    for (int i = 0; i < 50; ++i) {
      const double x = 0.1 * i;
      shaft.add({x, scale * (2.0 * x - 1.0), 1.0}, 3.0 * x);
    }

    EXPECT_FALSE(shaft.solve()) << scale;
    const auto found = shaft.solve({true, false, true});
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found)[0], 3.0, 1e-9) << scale;
  }
}

TEST(LeastSquares, KnowsNothingFromNothing) {
  LeastSquares<2> nothing;
  nothing.end_group();

  EXPECT_FALSE(nothing.solve());
  EXPECT_EQ(nothing.count(), 0);
}

TEST(LeastSquares, BalancesErrorsOfTheObservations) {
  LeastSquares<1> mean;
  for (const double y : {1.0, 2.0, 6.0}) mean.add({1.0}, y);

  const auto found = mean.solve();

  ASSERT_TRUE(found);
  EXPECT_NEAR((*found)[0], 3.0, 1e-12);
}

}  // namespace
}  // namespace motor
