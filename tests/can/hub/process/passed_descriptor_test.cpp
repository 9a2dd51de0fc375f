#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <list>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "tests/can/hub/bus_client.hpp"
#include "tests/e2e/program.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {
namespace {

/// A TCP connection whose close(2) waits for a reader who does not read: SO_LINGER, and more sent than there is
/// room for.
class Lingering {
 public:
  Lingering(const Lingering&) = delete;
  Lingering& operator=(const Lingering&) = delete;
  ~Lingering() { end(); }
  Lingering() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
    EXPECT_EQ(::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
    EXPECT_EQ(::connect(sender_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    reader_ = os::Descriptor{::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC)};
    const linger hours{.l_onoff = 1, .l_linger = 10'000};
    EXPECT_EQ(::setsockopt(sender_.get(), SOL_SOCKET, SO_LINGER, &hours, sizeof hours), 0);
    const std::vector<char> much(1 << 16);
    while (::send(sender_.get(), much.data(), much.size(), MSG_DONTWAIT) > 0) continue;
  }

  /// Passes the one that lingers over @p socket, @p times, with @p bytes; nobody else has it then, so who takes it
  /// must not do so before this returns.
  void pass(int socket, std::span<const std::byte> bytes, std::size_t times = 1) {
    std::vector<std::byte> control(CMSG_SPACE(times * sizeof(int)));
    iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(times * sizeof(int));
    const std::vector<int> descriptors(times, sender_.get());
    std::memcpy(CMSG_DATA(header), descriptors.data(), times * sizeof(int));
    EXPECT_GT(::sendmsg(socket, &message, MSG_NOSIGNAL), 0);
    sender_ = os::Descriptor{};
  }
  /// The reader goes, and with it what the sender waits for.
  void end() { reader_ = os::Descriptor{}; }

 private:
  os::Descriptor listener_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  os::Descriptor sender_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  os::Descriptor reader_;
};

/// What is passed while the hub stands waits for its end afterwards, and the others talk.
class PassedDescriptor : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(hub_.wait_for_output("ready")) << hub_.output(); }

  /// Returns when the hub stands still.
  void stop_hub() {
    stranger();
    hub_.signal(SIGSTOP);
    char state = '?';
    while (state != 'T') {
      std::ifstream status{"/proc/" + std::to_string(hub_.id()) + "/stat"};
      std::string skipped;
      status >> skipped >> skipped >> state;
    }
  }
  void expect_talk() {
    hub_.signal(SIGCONT);
    talker().send("123#01");
    EXPECT_EQ(listener().wait_frame(), "123#01");
    lingering_.end();
  }
  BusClient& talker() { return member(0); }
  BusClient& listener() { return member(1); }
  BusClient& stranger() { return member(2); }
  static std::span<const std::byte> hello() {
    static const userbus::Request kHello{.operation = userbus::Operation::Hello, .value = 0, .size = 0};
    return std::as_bytes(std::span{&kHello, 1});
  }

  fakes::TemporaryDirectory folder_;
  std::string bus_ = folder_.path("bus");
  e2e::Program hub_{{CANHUB, "--path", bus_}, {}};
  std::list<BusClient> members_;
  Lingering lingering_;

 private:
  BusClient& member(std::ptrdiff_t number) {
    while (std::ssize(members_) <= number) members_.emplace_back(bus_);
    return *std::next(members_.begin(), number);
  }
};

TEST_F(PassedDescriptor, ThatLingersDoesNotHoldUpTheHub) {
  stop_hub();
  lingering_.pass(stranger().descriptor(), hello());
  expect_talk();
}

TEST_F(PassedDescriptor, OfManyDoesNotHoldUpTheHubEither) {
  stop_hub();
  lingering_.pass(stranger().descriptor(), hello(), 200);
  expect_talk();
}

TEST_F(PassedDescriptor, DoesNotHoldItUpInsideTheSocketForTheReply) {
  stop_hub();
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
  const os::Descriptor mine{ends[0]};
  os::Descriptor its{ends[1]};
  lingering_.pass(mine.get(), hello());
  alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(int))> control{};
  iovec part{const_cast<std::byte*>(hello().data()), hello().size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  const int passed = its.get();
  std::memcpy(CMSG_DATA(header), &passed, sizeof passed);
  ASSERT_GT(::sendmsg(stranger().descriptor(), &message, MSG_NOSIGNAL), 0);
  its = os::Descriptor{};

  expect_talk();
}

}  // namespace
}  // namespace hub_test
