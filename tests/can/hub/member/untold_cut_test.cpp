#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "can/hub/member/outbox.hpp"
#include "tests/can/hub/running_hub.hpp"

namespace {

using hub_test::BusClient;

/// What was told of the link, and frames that were given or counted, of a member that has not read for a while.
struct Late {
  std::vector<std::uint32_t> told;
  std::size_t frames = 0;
};
Late read_late(BusClient& asleep) {
  Late late;
  std::uint32_t dropped = 0;
  for (auto messages = asleep.take(); !messages.empty(); messages = asleep.take()) {
    for (const auto& message : messages) {
      const std::uint32_t link = message.trailer.flags & (userbus::kLinkDown | userbus::kLinkUp);
      if (link != 0) late.told.push_back(link);
      if (link == 0) ++late.frames;
      dropped = message.trailer.dropped;
    }
    asleep.settle();  // the hub has put into the socket what it had kept
  }
  late.frames += dropped;
  return late;
}

TEST(MemberThatDoesNotRead, LearnsOfCutsAfterwards) {
  hub_test::RunningHub hub;
  constexpr std::uint32_t kFrames = 3 * hub::Outbox::kMessages;
  BusClient sender{hub.path()};
  BusClient raw{hub.path()};
  BusClient port{hub.path(), "vcan0", userbus::Kind::Port};
  for (std::uint32_t i = 0; i < kFrames; ++i) sender.send("123#");
  sender.settle();

  for (const bool up : {false, true, false, true}) hub.set_link(up);

  const Late of_raw = read_late(raw);
  EXPECT_EQ(of_raw.told, std::vector{userbus::kLinkDown});
  EXPECT_EQ(of_raw.frames, kFrames);
  const Late of_port = read_late(port);
  EXPECT_EQ(of_port.told, (std::vector{userbus::kLinkDown, userbus::kLinkUp}));
  EXPECT_EQ(of_port.frames, kFrames);
}

}  // namespace
