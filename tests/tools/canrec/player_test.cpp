#include "tools/canrec/play/player.hpp"

#include <csignal>
#include <memory>

#include <gtest/gtest.h>
#include <sys/eventfd.h>

#include "os/descriptor.hpp"
#include "tests/fakes/fake_link.hpp"
#include "tests/fakes/fake_port.hpp"
#include "tests/tools/canrec/list_source.hpp"

namespace {

using namespace std::chrono_literals;
using bus::SendStatus;
using canrec::Pace;
using canrec::Player;
using canrec::Status;
using canrec::TimeRange;
using canrec_test::frame;
using canrec_test::ListSource;

constexpr auto kFirst = 1700000000s;

/// A player onto a bus in memory.
struct Stage {
  fakes::FakePort* port = new fakes::FakePort;  // of the connection
  fakes::FakeLink* link = new fakes::FakeLink;
  Player player;

  explicit Stage(double speed)
      : player{bus::Connection{std::unique_ptr<bus::Port>{port}, std::unique_ptr<bus::Link>{link}}, "bus",
               Pace{speed}} {}

  std::vector<std::uint32_t> sent() const {
    std::vector<std::uint32_t> all;
    for (const canopen::Frame& each : port->sent) all.push_back(each.id);
    return all;
  }
};

ListSource three() {
  return ListSource{{frame(kFirst, 1), frame(kFirst + 20ms, 2), frame(kFirst + 40ms, 3)}};
}

TEST(Player, SendsAllInOrder) {
  Stage stage{0.0};
  ListSource source = three();

  const auto whole = stage.player.play(source, {});

  ASSERT_TRUE(whole);
  EXPECT_TRUE(*whole);
  EXPECT_EQ(stage.sent(), (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_EQ(stage.player.figures().sent, 3U);
  EXPECT_TRUE(stage.port->filters.empty()) << "it hears nothing";
}

TEST(Player, SendsNothingBeforeItsTime) {
  Stage stage{2.0};
  ListSource source = three();

  ASSERT_TRUE(stage.player.play(source, {}));

  EXPECT_GE(stage.player.figures().duration, 20ms);
}

TEST(Player, SendsWhatIsInTheRange) {
  Stage stage{0.0};
  ListSource source = three();

  ASSERT_TRUE(stage.player.play(source, TimeRange{.from = canrec::Moment{20ms}, .to = canrec::Moment{40ms}}));

  EXPECT_EQ(stage.sent(), std::vector<std::uint32_t>{2});
}

TEST(Player, TriesAgainWhileTheBusIsFull) {
  Stage stage{0.0};
  stage.port->rule = [](std::size_t call) { return call % 4 == 3 ? SendStatus::Sent : SendStatus::Full; };
  ListSource source = three();

  ASSERT_TRUE(stage.player.play(source, {}));

  EXPECT_EQ(stage.sent(), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST(Player, LeavesOutWhatCannotBeSent) {
  Stage stage{0.0};
  stage.port->rule = [](std::size_t call) { return call == 1 ? SendStatus::Failed : SendStatus::Sent; };
  ListSource source{{frame(kFirst, 1), frame(kFirst, 2), frame(kFirst, CAN_ERR_FLAG | 4), frame(kFirst, 3)}};

  ASSERT_TRUE(stage.player.play(source, {}));

  EXPECT_EQ(stage.sent(), (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(stage.player.figures().refused, 1U);
  EXPECT_EQ(stage.player.figures().errors, 1U);
}

TEST(Player, EndsWhenTheBusIsDownAtAFrame) {
  Stage stage{0.0};
  stage.port->rule = [](std::size_t call) { return call == 1 ? SendStatus::Down : SendStatus::Sent; };
  ListSource source = three();

  const auto whole = stage.player.play(source, {});

  ASSERT_FALSE(whole);
  EXPECT_EQ(whole.error().status, Status::BusDown);
  EXPECT_EQ(whole.error().text, "bus is down, 1 frames had been sent");
}

TEST(Player, EndsWhenTheBusGoesDownBetweenFrames) {
  Stage stage{1.0};
  const os::Descriptor bell{eventfd(1, EFD_NONBLOCK | EFD_CLOEXEC)};
  stage.port->polled = bell.get();
  stage.port->down = true;
  ListSource source{{frame(kFirst, 1), frame(kFirst + 1h, 2)}};

  const auto whole = stage.player.play(source, {});

  ASSERT_FALSE(whole);
  EXPECT_EQ(whole.error().status, Status::BusDown);
  EXPECT_EQ(stage.sent(), std::vector<std::uint32_t>{1});
}

TEST(Player, EndsBySignals) {
  Stage stage{1.0};
  ListSource source{{frame(kFirst, 1), frame(kFirst + 1h, 2)}};
  std::raise(SIGTERM);

  const auto whole = stage.player.play(source, {});

  ASSERT_TRUE(whole);
  EXPECT_FALSE(*whole);
  EXPECT_EQ(stage.player.signal(), SIGTERM);
  EXPECT_EQ(stage.sent(), std::vector<std::uint32_t>{1});
}

TEST(Player, FailsAsItsSourceDoes) {
  Stage stage{0.0};
  ListSource source{{frame(kFirst, 1)}, canrec::Failure{Status::NoServer, "no answer"}};

  const auto whole = stage.player.play(source, {});

  ASSERT_FALSE(whole);
  EXPECT_EQ(whole.error().text, "no answer");
  EXPECT_EQ(stage.sent(), std::vector<std::uint32_t>{1});
}

}  // namespace
