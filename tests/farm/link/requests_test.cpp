#include "farm/link/requests.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace farm {
namespace {

using namespace std::chrono_literals;

class RequestsTest : public testing::Test {
 protected:
  std::uint64_t add(Requests::Time due, const std::string& name) {
    Link::OnReply on_reply = [this, name](const Link::Reply& reply) {
      told_.push_back(name + ": " + (reply ? *reply : std::string{text_of(reply.error())}));
    };
    return requests_.add(due, on_reply).value();
  }

  Requests requests_;
  std::vector<std::string> told_;
};

using Told = std::vector<std::string>;

TEST_F(RequestsTest, AreAnsweredByTheirNumbersInAnyOrder) {
  const std::uint64_t first = add(1s, "first");
  const std::uint64_t second = add(1s, "second");
  requests_.answer(second, "2");
  requests_.answer(first, "1");
  requests_.answer(first, "again");

  EXPECT_EQ(told_, (Told{"second: 2", "first: 1"}));
  EXPECT_FALSE(requests_.due());
}

TEST_F(RequestsTest, AreTooLateInTheOrderOfTheirTimes) {
  add(2s, "late");
  add(1s, "early");
  EXPECT_EQ(requests_.due(), Requests::Time{1s});
  requests_.advance(1s);
  EXPECT_EQ(requests_.due(), Requests::Time{2s});
  requests_.advance(5s);

  EXPECT_EQ(told_, (Told{"early: no answer in time", "late: no answer in time"}));
}

TEST_F(RequestsTest, AreNotTakenWhileTooManyWait) {
  for (std::size_t i = 0; i < Link::kMostRequests; ++i) add(1s, "one of many");
  Link::OnReply on_reply = [](const Link::Reply&) {};

  EXPECT_FALSE(requests_.add(1s, on_reply));
  EXPECT_TRUE(on_reply);
}

TEST_F(RequestsTest, MayBeAskedAnewByWhoIsToldTheEnd) {
  Link::OnReply on_reply = [this](const Link::Reply&) { add(2s, "anew"); };
  ASSERT_TRUE(requests_.add(1s, on_reply));
  requests_.end(NoReply::Down);

  EXPECT_EQ(told_, Told{});
  EXPECT_EQ(requests_.due(), Requests::Time{2s});
}

}  // namespace
}  // namespace farm
