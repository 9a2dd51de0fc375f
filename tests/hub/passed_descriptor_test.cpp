#include <array>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "tests/hub/running_hub.hpp"

namespace hub_test {
namespace {

/// A TCP connection whose close(2) waits for a reader who does not read: SO_LINGER, and more sent than there is
/// room for.
class Lingering {
 public:
  Lingering() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
    EXPECT_EQ(::getsockname(listener_.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
    EXPECT_EQ(::connect(sender_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    reader_ = bus::Descriptor{::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC)};
    const linger hours{.l_onoff = 1, .l_linger = 10'000};
    EXPECT_EQ(::setsockopt(sender_.get(), SOL_SOCKET, SO_LINGER, &hours, sizeof hours), 0);
    const std::vector<char> much(1 << 16);
    while (::send(sender_.get(), much.data(), much.size(), MSG_DONTWAIT) > 0) continue;
  }

  /// Passes the one that lingers over @p socket, @p times, with @p bytes; nobody else has it then.
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
    sender_ = bus::Descriptor{};
  }
  /// The reader goes, and with it what the sender waits for.
  void end() { reader_ = bus::Descriptor{}; }

 private:
  bus::Descriptor listener_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  bus::Descriptor sender_{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  bus::Descriptor reader_;
};

/// While what was passed waits for its end, the others talk.
class PassedDescriptor : public testing::Test {
 protected:
  void expect_talk() {
    talker_.send("123#01");
    EXPECT_EQ(listener_.wait_frame(), "123#01");
  }
  static std::span<const std::byte> hello() {
    static const userbus::Request kHello{.operation = userbus::Operation::Hello, .value = 0, .size = 0};
    return std::as_bytes(std::span{&kHello, 1});
  }

  RunningHub hub_;
  BusClient talker_{hub_.path()};
  BusClient listener_{hub_.path()};
  BusClient stranger_{hub_.path()};
  Lingering lingering_;
};

TEST_F(PassedDescriptor, ThatLingersDoesNotHoldUpTheHub) {
  lingering_.pass(stranger_.descriptor(), hello());
  expect_talk();
  lingering_.end();
}

TEST_F(PassedDescriptor, OfManyDoesNotHoldUpTheHubEither) {
  lingering_.pass(stranger_.descriptor(), hello(), 200);
  expect_talk();
  lingering_.end();
}

TEST_F(PassedDescriptor, DoesNotHoldItUpInsideTheSocketForTheReply) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
  const bus::Descriptor mine{ends[0]};
  bus::Descriptor its{ends[1]};
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
  ASSERT_GT(::sendmsg(stranger_.descriptor(), &message, MSG_NOSIGNAL), 0);
  its = bus::Descriptor{};

  expect_talk();
  lingering_.end();
}

}  // namespace
}  // namespace hub_test
