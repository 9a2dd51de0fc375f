#include <cstring>

#include <gtest/gtest.h>
#include <poll.h>

#include "can/userbus/request.hpp"
#include "tests/can/hub/time/clock_program.hpp"
#include "tests/can/hub/time/hub_with_turns.hpp"

namespace hub_test {
namespace {

using userbus::Operation;
using userbus::TimeMode;

/// Somebody who has time go on, while it waits.
class Step {
 public:
  Step(const BusClient& client, std::int64_t time)
      : reply_{userbus::post(client.descriptor(), Operation::Step, 0, &time, sizeof time)} {}

  /// Waits for the answer: the present since the first instant, or the error less zero.
  [[nodiscard]] std::int64_t answer() const {
    pollfd wanted{reply_.get(), POLLIN, 0};
    poll(&wanted, 1, 20'000);
    std::int64_t present = 0;
    const userbus::Answer answer = userbus::take_reply(reply_.get(), &present, sizeof present);
    return answer.error != 0 ? -answer.error : present - userbus::kFirstInstant;
  }

 private:
  os::Descriptor reply_;
};

class SteppedTime : public testing::Test {
 protected:
  HubWithTurns hub{TimeMode::Stepped};
  BusClient client{hub.path(), "", userbus::Kind::Port};
  ClockProgram program{hub.path()};
};

TEST_F(SteppedTime, GoesOnAsFarAsItIsLet) {
  program.join();
  ASSERT_EQ(program.turn(), 0);
  EXPECT_EQ(program.last().horizon_ns, 0);
  program.wait(0, 10'000);
  EXPECT_EQ((Step{client, 4000}.answer()), 4000);
  EXPECT_FALSE(program.has_turn());

  const Step second{client, 6000};
  ASSERT_EQ(program.turn(), 10'000);
  program.wait(10'000, 15'000);
  EXPECT_EQ(second.answer(), 10'000);
}

TEST_F(SteppedTime, AnswersEachAtItsOwnInstant) {
  program.join();
  ASSERT_EQ(program.turn(), 0);
  const Step longer{client, 9000}, shorter{client, 2000}, none{client, 0};
  program.wait(0, 5000);
  EXPECT_EQ(none.answer(), 0);
  EXPECT_EQ(shorter.answer(), 2000);
  ASSERT_EQ(program.turn(), 5000);
  EXPECT_EQ(program.last().horizon_ns, 9000);
  program.wait(5000, 50'000);
  EXPECT_EQ(longer.answer(), 9000);
}

TEST_F(SteppedTime, ForgetsWhoHasGone) {
  program.join();
  ASSERT_EQ(program.turn(), 0);
  { const Step gone{client, 1'000'000}; }
  const Step other{client, 1000};
  program.wait(0, 5000);
  EXPECT_EQ(other.answer(), 1000);
  EXPECT_EQ((Step{client, 0}.answer()), 1000);
  EXPECT_FALSE(program.has_turn());
}

TEST_F(SteppedTime, GoesOnWithoutPrograms) {
  EXPECT_EQ((Step{client, 1'000'000'000}.answer()), 1'000'000'000);
  program.join(userbus::kDevice);
  EXPECT_EQ(program.turn(), 1'000'000'000);
}

TEST_F(SteppedTime, RefusesStepsBackAndOfOtherBuses) {
  EXPECT_EQ((Step{client, -1}.answer()), -EINVAL);
  const HubWithTurns other;
  const BusClient stranger{other.path(), "", userbus::Kind::Port};
  EXPECT_EQ((Step{stranger, 1000}.answer()), -EOPNOTSUPP);
  const RunningHub real;
  const BusClient usual{real.path(), "", userbus::Kind::Port};
  EXPECT_EQ((Step{usual, 1000}.answer()), -EOPNOTSUPP);
}

TEST_F(SteppedTime, GoesOnByARequestBehindFramesThatTheBusHasNoRoomFor) {
  // The hub takes 18, and the socket has room for 16; who has once waited for room is woken when three quarters
  // are free.
  constexpr int kPortion = 9, kLeft = 12;
  const BusClient sender{hub.path()};
  for (int portion = 0; portion < 2; ++portion) {
    for (int i = 0; i < kPortion; ++i) sender.send("123#");
    sender.settle();
  }
  for (int i = 0; i < kLeft; ++i) sender.send("123#");

  EXPECT_EQ(Step(sender, 50'000'000).answer(), 50'000'000);
}

}  // namespace
}  // namespace hub_test
