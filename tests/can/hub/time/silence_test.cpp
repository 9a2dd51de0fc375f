#include <csignal>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/can/hub/time/clock_program.hpp"
#include "tests/can/hub/time/hub_with_turns.hpp"

namespace hub_test {
namespace {

using namespace std::chrono_literals;
using userbus::kNoInstant;
using userbus::TimeMessage;

TEST(Silence, OfWhoActsEndsItsTurnUntilItSpeaksAgain) {
  HubWithTurns hub{userbus::TimeMode::Virtual, 100ms};
  ClockProgram silent{hub.path()}, other{hub.path()};
  const std::string number = std::to_string(silent.process());
  silent.join();
  ASSERT_EQ(silent.turn(), 0);
  other.join();
  silent.signal(SIGSTOP);

  ASSERT_EQ(other.turn(), 0);
  EXPECT_THAT(hub.notices(),
              testing::StartsWith("the time of the bus has waited 0.1 s for hub_time_test (process " + number +
                                  "), which is stopped: it goes on without it\n"));
  silent.signal(SIGCONT);
  silent.wait(0, 3000);
  other.wait(0, kNoInstant);
  EXPECT_GE(silent.turn(), 0);
  EXPECT_THAT(hub.notices(),
              testing::HasSubstr("process " + number + " takes part in the time of the bus again\n"));
}

/// What @p client, a member of kind Clock, has been refused.
std::uint64_t refused_of(const BusClient& client) {
  const userbus::Answer answer = client.ask(userbus::Operation::Statistics);
  userbus::MemberStatistics row{};
  EXPECT_GE(answer.size, sizeof(userbus::BusStatistics) + sizeof row);
  std::memcpy(&row, &client.reply()[sizeof(userbus::BusStatistics)], sizeof row);
  return row.refused;
}

void say(const BusClient& client, TimeMessage::Word word, std::int32_t process = 0) {
  TimeMessage message{};
  message.word = word;
  message.process = process;
  client.send_bytes(std::as_bytes(std::span{&message, 1}));
}

TEST(TimeMessages, ThatAreMalformedAreCountedAndDropped) {
  const HubWithTurns hub;
  const BusClient client{hub.path(), "", userbus::Kind::Clock};
  const can_frame frame{};
  const userbus::FrameMessage with_trailer{};
  client.send(frame);
  client.send_bytes(std::as_bytes(std::span{&with_trailer, 1}));
  say(client, TimeMessage::Word{77});
  say(client, TimeMessage::Word::Wait);
  say(client, TimeMessage::Word::Want);
  say(client, TimeMessage::Word::Join, -1);
  EXPECT_EQ(refused_of(client), 6U);

  say(client, TimeMessage::Word::Join, getpid());
  say(client, TimeMessage::Word::Wait);  // its turn has not come: this is read before
  say(client, TimeMessage::Word::Want);
  EXPECT_LE(refused_of(client), 7U);
}

TEST(TimeMessages, MeanNothingToABusWithTheTimeOfTheMachine) {
  const RunningHub hub;
  const BusClient client{hub.path(), "", userbus::Kind::Clock};
  say(client, TimeMessage::Word::Join, getpid());
  EXPECT_EQ(refused_of(client), 1U);
  errno = ENOENT;
  EXPECT_EQ(userbus::map_time(client.descriptor()), nullptr);
  EXPECT_EQ(errno, 0);
}

}  // namespace
}  // namespace hub_test
