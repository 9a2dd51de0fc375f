// The program with more than one unit: each has its bus, state and control socket, and none keeps another waiting.
#include "daemon/program/program.hpp"

#include <array>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/can/hub/running_hub.hpp"
#include "tests/e2e/control_client.hpp"
#include "tests/e2e/notify_socket.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Two units on one bus, run in a thread of the test.
class TwoUnits : public testing::Test {
 protected:
  TwoUnits() {
    setenv("NOTIFY_SOCKET", folder.path("notify").c_str(), 1);
    program.emplace(assignments, folder.path("state"), log);
    thread = std::thread{[this] { program->run(); }};
  }
  ~TwoUnits() override {
    end();
    unsetenv("NOTIFY_SOCKET");
  }
  void end() {
    if (!thread.joinable()) return;
    EXPECT_TRUE(ask(0, "quit").contains("result"));
    thread.join();
  }

  /// The answer of unit @p number to @p method.
  json ask(std::size_t number, const char* method, const json& params = json::object()) {
    e2e::ControlClient client{assignments.at(number).control};
    return client.ask({{"id", 1}, {"method", method}, {"params", params}});
  }
  json status(std::size_t number) { return ask(number, "status").at("result"); }
  Assignment assignment(int node_id) const {
    Assignment unit;
    unit.configuration.address = bus::parse_address("unix:" + hub.path()).value();
    unit.configuration.node_id = node_id;
    unit.control = folder.path("node-" + std::to_string(node_id) + ".sock");
    return unit;
  }

  hub_test::RunningHub hub;
  fakes::TemporaryDirectory folder;
  e2e::NotifySocket manager{folder.path("notify")};
  std::array<Assignment, 2> assignments{assignment(5), assignment(6)};
  Log log{LogLevel::Error};
  std::optional<Program> program;
  std::thread thread;
};

TEST_F(TwoUnits, AreReadyWhenBothAre) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  EXPECT_EQ(manager.messages().size(), 2U) << "the first one tells its STATUS only";
  EXPECT_NE(manager.messages().front().find("STATUS=node "), std::string::npos);
}

TEST_F(TwoUnits, AnswerForThemselves) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  EXPECT_EQ(status(0).at("node_id"), 5);
  EXPECT_EQ(status(1).at("node_id"), 6);

  EXPECT_EQ(ask(1, "load.set", {{"axis", 1}, {"torque_Nm", 3}}).at("result"), json::object());

  EXPECT_EQ(status(0).at("axes").at(0).at("load_torque_Nm"), 0.0);
  EXPECT_EQ(status(1).at("axes").at(0).at("load_torque_Nm"), 3.0);
}

TEST_F(TwoUnits, SaveTheirStatesAtPowerOff) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  end();
  std::size_t saved = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder.path("state")})
    if (entry.path().filename() == "retained.bin") ++saved;
  EXPECT_EQ(saved, 2U);
}

}  // namespace
}  // namespace axisd
