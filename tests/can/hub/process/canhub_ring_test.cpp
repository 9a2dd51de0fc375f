// Hubs that are bridged to each other in a ring: each frame passes once everywhere.
#include <csignal>
#include <list>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/can/hub/bus_client.hpp"
#include "tests/e2e/program.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {
namespace {

class CanhubRing : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& hub) const { return folder_.path(hub); }

  /// Starts the hub @p name with bridges to @p others; none of them is started by it.
  e2e::Program& start(const std::string& name, const std::vector<std::string>& others = {}) {
    std::vector<std::string> words{CANHUB, "--path", path(name)};
    for (const std::string& other : others) words.insert(words.end(), {"--bridge", "unix:" + path(other)});
    e2e::Program& hub = hubs_.emplace_back(words, std::vector<std::string>{"CAN_HUB=/nonexistent/canhub"});
    EXPECT_TRUE(hub.wait_for_output("ready")) << hub.output();
    return hub;
  }

  /// A member of each of @p hubs speaks, and all others hear each word once.
  void expect_each_frame_once(const std::vector<std::string>& hubs) {
    std::list<BusClient> members;
    for (const std::string& hub : hubs) members.emplace_back(path(hub));
    for (unsigned word = 0; word < 50; ++word) {
      for (BusClient& speaker : members) {
        const std::string frame = fmt::format("123#{:04X}", number_++);
        speaker.send(frame);
        for (BusClient& hearer : members) {
          if (&hearer != &speaker) {
            ASSERT_EQ(hearer.wait_frame(), frame);
          }
        }
      }
    }
    for (BusClient& member : members) {
      member.settle();
      EXPECT_EQ(member.take_frames(), std::vector<std::string>{});
    }
  }

  fakes::TemporaryDirectory folder_;
  std::list<e2e::Program> hubs_;
  unsigned number_ = 0;
};

TEST_F(CanhubRing, OfTwoThatAreBridgedToEachOther) {
  e2e::Program& first = start("a");
  e2e::Program& second = start("b", {"a"});
  first.signal(SIGTERM);
  first.wait();
  start("a", {"b"});
  ASSERT_TRUE(second.wait_for_output("/a: up")) << second.output();

  expect_each_frame_once({"a", "b"});
  EXPECT_TRUE(second.wait_for_output("frames come back")) << second.output();
}

TEST_F(CanhubRing, OfTwoBridgesBetweenTheSameHubs) {
  start("a");
  start("b", {"a", "a"});

  expect_each_frame_once({"a", "b"});
}

TEST_F(CanhubRing, OfThreeWithAFourthBeside) {
  start("a");
  start("b", {"a"});
  start("c", {"a", "b"});
  start("d", {"c"});

  expect_each_frame_once({"a", "b", "c", "d"});
}

}  // namespace
}  // namespace hub_test
