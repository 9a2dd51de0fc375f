// Several frames in one message, in both directions.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/can/hub/bus_client.hpp"
#include "tests/can/hub/old_hub.hpp"
#include "tests/can/port/user_bus/user_bus_fixture.hpp"

namespace bus {
namespace {

using Texts = std::vector<std::string>;

/// @p count frames that are told apart by their data.
Texts numbered(unsigned count) {
  Texts texts;
  for (unsigned i = 0; i < count; ++i) texts.push_back("181#" + std::to_string(100'000 + i));
  return texts;
}

std::vector<canopen::Frame> frames_of(const Texts& texts) {
  std::vector<canopen::Frame> frames;
  for (const std::string& text : texts) frames.push_back(fakes::frame_of(text));
  return frames;
}

TEST_F(UserBusTest, HandsOverAnyNumberOfFramesInTheirOrder) {
  UserBus master{path()};
  UserBus drive{path()};
  hub_test::BusClient old{path()};
  const Texts texts = numbered(100);
  ASSERT_TRUE(master.sends_together());

  const SentMany sent = master.send_all(frames_of(texts));

  EXPECT_EQ(sent.count, texts.size());
  EXPECT_EQ(sent.status, SendStatus::Sent);
  for (const std::string& text : texts) ASSERT_EQ(next(drive), text) << "each is shown by the descriptor";
  EXPECT_TRUE(is_quiet(drive));
  EXPECT_FALSE(drive.has_frames());
  for (const std::string& text : texts) ASSERT_EQ(old.wait_frame(), text);
}

TEST_F(UserBusTest, ForgetsTheRestOfAMessageToo) {
  UserBus master{path()};
  UserBus drive{path()};
  ASSERT_EQ(master.send_all(frames_of(numbered(3))).count, 3u);
  ASSERT_EQ(next(drive), numbered(1)[0]);
  ASSERT_TRUE(drive.has_frames());

  EXPECT_TRUE(drive.reopen());

  EXPECT_TRUE(is_quiet(drive));
  send(master, "002#");
  EXPECT_EQ(next(drive), "002#");
}

TEST_F(UserBusTest, DeliversTheRestOfAMessageBeforeItTellsThatTheHubHasGone) {
  start_hub();
  UserBus master{path()};
  UserBus drive{path()};
  ASSERT_EQ(master.send_all(frames_of(numbered(3))).count, 3u);
  ASSERT_EQ(next(drive), numbered(1)[0]);

  kill_hub();

  EXPECT_EQ(next(drive), numbered(3)[1]);
  EXPECT_EQ(next(drive), numbered(3)[2]);
  EXPECT_EQ(next(drive), "down");
  EXPECT_TRUE(is_quiet(drive));
}

TEST_F(UserBusTest, TakesNoMoreThanTheSocketHasRoomFor) {
  start_hub();
  UserBus master{path()};
  UserBus drive{path()};
  hub_->signal(SIGSTOP);
  const Texts texts = numbered(1'000'000);
  SentMany sent;
  std::size_t all = 0;
  while (sent.status == SendStatus::Sent && all < texts.size()) {
    const Texts some{texts.begin() + static_cast<std::ptrdiff_t>(all),
                     texts.begin() + static_cast<std::ptrdiff_t>(all + 100)};
    sent = master.send_all(frames_of(some));
    all += sent.count;
  }
  hub_->signal(SIGCONT);

  EXPECT_EQ(sent.status, SendStatus::Full);
  ASSERT_GT(all, 0u);
  for (std::size_t i = 0; i < all; ++i) ASSERT_EQ(next(drive), texts[i]) << "none is there twice, or missing";
  EXPECT_TRUE(is_quiet(drive));
}

TEST_F(UserBusTest, SendsOneFrameAtATimeWhereFramesTakeTime) {
  start_hub({"--bitrate", "1000000"});
  UserBus master{path()};
  UserBus drive{path()};
  EXPECT_FALSE(master.sends_together());

  EXPECT_EQ(master.send_all(frames_of(numbered(5))).count, 5u);

  for (const std::string& text : numbered(5)) EXPECT_EQ(next(drive), text);
}

TEST_F(UserBusTest, SendsOneFrameAtATimeToAHubThatKnowsNothingElse) {
  hub_test::OldHub hub;
  {
    UserBus drive{hub.path()};
    EXPECT_FALSE(drive.sends_together());
    EXPECT_EQ(drive.send_all(frames_of(numbered(3))).count, 3u);
  }
  hub.finish();

  EXPECT_EQ(hub.sizes(), (std::vector<std::size_t>{16, 16, 16}));
}

}  // namespace
}  // namespace bus
