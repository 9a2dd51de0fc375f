#include "libcanopen/service/identifier_list.hpp"
#include "libcanopen/service/service.hpp"
#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using canopen::Frame;
using canopen::kNoNodeId;
using canopen::NmtCommand;
using canopen::NmtState;
using canopen::NmtStates;
using canopen::Reload;
using canopen::Service;

constexpr canopen::Identifier kRequest = 0x7E5, kAnswer = 0x7E4;

/// A service that no node has by itself: it echoes a byte, answers remote frames and keeps two timers.
class Echo final : public Service {
 public:
  Echo(canopen::Context& context, NmtStates lives_in)
      : Service{context, {.lives_in = lives_in, .identifiers = 3, .timers = 2}} {}

  void list_identifiers(canopen::IdentifierList& list) const noexcept override {
    list.hears(kRequest, 7);
    list.hears(0x80, 8);  // SYNC is taken
    list.answers(kAnswer, 9);
    list.sends(kAnswer);
  }
  void on_frame(const Frame& frame, std::size_t slot) noexcept override {
    told.push_back("frame " + std::to_string(slot));
    Frame answer = canopen::frame_under(kAnswer, 1);
    answer.data[0] = frame.data[0];
    context_.sink->send(answer, canopen::Delivery::Ordered);
  }
  void on_request(std::size_t slot) noexcept override { told.push_back("request " + std::to_string(slot)); }
  void on_timer(std::size_t which) noexcept override { told.push_back("timer " + std::to_string(which)); }
  void reload(Reload how) noexcept override { told.push_back(how == Reload::Afresh ? "afresh" : "take over"); }
  void start() noexcept override { told.emplace_back("start"); }
  void stop() noexcept override { told.emplace_back("stop"); }

  void wakes_after(std::size_t which, canopen::Duration time) noexcept { arm(which, context_.now + time); }
  /// As LSS does: the node-ID and the reset that brings it into force.
  void configures(std::uint8_t node_id) noexcept {
    context_.pending_node_id = node_id;
    context_.nmt.reset(NmtCommand::ResetCommunication);
  }
  /// What happened since the last of these calls.
  std::vector<std::string> takes() { return std::exchange(told, {}); }

  std::vector<std::string> told;
};

class FurtherService : public NodeTest {
 protected:
  Echo& adds(NmtStates lives_in) { return echo.emplace(node->context(), lives_in); }
  std::optional<Echo> echo;
};

constexpr NmtStates kEverywhere{NmtState::Unconfigured, NmtState::Stopped, NmtState::PreOperational,
                                NmtState::Operational};

TEST_F(FurtherService, GetsTheFramesOfItsIdentifiers) {
  Echo& service = adds(kEverywhere);
  start();
  service.takes();

  EXPECT_EQ(says("7E5#2A"), (Lines{"7E4#2A"}));
  EXPECT_EQ(says("7E4#R"), Lines{});
  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(service.takes(), (Lines{"frame 7", "request 9"}));
  EXPECT_TRUE(node->uses(kRequest));
  EXPECT_TRUE(node->uses(kAnswer));
  EXPECT_EQ(subscriptions(),
            (std::vector<std::uint32_t>{0, 0x80, 0x205, 0x305, 0x405, 0x585, 0x605, 0x705, kRequest}));
}

TEST_F(FurtherService, LivesInItsStatesOnly) {
  Echo& service = adds({NmtState::PreOperational});
  EXPECT_EQ(start(), (Lines{"705#00"}));
  EXPECT_EQ(service.takes(), (Lines{"afresh", "start"}));
  service.wakes_after(1, 10ms);

  says("000#0205");
  EXPECT_EQ(service.takes(), (Lines{"stop"}));
  EXPECT_EQ(says("7E5#2A"), Lines{});
  passes(20ms);
  EXPECT_EQ(service.takes(), Lines{});

  says("000#8005");
  EXPECT_EQ(says("7E5#2A"), (Lines{"7E4#2A"}));
  EXPECT_EQ(service.takes(), (Lines{"start", "frame 7"}));
}

TEST_F(FurtherService, StartsAfterTheApplicationKnowsTheState) {
  Echo& service = adds({NmtState::Operational});
  start();
  service.takes();
  application.reaction = [&](const std::string& what) {
    if (what != "Pre-operational -> Operational") return;
    EXPECT_EQ(service.takes(), Lines{});
    node->apply_error_behaviour(1);  // back to Pre-operational: it never lived
  };

  says("000#0105");
  EXPECT_EQ(node->state(), NmtState::PreOperational);
  EXPECT_EQ(service.takes(), Lines{});
}

TEST_F(FurtherService, HasItsTimers) {
  Echo& service = adds(kEverywhere);
  start();
  service.takes();
  service.wakes_after(1, 20ms);
  service.wakes_after(0, 30ms);

  passes(25ms);
  EXPECT_EQ(service.takes(), (Lines{"timer 1"}));
  passes(25ms);
  EXPECT_EQ(service.takes(), (Lines{"timer 0"}));
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(FurtherService, IsReloadedWithTheOthers) {
  Echo& service = adds(kEverywhere);
  start();
  service.takes();

  node->reload(now);
  EXPECT_EQ(service.takes(), (Lines{"take over", "start"}));
  says("000#8205");
  EXPECT_EQ(service.takes(), (Lines{"stop", "afresh", "start"}));
}

TEST_F(FurtherService, MayLiveWithoutANodeIdAndGiveOne) {
  Echo& service = adds(kEverywhere);
  node->set_node_id(kNoNodeId);
  EXPECT_EQ(start(), Lines{});
  EXPECT_EQ(service.takes(), (Lines{"afresh", "start"}));
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0x80, kRequest})) << "SYNC is nobody else's";

  EXPECT_EQ(says("7E5#2A"), (Lines{"7E4#2A"}));
  service.configures(17);

  EXPECT_EQ(sent(), (Lines{"711#00"}));
  EXPECT_EQ(node->state(), NmtState::PreOperational);
  EXPECT_EQ(says("611#4000100000000000"), (Lines{"591#4300100092010200"}));
}

TEST_F(FurtherService, IsRefusedIfThereAreTooMany) {
  std::vector<std::unique_ptr<Echo>> services;
  const auto add_many = [&] {
    for (int i = 0; i < 33; ++i) services.push_back(std::make_unique<Echo>(node->context(), kEverywhere));
  };

  EXPECT_THROW(add_many(), std::length_error);
}

}  // namespace
