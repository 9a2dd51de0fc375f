#include "can/hub/bridge.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "can/hub/medium/bit_time.hpp"
#include "tests/can/hub/told.hpp"
#include "tests/fakes/fake_port.hpp"

namespace {

using bus::LinkState;
using bus::SendStatus;
using fakes::frame_of;
using hub::Medium;
using told::kStart;
using told::passage;
using Texts = std::vector<std::string>;
using namespace std::chrono_literals;

/// A link that says what a test wants.
class FakeLink final : public bus::Link {
 public:
  std::optional<LinkState> news;
  int polled = -1;

  int descriptor() const noexcept override { return polled; }
  std::optional<LinkState> read() noexcept override { return std::exchange(news, std::nullopt); }
  LinkState state() const noexcept override { return LinkState::Up; }
};

class Bridge : public testing::Test {
 public:
  explicit Bridge(std::uint32_t bit_rate = 0) : medium{bit_rate} { medium.attach(member); }

  /// The other bus has brought @p frames, and the loop sees it.
  void bring(const Texts& frames) {
    for (const std::string& frame : frames) port->arrived.push_back(frame_of(frame));
    bridge.on_readable(kStart);
  }
  /// What the other bus has got.
  Texts taken() const {
    Texts texts;
    for (const canopen::Frame& frame : port->sent) texts.push_back(fakes::candump(frame));
    return texts;
  }
  bool polls_readable() const {
    pollfd wanted{bridge.descriptor(), POLLIN, 0};
    return poll(&wanted, 1, 0) == 1;
  }
  userbus::MemberStatistics row() const {
    userbus::MemberStatistics statistics{};
    EXPECT_TRUE(bridge.statistics(statistics));
    return statistics;
  }

  os::Descriptor readable{eventfd(1, EFD_CLOEXEC)};
  os::Descriptor quiet{eventfd(0, EFD_CLOEXEC)};
  Medium medium;
  told::Listener member;
  Texts notices;
  fakes::FakePort* port = new fakes::FakePort;  // NOLINT(*-owning-memory): the bridge owns it
  FakeLink* link = new FakeLink;                // NOLINT(*-owning-memory): likewise
  hub::Bridge bridge = make();

 private:
  hub::Bridge make() {
    port->polled = readable.get();
    link->polled = quiet.get();
    return {medium,
            {std::unique_ptr<bus::Port>{port}, std::unique_ptr<bus::Link>{link}},
            "can7",
            [this](std::string_view line) { notices.emplace_back(line); }};
  }
};

TEST_F(Bridge, BringsFramesOfTheOtherBusAsThoseOfAnotherMachine) {
  bring({"123#01", "00000123#R", "705#R"});

  EXPECT_EQ(member.seen, (Texts{"123#01", "00000123#R", "705#R"}));
  EXPECT_FALSE(member.passages[0].local);
  EXPECT_EQ(member.passages[0].interface_index, 0);
}

TEST_F(Bridge, SendsFramesOfMembersToTheOtherBus) {
  medium.send(passage(member, "123#01"), kStart);
  hub::Passage not_looped_back = passage(member, "124#");
  not_looped_back.loopback = false;
  medium.send(not_looped_back, kStart);

  EXPECT_EQ(taken(), (Texts{"123#01", "124#"}));
}

TEST_F(Bridge, SendsNothingBackToWhereItCameFrom) {
  bring({"123#01"});

  EXPECT_EQ(taken(), Texts{});
}

TEST_F(Bridge, KeepsErrorFramesOffTheOtherBus) {
  hub::Passage error = passage(member, "004#0000000000000000");
  error.frame.can_id |= CAN_ERR_FLAG;
  medium.send(error, kStart);

  EXPECT_EQ(taken(), Texts{});
}

TEST_F(Bridge, KeepsFramesWhileTheOtherBusIsFull) {
  port->rule = [](std::size_t call) { return call == 0 ? SendStatus::Full : SendStatus::Sent; };
  medium.send(passage(member, "123#01"), kStart);
  medium.send(passage(member, "124#02"), kStart);
  EXPECT_EQ(taken(), Texts{});
  ASSERT_NE(bridge.next_deadline(), canopen::kNever);

  bridge.on_time(bridge.next_deadline());

  EXPECT_EQ(taken(), (Texts{"123#01", "124#02"}));
  EXPECT_EQ(bridge.next_deadline(), canopen::kNever);
}

TEST_F(Bridge, DropsAndCountsWhatItCannotKeep) {
  port->rule = [](std::size_t) { return SendStatus::Full; };

  for (std::size_t i = 0; i < hub::Bridge::kQueue + 5; ++i) medium.send(passage(member, "123#"), kStart);

  EXPECT_EQ(row().dropped, 5u);
}

TEST_F(Bridge, CountsWhatItCarries) {
  bring({"001#", "002#"});
  medium.send(passage(member, "123#"), kStart);

  EXPECT_STREQ(row().name, "can7");
  EXPECT_EQ(row().sent, 2u);
  EXPECT_EQ(row().received, 1u);
  EXPECT_EQ(row().dropped, 0u);
}

TEST_F(Bridge, TellsTheErrorStateOfTheOtherController) {
  class Passive final : public bus::Port {
   public:
    int reads = 0;
    SendStatus send(const canopen::Frame&) noexcept override { return SendStatus::Sent; }
    bus::Received receive(canopen::Frame&) noexcept override {
      return {reads++ == 0 ? bus::Received::Error : bus::Received::Nothing, bus::ErrorState::Passive};
    }
    bus::ErrorState error_state() const noexcept override { return bus::ErrorState::Passive; }
    std::uint64_t dropped() const noexcept override { return 0; }
    int descriptor() const noexcept override { return event.get(); }
    void accept_only(std::span<const bus::Filter>) noexcept override {}
    bool reopen() noexcept override { return true; }

   private:
    os::Descriptor event{eventfd(1, EFD_CLOEXEC)};
  };
  auto other_link = std::make_unique<FakeLink>();
  other_link->polled = quiet.get();
  hub::Bridge passive{medium, {std::make_unique<Passive>(), std::move(other_link)}, "can8", [this](auto line) {
                        notices.emplace_back(line);
                      }};

  passive.on_readable(kStart);

  EXPECT_EQ(notices, Texts{"can8: error-passive"});
  EXPECT_EQ(member.seen, Texts{});
}

TEST_F(Bridge, LimitsWhatTheOtherBusCanMakeItSay) {
  constexpr std::size_t kMost = bus::MessageLimit::kMost;
  for (std::size_t i = 0; i < 5 * kMost; ++i) {
    link->news = i % 2 == 0 ? LinkState::Down : LinkState::Up;
    bridge.on_readable(kStart);
  }
  EXPECT_EQ(notices.size(), kMost);
  EXPECT_EQ(bridge.next_deadline(), kStart + bus::MessageLimit::kPeriod);

  bridge.on_time(kStart + bus::MessageLimit::kPeriod);

  ASSERT_EQ(notices.size(), kMost + 1);
  EXPECT_EQ(notices.back(), "can7: ... 40 more messages left out");
}

TEST_F(Bridge, JoinsTheOtherBusAgainWhenItComesBack) {
  port->rule = [](std::size_t) { return SendStatus::Full; };
  medium.send(passage(member, "123#01"), kStart);
  link->news = LinkState::Down;
  bridge.on_readable(kStart);
  EXPECT_EQ(row().dropped, 1u);
  EXPECT_EQ(port->reopened, 0u);

  link->news = LinkState::Up;
  bridge.on_readable(kStart);

  EXPECT_EQ(port->reopened, 1u);
  EXPECT_EQ(notices, (Texts{"can7: down", "can7: up"}));
}

TEST_F(Bridge, GivesTheMembersTheirTurnWhenTheOtherBusBringsMuch) {
  bring(Texts(1000, "123#"));

  EXPECT_LT(member.seen.size(), 1000u);
  EXPECT_TRUE(polls_readable());
}

/// The medium has room for one frame on the wire and kQueue behind.
class BridgeToSlowMedium : public Bridge {
 public:
  BridgeToSlowMedium() : Bridge{10'000} {}
};

TEST_F(BridgeToSlowMedium, DoesNotReadTheOtherBusWhileTheMediumIsFull) {
  bring(Texts(Medium::kQueue + 3, "123#"));

  EXPECT_EQ(port->arrived.size(), 1u);
  EXPECT_FALSE(polls_readable());

  medium.on_time(medium.next_deadline());
  EXPECT_TRUE(polls_readable());
  bridge.on_readable(medium.now());
  EXPECT_EQ(port->arrived.size(), 0u);
  while (medium.next_deadline() != canopen::kNever) medium.on_time(medium.next_deadline());

  EXPECT_EQ(member.seen.size(), Medium::kQueue + 3);
}

}  // namespace
