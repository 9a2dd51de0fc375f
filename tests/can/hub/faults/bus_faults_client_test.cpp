#include <cerrno>
#include <cstring>
#include <thread>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "can/bus_faults/bus_faults.hpp"
#include "injection/kinds/bus_kinds.hpp"
#include "tests/can/hub/running_hub.hpp"

namespace hub_test {
namespace {

using nlohmann::json;

TEST(BusFaultsClient, InjectsListsAndTakesBack) {
  RunningHub hub;
  const userbus::Path path = path_of(hub.path());

  EXPECT_EQ(bus_faults::inject(path, "bus.drop id=185").value(), 1u);
  EXPECT_EQ(bus_faults::inject(path, json{{"kind", "bus.delay"}, {"delay_ms", 5}}).value(), 2u);
  const json faults = bus_faults::list(path).value();
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[1]["fault"], (json{{"kind", "bus.delay"}, {"delay_ms", 5}}));
  EXPECT_EQ(bus_faults::take_back(path, 1).value(), 1u);
  EXPECT_EQ(bus_faults::take_back(path, std::nullopt).value(), 1u);
  EXPECT_EQ(bus_faults::list(path).value(), json::array());
}

TEST(BusFaultsClient, GetsListsThatNoMessageHolds) {
  RunningHub hub;
  const userbus::Path path = path_of(hub.path());
  for (int i = 0; i < 60; ++i)
    ASSERT_TRUE(bus_faults::inject(path, "bus.cut members=unix:" + std::string(180, 'x')));

  EXPECT_EQ(bus_faults::list(path).value().size(), 60u);
  EXPECT_EQ(bus_faults::kinds(path).value().size(), injection::bus_kinds().size());
}

TEST(BusFaultsClient, SaysWhatIsWrong) {
  RunningHub hub;
  const auto wrong = bus_faults::inject(path_of(hub.path()), "bus.delay");
  const auto nobody = bus_faults::list(path_of(hub.path() + "-none"));

  ASSERT_FALSE(wrong);
  EXPECT_TRUE(wrong.error().by_hub);
  EXPECT_EQ(wrong.error().text, "delay_ms: expected a whole number from 1 to 3600000, got nothing");
  ASSERT_FALSE(nobody);
  EXPECT_FALSE(nobody.error().by_hub);
  EXPECT_EQ(nobody.error().text, hub.path() + "-none: is not served");
}

/// Answers one member as a hub that knows no operation but the first ones: Hello, and EINVAL to everything else.
class OldHub {
 public:
  OldHub() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strcpy(address.sun_path, path().c_str());
    if (bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        listen(listener_.get(), 1) != 0)
      throw std::runtime_error{"no socket for an old hub"};
    thread_ = std::thread{[this] { serve(); }};
  }
  OldHub(const OldHub&) = delete;
  OldHub& operator=(const OldHub&) = delete;
  ~OldHub() { thread_.join(); }

  [[nodiscard]] std::string path() const { return folder_.path("bus"); }

 private:
  void serve() const {
    const os::Descriptor member{accept(listener_.get(), nullptr, nullptr)};
    userbus::Request request{};
    std::array<char, userbus::kLongestMessage> payload{};
    std::array parts{iovec{&request, sizeof request}, iovec{payload.data(), payload.size()}};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    for (;;) {
      msghdr message{};
      message.msg_iov = parts.data();
      message.msg_iovlen = parts.size();
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      if (recvmsg(member.get(), &message, 0) <= 0) return;
      int answering = -1;
      std::memcpy(&answering, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof answering);
      const os::Descriptor socket{answering};
      const bool is_known = request.operation == userbus::Operation::Hello;
      const userbus::Reply reply{.error = is_known ? 0 : EINVAL, .value = 0, .size = 0};
      send(socket.get(), &reply, sizeof reply, MSG_NOSIGNAL);
    }
  }

  fakes::TemporaryDirectory folder_;
  os::Descriptor listener_{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
  std::thread thread_;
};

TEST(BusFaultsClient, TellsAHubThatHasNoFaultsYet) {
  const OldHub hub;
  const auto answer = bus_faults::inject(path_of(hub.path()), "bus.drop");

  ASSERT_FALSE(answer);
  EXPECT_FALSE(answer.error().by_hub);
  EXPECT_EQ(answer.error().text, hub.path() + ": its hub is of an older version, which has no faults");
}

}  // namespace
}  // namespace hub_test
