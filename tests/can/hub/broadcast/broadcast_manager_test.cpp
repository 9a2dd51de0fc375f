#include <cerrno>

#include "tests/can/hub/broadcast/broadcast_fixture.hpp"

namespace {

class BroadcastManager : public told::BroadcastFixture {};

TEST_F(BroadcastManager, SendsOneFrameAtOnce) {
  EXPECT_EQ(ask({.opcode = TX_SEND, .frames = {"705#R"}}), 0);

  EXPECT_EQ(sent(), Texts{"705#R"});
  EXPECT_EQ(other.passages.back().sender, &manager);
  EXPECT_EQ(other.passages.back().interface_index, kIndex);
}

TEST_F(BroadcastManager, SaysThatTheBusHasNoRoom) {
  hub::Medium slow{10'000};
  hub::BroadcastManager on_slow{slow, told};
  const auto send = told::message({.opcode = TX_SEND, .frames = {"123#01"}});
  int error = 0;
  for (std::size_t i = 0; i < hub::Medium::kQueue + 1; ++i) EXPECT_EQ(on_slow.request(send, kIndex, now), 0);

  error = on_slow.request(send, kIndex, now);

  EXPECT_EQ(error, ENOBUFS);
}

TEST_F(BroadcastManager, NeedsAnInterface) {
  EXPECT_EQ(manager.request(told::message({.opcode = TX_SETUP, .frames = {"123#"}}), 0, now), ENODEV);
  EXPECT_EQ(manager.request(told::message({.opcode = TX_SEND, .frames = {"123#"}}), 0, now), ENODEV);
}

TEST_F(BroadcastManager, RefusesWhatIsMalformed) {
  const auto complete = told::message({.opcode = TX_SETUP, .id = "123", .frames = {"123#"}});
  const std::span bytes{complete};
  EXPECT_EQ(manager.request({}, kIndex, now), EINVAL);
  EXPECT_EQ(manager.request(bytes.first(sizeof(bcm_msg_head) - 1), kIndex, now), EINVAL);
  EXPECT_EQ(manager.request(bytes.first(bytes.size() - 1), kIndex, now), EINVAL);
  EXPECT_EQ(manager.request(bytes.first(sizeof(bcm_msg_head)), kIndex, now), EFAULT);

  EXPECT_EQ(ask({.opcode = 0, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_STATUS, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = RX_CHANGED + 1, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123"}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = Texts(257, "123#")}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .flags = CAN_FD_FRAME, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SEND, .frames = {"123#", "123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SEND}), EINVAL);
  EXPECT_EQ(sent(), Texts{});
  EXPECT_EQ(ask({.opcode = TX_READ, .id = "123"}), EINVAL);  // nothing of it was kept
}

TEST_F(BroadcastManager, RefusesADataLengthAboveEight) {
  auto bytes = told::message({.opcode = TX_SETUP, .id = "123", .frames = {"123#"}});
  bytes[sizeof(bcm_msg_head) + offsetof(can_frame, can_dlc)] = std::byte{9};

  EXPECT_EQ(manager.request(bytes, kIndex, now), EINVAL);
  reinterpret_cast<bcm_msg_head*>(bytes.data())->opcode = TX_SEND;
  EXPECT_EQ(manager.request(bytes, kIndex, now), EINVAL);
}

TEST_F(BroadcastManager, RefusesIntervalsThatAreNoneButOnlyIfTheyAreUsed) {
  for (const bcm_timeval wrong : {bcm_timeval{-1, 0}, {0, -1}, {0, 1'000'000}, {400L * 86'400 + 1, 0}}) {
    auto bytes = told::message({.opcode = TX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#"}});
    auto* const head = reinterpret_cast<bcm_msg_head*>(bytes.data());
    head->ival2 = wrong;
    EXPECT_EQ(manager.request(bytes, kIndex, now), EINVAL) << wrong.tv_sec << " s " << wrong.tv_usec << " us";
    head->flags = 0;
    EXPECT_EQ(manager.request(bytes, kIndex, now), 0);
  }
}

TEST_F(BroadcastManager, HoldsNoMoreOperationsThanAllowed) {
  char id[16];
  for (unsigned i = 0; i < hub::BroadcastManager::kMostOperations; ++i) {
    std::snprintf(id, sizeof id, "%08X", i);
    ASSERT_EQ(ask({.opcode = i % 2 == 0 ? TX_SETUP : RX_SETUP, .id = id, .frames = {"123#"}}), 0);
  }

  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "7FF", .frames = {"123#"}}), ENOMEM);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "00000000", .frames = {"123#"}}), 0);
}

TEST_F(BroadcastManager, RefusesFewerFiltersThanItNames) {
  auto bytes = told::message({.opcode = RX_SETUP, .id = "123", .frames = {"123#FF"}});
  reinterpret_cast<bcm_msg_head*>(bytes.data())->nframes = 2;

  EXPECT_EQ(manager.request(bytes, kIndex, now), EFAULT);
  EXPECT_EQ(ask({.opcode = RX_DELETE, .id = "123"}), EINVAL);
}

TEST_F(BroadcastManager, SurvivesRandomMessages) {
  const unsigned seed = told::seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random{seed};
  const auto below = [&](unsigned limit) { return static_cast<std::uint32_t>(random() % limit); };
  for (int i = 0; i < 20'000; ++i) {
    std::vector<std::byte> bytes = told::message({.opcode = below(14),
                                                  .id = random() % 2 == 0 ? "123" : "123#R",
                                                  .flags = below(0x800),
                                                  .frames = Texts(below(4), "123#0102"),
                                                  .count = below(3),
                                                  .first = std::chrono::microseconds{below(3) * 1000},
                                                  .second = std::chrono::microseconds{below(3) * 1000}});
    if (random() % 8 == 0) bytes.resize(random() % (bytes.size() + 1));
    if (random() % 8 == 0 && !bytes.empty()) bytes[random() % bytes.size()] = static_cast<std::byte>(random());
    manager.request(bytes, random() % 4 == 0 ? 0 : kIndex, now);
    arrive(random() % 2 == 0 ? "123#01" : "123#R");
    now += std::chrono::microseconds{below(2000)};
    medium.on_time(now);
    manager.on_time(now);
  }
  EXPECT_GT(told.texts.size(), 1000u);
}

}  // namespace
