#include "farm/door/service/host_claim.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

using namespace std::chrono_literals;

TEST(HostClaimTest, WhoComesLaterWaitsUntilTheOtherOneIsGone) {
  HostClaim claim{5};
  EXPECT_TRUE(claim.is_free(0s));

  claim.hear(9, 1s);
  EXPECT_FALSE(claim.is_free(3s));
  EXPECT_TRUE(claim.is_free(3001ms));
}

TEST(HostClaimTest, OfTwoThatHaveTheNameTheOneWithTheLowerNumberKeepsIt) {
  HostClaim claim{5};
  claim.take();

  claim.hear(9, 1s);
  EXPECT_TRUE(claim.is_free(1s));
  claim.hear(4, 1s);
  EXPECT_FALSE(claim.is_free(1s));
}

TEST(HostClaimTest, ItsOwnBeatIsNoOtherDoor) {
  HostClaim claim{5};

  claim.hear(5, 1s);

  EXPECT_TRUE(claim.is_free(1s));
}

}  // namespace
}  // namespace farm
