#include "can/hub/medium/medium.hpp"

#include <gtest/gtest.h>

#include "tests/can/hub/told.hpp"

namespace {

using canopen::kNever;
using hub::Medium;
using hub::Passage;
using told::kStart;
using told::Listener;
using told::passage;
using Texts = std::vector<std::string>;

TEST(Medium, GivesAFrameToAllAtOnce) {
  Medium medium;
  Listener a, b;
  medium.attach(a);
  medium.attach(b);

  EXPECT_TRUE(medium.send(passage(a, "123#01"), kStart));

  EXPECT_EQ(a.seen, Texts{"123#01"});
  EXPECT_EQ(b.seen, Texts{"123#01"});
  EXPECT_EQ(b.passages[0].sender, &a);
  EXPECT_GT(b.passages[0].time_ns, 0);
  EXPECT_EQ(medium.passed(), 1u);
  EXPECT_EQ(medium.next_deadline(), kNever);
}

TEST(Medium, ShowsAllTheSameOrderWhenOneAnswersWithinReceive) {
  Medium medium;
  Listener first, answering, last;
  for (Listener* each : {&first, &answering, &last}) medium.attach(*each);
  answering.at_frame = [&](const Passage& seen) {
    if (told::text_of(seen.frame) == "705#R") medium.send(passage(answering, "705#05"), kStart);
  };

  medium.send(passage(first, "705#R"), kStart);

  EXPECT_EQ(first.seen, (Texts{"705#R", "705#05"}));
  EXPECT_EQ(answering.seen, first.seen);
  EXPECT_EQ(last.seen, first.seen);
}

TEST(Medium, RefusesWhatDoesNotFitTheQueueAndTellsWhenThereIsRoom) {
  Medium medium;
  Listener flooding;
  medium.attach(flooding);
  unsigned accepted = 0;
  flooding.at_frame = [&](const Passage& seen) {
    if (told::text_of(seen.frame) != "001#") return;
    while (medium.send(passage(flooding, "002#"), kStart)) ++accepted;
  };

  medium.send(passage(flooding, "001#"), kStart);

  EXPECT_EQ(accepted, Medium::kQueue);
  EXPECT_EQ(flooding.rooms, 1u);
  EXPECT_EQ(flooding.seen.size(), 1 + Medium::kQueue);
}

TEST(Medium, ReturnsFromTwoThatAnswerEachOtherForEver) {
  Medium medium;
  Listener ping, pong;
  medium.attach(ping);
  medium.attach(pong);
  ping.at_frame = [&](const Passage& seen) {
    if (seen.sender != &ping) medium.send(passage(ping, "001#"), kStart);
  };
  pong.at_frame = [&](const Passage& seen) {
    if (seen.sender != &pong) medium.send(passage(pong, "002#"), kStart);
  };

  medium.send(passage(ping, "001#"), kStart);
  const std::uint64_t passed = medium.passed();

  EXPECT_EQ(medium.next_deadline(), kStart);  // there is more to do
  medium.on_time(kStart);
  EXPECT_GT(medium.passed(), passed);
}

TEST(Medium, LetsAParticipantLeaveFromWithinReceive) {
  Medium medium;
  Listener first, second, third;
  for (Listener* each : {&first, &second, &third}) medium.attach(*each);
  first.at_frame = [&](const Passage&) {
    medium.detach(first);
    medium.detach(second);
  };

  medium.send(passage(third, "001#"), kStart);
  medium.send(passage(third, "002#"), kStart);

  EXPECT_EQ(first.seen, Texts{"001#"});
  EXPECT_EQ(second.seen, Texts{});
  EXPECT_EQ(third.seen, (Texts{"001#", "002#"}));
}

TEST(Medium, GivesNobodyThePlaceOfOneThatLeavesWhileAFramePasses) {
  for (const std::size_t count : {3U, 70U, 200U}) {
    Medium medium;
    std::vector<Listener> all(count);
    Listener guest;
    for (Listener& each : all) medium.attach(each);
    all.front().at_frame = [&](const Passage& seen) {
      if (told::text_of(seen.frame) != "001#") return;
      medium.detach(all.back());
      medium.attach(guest);
    };

    medium.send(passage(all[1], "001#"), kStart);
    medium.send(passage(all[1], "002#"), kStart);

    EXPECT_EQ(guest.seen, Texts{"002#"}) << count;
    EXPECT_EQ(all.back().seen, Texts{}) << count;
    EXPECT_EQ(all[count - 2].seen, (Texts{"001#", "002#"})) << count;
  }
}

TEST(Medium, NamesNoSenderThatHasLeftWhileItsFramePasses) {
  Medium medium;
  Listener sender, receiver;
  medium.attach(sender);
  medium.attach(receiver);
  sender.at_frame = [&](const Passage&) { medium.detach(sender); };

  medium.send(passage(sender, "001#"), kStart);

  ASSERT_EQ(receiver.passages.size(), 1u);
  EXPECT_EQ(receiver.passages[0].sender, nullptr);
}

TEST(Medium, ShowsAFrameNotToWhoComesWhileItPasses) {
  Medium medium;
  Listener host, guest;
  medium.attach(host);
  host.at_frame = [&](const Passage& seen) {
    if (told::text_of(seen.frame) == "001#") medium.attach(guest);
  };

  medium.send(passage(host, "001#"), kStart);
  medium.send(passage(host, "002#"), kStart);

  EXPECT_EQ(guest.seen, Texts{"002#"});
}

}  // namespace
