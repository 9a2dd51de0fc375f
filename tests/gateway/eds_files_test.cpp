#include "gateway/api/eds_files.hpp"

#include <fstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "control/protocol.hpp"
#include "gateway/server/http_server.hpp"
#include "tests/gateway/gateway_fixture.hpp"

namespace gateway {
namespace {

/// A daemon of units of both profiles; one of them says nothing of its own.
std::string answer_of_units(const std::string& line) {
  const control::Request request = control::parse_request(line).value();
  return control::result_line(request.id, {{"units",
                                            {{{"unit", "vcan0/2"}, {"axes", 2}},
                                             {{"unit", "vcan0/5"}, {"axes", 1}, {"profile", "s120"}},
                                             {{"unit", "vcan0/6"}, {"axes", 1}, {"profile", "cia402"}},
                                             {{"unit", "vcan0/7"}, {"axes", 2}, {"profile", "cia402"}},
                                             {{"unit", "vcan0/8"}, {"axes", 3}, {"profile", "cia402"}}}}});
}

/// A server that answers the path /vcan0/N by the EDS of that unit.
class EdsFilesTest : public testing::Test, public HttpServer::Requests {
 protected:
  void SetUp() override {
    for (const char* const name : {"axisd.eds", "axisd-2-axes.eds", "axisd-cia402.eds", "axisd-cia402-2-axes.eds"})
      std::ofstream{folder.path(name)} << "this is " << name;
    wait_until(events, [this] { return !daemons.units().empty(); });
  }
  void on_headers(Exchange&) override {}
  void on_request(const std::shared_ptr<Exchange>& exchange) override {
    const std::string unit = exchange->request().path.substr(1);
    eds.answer(exchange, unit, *daemons.find(unit).value());
  }
  std::string get(const std::string& unit) {
    HttpClient client{events, server.addresses().front().port.value()};
    client.send("GET /" + unit + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
    return client.rest();
  }

  fakes::TemporaryDirectory folder;
  axisd::ServiceEvents events{[] {}};
  axisd::Log log{axisd::LogLevel::Error};
  FakeDaemon daemon{events, folder.path("axisd.sock"), answer_of_units};
  Daemons daemons{events, std::make_unique<SocketReach>(std::vector{folder.path("axisd.sock")}), log};
  EdsFiles eds{folder.path("")};
  HttpServer server{events, {{"127.0.0.1", 0}}, *this};
};

TEST_F(EdsFilesTest, IsThatOfTheProfileAndTheNumberOfAxes) {
  const std::pair<const char*, const char*> expected[]{{"vcan0/2", "axisd-2-axes.eds"},
                                                       {"vcan0/5", "axisd.eds"},
                                                       {"vcan0/6", "axisd-cia402.eds"},
                                                       {"vcan0/7", "axisd-cia402-2-axes.eds"}};
  for (const auto& [unit, file] : expected)
    for (int turn = 0; turn < 2; ++turn) {  // read, and kept
      const std::string answer = get(unit);
      EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 ")) << answer;
      EXPECT_TRUE(answer.ends_with(std::string{"this is "} + file)) << answer;
      EXPECT_NE(answer.find(std::string{"filename=\""} + file + '"'), std::string::npos) << answer;
    }
}

TEST_F(EdsFilesTest, SaysOfWhichKindNoneIsInstalled) {
  const std::string answer = get("vcan0/8");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 404 ")) << answer;
  EXPECT_NE(answer.find("no EDS of a unit of profile cia402 with 3 axes"), std::string::npos) << answer;
}

}  // namespace
}  // namespace gateway
