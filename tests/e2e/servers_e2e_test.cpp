#include <algorithm>
#include <iostream>
#include <map>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"
#include "tests/sdo/parameter_sweep.hpp"

namespace e2e {
namespace {

using sdo_test::ListedParameter;
using sdo_test::ServerTransfer;

constexpr unsigned kDriveObjects = 9;
constexpr std::uint16_t kWindow = 0x41B6;  // p8630
constexpr std::uint32_t kNoObject = 0x06020000, kNoSubIndex = 0x06090011;

/// A unit of eight axes.
struct Parameters : RunningDaemon {
  static void SetUpTestSuite() { start({.axes = 8}); }

  /// Opens the window on drive object @p object.
  void look_at(unsigned object) { ASSERT_EQ(client.download(kWindow, 0, object, 2), 0U); }

  BusSdoClient client;
};

TEST_F(Parameters, OfEachDriveObjectAreSeenThroughTheWindow) {
  unsigned entries = 0;
  for (unsigned object = 1; object <= kDriveObjects; ++object) {
    look_at(object);
    for (const ListedParameter& parameter : sdo_test::listed_parameters(object == 1)) {
      const auto upload = client.upload(parameter.object, parameter.sub_index);
      EXPECT_EQ(upload.abort_code, 0U) << parameter.name;
      EXPECT_EQ(upload.bytes.size(), parameter.size) << parameter.name;
      ++entries;
    }
  }
  std::cout << entries << " parameters through the window\n";
}

TEST_F(Parameters, AreAllThatTheWindowShows) {
  constexpr std::uint16_t kFirst = 0x2000, kLast = 0x470F;
  unsigned absent = 0, beyond = 0;
  for (const unsigned object : {1U, 9U}) {
    look_at(object);
    std::map<std::uint16_t, std::uint8_t> last;
    for (const ListedParameter& p : sdo_test::listed_parameters(object == 1))
      last[p.object] = std::max(last[p.object], p.sub_index);
    for (std::uint16_t index = kFirst; index <= kLast; ++index) {
      const auto known = last.find(index);
      const auto sub_index = static_cast<std::uint8_t>(known == last.end() ? 0 : known->second + 1);
      const bool is_always_there = index == kWindow;
      const bool is_whole_window = known != last.end() && known->second == UINT8_MAX;
      if (is_always_there || is_whole_window || sdo_test::is_named_elsewhere(index)) continue;
      EXPECT_EQ(client.upload(index, sub_index).abort_code, known == last.end() ? kNoObject : kNoSubIndex)
          << std::hex << index;
      ++(known == last.end() ? absent : beyond);
    }
  }
  std::cout << absent << " absent parameters, " << beyond << " absent indices\n";
}

/// One server of each drive object, with a transfer under way on every one of them at any time.
TEST_F(Parameters, AreReadThroughNineServersAtOnce) {
  std::vector<ServerTransfer> servers;
  std::vector<std::uint32_t> responses;
  for (unsigned object = 1; object <= kDriveObjects; ++object) {
    const ServerTransfer server{.request = 0x610 + object,
                                .response = 0x590 + object,
                                .parameters = sdo_test::listed_parameters(object == 1)};
    const auto record = static_cast<std::uint16_t>(0x1200 + object);
    ASSERT_EQ(client.download(record, 1, server.request, 4), 0U);
    ASSERT_EQ(client.download(record, 2, server.response, 4), 0U);
    servers.push_back(server);
    responses.push_back(server.response);
  }
  can->listen_to(responses);
  can->forget();

  unsigned answers = 0;
  for (bool asked = true; asked;) {
    asked = false;
    unsigned waiting = 0;
    for (const ServerTransfer& server : servers) {
      const auto request = server.request_frame();
      if (request) can->send(*request);
      waiting += request ? 1U : 0U;
    }
    for (; waiting > 0; --waiting, ++answers, asked = true) {
      const auto answer = can->next();
      ASSERT_TRUE(answer);
      const auto server = std::ranges::find(servers, answer->id, &ServerTransfer::response);
      ASSERT_NE(server, servers.end());
      server->take_answer(*answer);
    }
  }
  std::cout << answers << " parameters through nine servers\n";
}

}  // namespace
}  // namespace e2e
