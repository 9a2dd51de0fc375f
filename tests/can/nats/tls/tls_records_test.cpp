#include "can/nats/tls/tls_records.hpp"

#include <array>
#include <string>

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "os/descriptor.hpp"

namespace {

/// A record with @p size bytes behind its header.
std::string record(std::size_t size) {
  return std::string{"\x17\x03\x03"} + static_cast<char>(size / 256) + static_cast<char>(size % 256) +
         std::string(size, 'x');
}

/// A connection, of which only TCP knows when a socket polls readable.
class TlsRecordsTest : public testing::Test {
 protected:
  void SetUp() override {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    const os::Descriptor listener{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    ASSERT_EQ(bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), size), 0);
    ASSERT_EQ(listen(listener.get(), 1), 0);
    ASSERT_EQ(getsockname(listener.get(), reinterpret_cast<sockaddr*>(&address), &size), 0);
    near_ = os::Descriptor{socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
    ASSERT_EQ(connect(near_.get(), reinterpret_cast<const sockaddr*>(&address), size), 0);
    far_ = os::Descriptor{accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC)};
    ASSERT_TRUE(far_);
  }

  void give(const std::string& bytes) const {
    ASSERT_EQ(send(far_.get(), bytes.data(), bytes.size(), 0), bytes.size());
  }
  /// Waits for @p bytes, which have been sent.
  void wait_for(std::size_t bytes) const {
    std::string room(bytes, '\0');
    for (ssize_t size = 0; size != static_cast<ssize_t>(bytes);)
      size = recv(near_.get(), room.data(), room.size(), MSG_PEEK);
  }
  void take(std::size_t bytes) const {
    std::string room(bytes, '\0');
    ASSERT_EQ(recv(near_.get(), room.data(), room.size(), MSG_WAITALL), bytes);
  }
  [[nodiscard]] bool polls_readable() const {
    pollfd wanted{near_.get(), POLLIN, 0};
    return poll(&wanted, 1, 0) == 1;
  }
  [[nodiscard]] bool is_whole(std::uint32_t events = EPOLLIN) { return records_.is_whole(near_.get(), events); }

  os::Descriptor near_;
  os::Descriptor far_;
  nats::TlsRecords records_;
};

TEST_F(TlsRecordsTest, AreReadWhenTheyAreWhole) {
  EXPECT_FALSE(is_whole());

  give(record(300) + record(7));
  wait_for(317);
  EXPECT_TRUE(is_whole());
  take(305);
  EXPECT_TRUE(is_whole());
  take(12);
  EXPECT_FALSE(is_whole());
}

TEST_F(TlsRecordsTest, LeaveTheSocketQuietUntilTheyAreWhole) {
  const std::string whole = record(3000);
  for (const std::size_t part : {3U, 700U, 3004U}) {
    const std::string begin = whole.substr(0, part);
    give(begin);
    wait_for(part);
    EXPECT_FALSE(is_whole()) << part;
    EXPECT_FALSE(polls_readable()) << part;

    give(whole.substr(part));
    wait_for(whole.size());
    EXPECT_TRUE(polls_readable());
    EXPECT_TRUE(is_whole());
    take(whole.size());
  }
}

TEST_F(TlsRecordsTest, AreReadAtTheEndOfTheConnection) {
  give(record(300).substr(0, 100));
  wait_for(100);
  EXPECT_FALSE(is_whole());

  far_ = os::Descriptor{};

  EXPECT_TRUE(is_whole(EPOLLIN | EPOLLRDHUP));
}

}  // namespace
