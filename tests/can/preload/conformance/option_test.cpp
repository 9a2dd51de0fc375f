#include <array>
#include <cerrno>

#include <gtest/gtest.h>
#include <linux/can/bcm.h>
#include <linux/can/error.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

/// What getsockopt(2) of the filters said.
struct Filters {
  int error;
  socklen_t size;
  std::array<can_filter, 8> list;
};

Filters filters_of(const CanSocket& socket, socklen_t room) {
  Filters filters{.error = 0, .size = room, .list = {}};
  filters.error =
      error_of(getsockopt(socket.fd(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.list.data(), &filters.size));
  return filters;
}

TEST(Options, HaveTheirDefaults) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};

  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_LOOPBACK), 1);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS), 0);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_ERR_FILTER), 0);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_FD_FRAMES), 0);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_JOIN_FILTERS), 0);
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_TIMESTAMP), 0);
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_RXQ_OVFL), 0);
}

TEST(Options, KeepWhatTheyAreSetTo) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};

  for (const int option : {CAN_RAW_RECV_OWN_MSGS, CAN_RAW_FD_FRAMES, CAN_RAW_JOIN_FILTERS}) {
    EXPECT_EQ(socket.set(SOL_CAN_RAW, option, 1), 0);
    EXPECT_EQ(socket.get(SOL_CAN_RAW, option), 1);
  }
  EXPECT_EQ(socket.set(SOL_CAN_RAW, CAN_RAW_LOOPBACK, 0), 0);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_LOOPBACK), 0);
  EXPECT_EQ(socket.set(SOL_CAN_RAW, CAN_RAW_ERR_FILTER, -1), 0);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, CAN_RAW_ERR_FILTER), static_cast<int>(CAN_ERR_MASK));
}

TEST(Options, OfTheWrongSizeAreRefused) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  const std::array<char, 8> value{};

  for (const int option :
       {CAN_RAW_ERR_FILTER, CAN_RAW_LOOPBACK, CAN_RAW_RECV_OWN_MSGS, CAN_RAW_FD_FRAMES, CAN_RAW_JOIN_FILTERS}) {
    EXPECT_EQ(error_of(setsockopt(socket.fd(), SOL_CAN_RAW, option, value.data(), 3)), EINVAL) << option;
    EXPECT_EQ(error_of(setsockopt(socket.fd(), SOL_CAN_RAW, option, value.data(), 8)), EINVAL) << option;
  }
  EXPECT_EQ(error_of(setsockopt(socket.fd(), SOL_CAN_RAW, CAN_RAW_FILTER, value.data(), 7)), EINVAL);
}

TEST(Options, GiveAsMuchAsThereIsRoomFor) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  std::array<char, 8> value{};
  socklen_t size = value.size();

  EXPECT_EQ(error_of(getsockopt(socket.fd(), SOL_CAN_RAW, CAN_RAW_LOOPBACK, value.data(), &size)), 0);
  EXPECT_EQ(size, sizeof(int));
  size = 1;
  EXPECT_EQ(error_of(getsockopt(socket.fd(), SOL_CAN_RAW, CAN_RAW_LOOPBACK, value.data(), &size)), 0);
  EXPECT_EQ(size, 1u);
}

TEST(Options, ThatAreNoneAreRefused) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};

  EXPECT_EQ(socket.set(SOL_CAN_RAW, 99, 1), ENOPROTOOPT);
  EXPECT_EQ(socket.get(SOL_CAN_RAW, 99), -ENOPROTOOPT);
  EXPECT_EQ(socket.set(SOL_CAN_BASE + CAN_BCM, 1, 1), EINVAL);
  EXPECT_EQ(socket.get(SOL_CAN_BASE + CAN_BCM, 1), -EINVAL);
}

TEST(Options, AreNotForABroadcastManager) {
  const CanSocket manager{SOCK_DGRAM, CAN_BCM};

  EXPECT_EQ(manager.set(SOL_CAN_RAW, CAN_RAW_LOOPBACK, 1), EOPNOTSUPP);
  EXPECT_EQ(manager.get(SOL_CAN_RAW, CAN_RAW_LOOPBACK), -EOPNOTSUPP);
}

TEST(Options, OfTimeStampsExcludeOneAnother) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};

  EXPECT_EQ(socket.set(SOL_SOCKET, SO_TIMESTAMP, 1), 0);
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_TIMESTAMP), 1);
  EXPECT_EQ(socket.set(SOL_SOCKET, SO_TIMESTAMPNS, 1), 0);
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_TIMESTAMP), 0);
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_TIMESTAMPNS), 1);
  EXPECT_EQ(socket.set(SOL_SOCKET, SO_TIMESTAMPNS, 0), 0);
  EXPECT_EQ(socket.get(SOL_SOCKET, SO_TIMESTAMPNS), 0);
}

TEST(Filters, AreAtFirstOneThatLetsAllPass) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};

  const Filters filters = filters_of(socket, sizeof filters.list);

  EXPECT_EQ(filters.error, 0);
  ASSERT_EQ(filters.size, sizeof(can_filter));
  EXPECT_EQ(filters.list[0].can_id, 0u);
  EXPECT_EQ(filters.list[0].can_mask, 0u);
}

TEST(Filters, CanBeReadBack) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  ASSERT_EQ(socket.set_filters({{.can_id = 0x181, .can_mask = 0x7FF}, {.can_id = 0x700, .can_mask = 0x780}}), 0);

  const Filters filters = filters_of(socket, sizeof filters.list);

  ASSERT_EQ(filters.size, 2 * sizeof(can_filter));
  EXPECT_EQ(filters.list[1].can_id, 0x700u);
  EXPECT_EQ(filters.list[1].can_mask, 0x780u);
}

TEST(Filters, TellTheRoomTheyNeed) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  ASSERT_EQ(socket.set_filters({{.can_id = 1, .can_mask = 1}, {.can_id = 2, .can_mask = 2}}), 0);

  const Filters filters = filters_of(socket, sizeof(can_filter));

  EXPECT_EQ(filters.error, ERANGE);
  EXPECT_EQ(filters.size, 2 * sizeof(can_filter));
}

TEST(Filters, CanBeNone) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  ASSERT_EQ(error_of(setsockopt(socket.fd(), SOL_CAN_RAW, CAN_RAW_FILTER, nullptr, 0)), 0);

  const Filters filters = filters_of(socket, sizeof filters.list);

  EXPECT_EQ(filters.error, 0);
  EXPECT_EQ(filters.size, 0u);
}

TEST(Filters, AreAtMost512) {
  const CanSocket socket{SOCK_RAW, CAN_RAW};
  const std::array<can_filter, CAN_RAW_FILTER_MAX + 1> filters{};
  const auto set = [&](std::size_t count) {
    return error_of(setsockopt(socket.fd(), SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(),
                               static_cast<socklen_t>(count * sizeof(can_filter))));
  };

  EXPECT_EQ(set(CAN_RAW_FILTER_MAX), 0);
  EXPECT_EQ(set(CAN_RAW_FILTER_MAX + 1), EINVAL);
}

}  // namespace
}  // namespace conformance
