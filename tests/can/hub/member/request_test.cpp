#include <array>
#include <cerrno>
#include <cstring>
#include <list>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/can/hub/running_hub.hpp"

namespace hub_test {
namespace {

using userbus::Operation;
using userbus::OptionName;

class Request : public testing::Test {
 protected:
  /// The payload of the last answer as one @p T.
  template <class T>
  T reply() const {
    T value{};
    EXPECT_GE(client_.reply().size(), sizeof value);
    std::memcpy(&value, client_.reply().data(), std::min(sizeof value, client_.reply().size()));
    return value;
  }
  int error_of(Operation operation, int value = 0, std::span<const std::byte> payload = {}) const {
    return client_.ask(operation, value, payload).error;
  }
  int index_error(std::string_view name) const {
    return error_of(Operation::InterfaceIndex, 0, std::as_bytes(std::span{name}));
  }

  RunningHub hub_;
  BusClient client_{hub_.path(), ""};
};

TEST_F(Request, HelloTellsTheBitRate) {
  RunningHub slow{125'000};
  BusClient client{slow.path(), ""};

  EXPECT_EQ(client_.ask(Operation::Hello).value, 0);
  EXPECT_EQ(client.ask(Operation::Hello).value, 125'000);
}

TEST_F(Request, ReadStateTellsWhatWasSet) {
  client_.bind("can0");
  client_.set(OptionName::Loopback, 0);
  client_.set(OptionName::Timestamps, 35);

  ASSERT_EQ(error_of(Operation::ReadState), 0);
  const auto state = reply<userbus::MemberState>();
  EXPECT_EQ(state.interface_index, client_.index_of("can0"));
  EXPECT_EQ(state.bit_rate, 0u);
  const std::array<std::uint32_t, userbus::kOptionCount> expected{0, 0, 0, 0, 0, 35, 0};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), state.options));
}

TEST_F(Request, ReadStateTellsTheDefaults) {
  ASSERT_EQ(error_of(Operation::ReadState), 0);
  const auto state = reply<userbus::MemberState>();
  EXPECT_EQ(state.interface_index, -1);
  const std::array<std::uint32_t, userbus::kOptionCount> expected{1, 0, 0, 0, 0, 0, 0};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), state.options));
}

TEST_F(Request, BindTakesKnownInterfacesOnly) {
  EXPECT_EQ(error_of(Operation::Bind, 1001), ENODEV);
  EXPECT_EQ(error_of(Operation::Bind, -1), ENODEV);
  ASSERT_EQ(client_.index_of("can0"), 1001);
  EXPECT_EQ(error_of(Operation::Bind, 1001), 0);
  EXPECT_EQ(error_of(Operation::Bind, 0), 0);
}

TEST_F(Request, FiltersComeBackAsTheyWereSet) {
  std::vector<can_filter> filters(CAN_RAW_FILTER_MAX, can_filter{0x123 | CAN_INV_FILTER, 0x7FF});
  client_.set_filters(filters);

  ASSERT_EQ(error_of(Operation::ReadFilters), 0);
  ASSERT_EQ(client_.reply().size(), filters.size() * sizeof(can_filter));
  EXPECT_EQ(std::memcmp(client_.reply().data(), filters.data(), client_.reply().size()), 0);
}

TEST_F(Request, FiltersAreRefusedIfTheyAreTooManyOrBroken) {
  const std::vector<can_filter> filters(CAN_RAW_FILTER_MAX + 1);
  const auto bytes = std::as_bytes(std::span{filters});

  EXPECT_EQ(error_of(Operation::SetFilters, 0, bytes), EINVAL);
  EXPECT_EQ(error_of(Operation::SetFilters, 0, bytes.first(sizeof(can_filter) + 1)), EINVAL);
  ASSERT_EQ(error_of(Operation::ReadFilters), 0);
  EXPECT_EQ(client_.reply().size(), sizeof(can_filter));
}

TEST_F(Request, NamesAndIndexesOfInterfaces) {
  EXPECT_EQ(index_error("can0"), 0);
  EXPECT_EQ(index_error("vcan12"), 0);
  EXPECT_EQ(index_error("eth0"), ENODEV);
  EXPECT_EQ(index_error(std::string_view{"can0", 5}), ENODEV);

  ASSERT_EQ(error_of(Operation::InterfaceName, 1002), 0);
  EXPECT_EQ(std::memcmp(client_.reply().data(), "vcan12", 6), 0);
  EXPECT_EQ(client_.reply().size(), 6u);
  EXPECT_EQ(error_of(Operation::InterfaceName, 1003), ENODEV);
  EXPECT_EQ(error_of(Operation::InterfaceName, -5), ENODEV);

  ASSERT_EQ(error_of(Operation::Interfaces), 0);
  EXPECT_EQ(client_.reply().size(), 2 * sizeof(userbus::InterfaceEntry));
  EXPECT_EQ(reply<userbus::InterfaceEntry>().index, 1001);
  EXPECT_STREQ(reply<userbus::InterfaceEntry>().name, "can0");
}

TEST_F(Request, StatisticsCountWhatAMemberDid) {
  client_.bind("can0");
  client_.set(OptionName::OwnMessages);
  client_.send("123#");
  client_.send("124#");
  can_frame too_long{};
  too_long.can_dlc = 9;
  client_.send(too_long);

  ASSERT_EQ(error_of(Operation::Statistics), 0);
  const auto bus = reply<userbus::BusStatistics>();
  EXPECT_EQ(bus.frames, 2u);
  EXPECT_EQ(bus.members, 1u);
  userbus::MemberStatistics row{};
  ASSERT_EQ(client_.reply().size(), sizeof bus + sizeof row);
  std::memcpy(&row, &client_.reply()[sizeof bus], sizeof row);
  EXPECT_STREQ(row.name, "raw");
  EXPECT_EQ(row.process, getpid());
  EXPECT_EQ(row.interface_index, 1001);
  EXPECT_EQ(row.sent, 2u);
  EXPECT_EQ(row.received, 2u);
  EXPECT_EQ(row.dropped, 0u);
  EXPECT_EQ(row.refused, 1u);
}

TEST_F(Request, StatisticsOfManyMembersComeInParts) {
  std::list<BusClient> members;
  for (int i = 0; i < 299; ++i) members.emplace_back(hub_.path(), "");

  std::size_t rows = 0;
  for (;;) {
    ASSERT_EQ(error_of(Operation::Statistics, static_cast<int>(rows)), 0);
    EXPECT_EQ(reply<userbus::BusStatistics>().members, 300u);
    const std::size_t more =
        (client_.reply().size() - sizeof(userbus::BusStatistics)) / sizeof(userbus::MemberStatistics);
    if (more == 0) break;
    rows += more;
  }
  EXPECT_EQ(rows, 300u);
}

TEST_F(Request, ThatIsUnknownOrBrokenIsRefused) {
  const std::array<std::byte, 3> three_bytes{};

  EXPECT_EQ(error_of(static_cast<Operation>(1000)), EINVAL);
  EXPECT_EQ(error_of(static_cast<Operation>(0xFFFFFFFF)), EINVAL);
  EXPECT_EQ(error_of(Operation::SetOption), EINVAL);
  EXPECT_EQ(error_of(Operation::SetOption, 0, three_bytes), EINVAL);
  const userbus::Option unknown{.name = static_cast<OptionName>(77), .value = 1};
  EXPECT_EQ(error_of(Operation::SetOption, 0, std::as_bytes(std::span{&unknown, 1})), EINVAL);
}

TEST_F(Request, OfTheBroadcastManagerIsNothingForARawSocket) {
  EXPECT_EQ(error_of(Operation::Broadcast), EOPNOTSUPP);
}

TEST_F(Request, NeedsAName) {
  const os::Descriptor nameless{socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0)};
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, hub_.path().c_str());
  ASSERT_EQ(connect(nameless.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);

  EXPECT_EQ(userbus::ask(nameless.get(), Operation::Hello).error, ENETDOWN);
}

}  // namespace
}  // namespace hub_test
