#include <chrono>
#include <cmath>
#include <vector>

#include "tests/e2e/control_client.hpp"
#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

using nlohmann::json;

struct Control : RunningDaemon {
  static void SetUpTestSuite() { start({.axis = {{"parameters", {{"p1120", 1.0}, {"p1121", 1.0}}}}}); }

  static void run_motor() {
    for (const auto& [word, state] : {std::pair{"205#0600", kReadyToSwitchOn}, std::pair{"205#0700", kSwitchedOn},
                                      std::pair{"305#0F000000800C", kOperationEnabled}}) {
      can->send(word);
      ASSERT_TRUE(wait_for_state(*can, state));
    }
    ASSERT_TRUE(wait_for_drive(*can, "target reached", [](const StatusAndSpeed& drive) {
      return drive.has(kTargetReached) && drive.speed > 0x0C000000;
    }));
  }
};

TEST_F(Control, TellsTheStatusOfTheUnit) {
  const json status = daemon->status();

  EXPECT_EQ(status.at("interface"), served_interface());
  EXPECT_EQ(status.at("node_id"), 5);
  EXPECT_EQ(status.at("nmt_state"), "Operational");
  EXPECT_EQ(status.at("bus").at("link"), "up");
  EXPECT_EQ(status.at("bus").at("dropped"), 0);
  EXPECT_EQ(status.at("axes").size(), 1u);
  EXPECT_EQ(status.at("axes").at(0).at("state"), "Switch on disabled");
  EXPECT_EQ(status.at("axes").at(0).at("statusword"), "0x1640");
}

TEST_F(Control, ExplainsWhyTheAxisDoesNotTurnAndThatItDoes) {
  const auto explanation = [] { return daemon->axisctl({"explain", "1"}).output; };
  ASSERT_TRUE(can->ask("205#0400", "185#6016"));
  EXPECT_NE(explanation().find("OFF2 is given by p0844 = r8890.1: send a controlword with bit 1 = 1.\n"),
            std::string::npos)
      << explanation();

  run_motor();

  EXPECT_EQ(explanation().rfind("It turns at ", 0), 0U) << explanation();
  const fakes::Finished all = daemon->axisctl({"--json", "explain"});
  EXPECT_EQ(json::parse(all.output).at("axes").at(0).at("reasons").size(), 1U) << all.output;
  const fakes::Finished refused = daemon->axisctl({"explain", "2"});
  EXPECT_EQ(refused.status, 4);
  EXPECT_NE(refused.errors.find("AXIS: expected 1, got 2"), std::string::npos) << refused.errors;
}

TEST_F(Control, ALoadIsFeltByTheMotor) {
  run_motor();

  ASSERT_EQ(daemon->axisctl({"load", "1", "5.0"}).status, 0);

  constexpr std::uint32_t kTpdo3 = 0x385;  // 6041h, 6077h in per mille of 7.3 N·m
  EXPECT_TRUE(can->wait_until("385# with more than 60 % torque", [](const canopen::Frame& frame) {
    if (frame.id != kTpdo3 || frame.length != 4) return false;
    return static_cast<std::int16_t>(frame.data[2] | frame.data[3] << 8) > 600;
  }));
  EXPECT_DOUBLE_EQ(daemon->status().at("axes").at(0).at("load_torque_Nm").get<double>(), 5.0);
  EXPECT_EQ(daemon->axisctl({"load", "1", "0"}).status, 0);
}

/// Asks for the status until @p holds says of axis 1 that it is so.
template <class Holds>
bool eventually(const Holds& holds) {
  constexpr std::chrono::seconds kLimit{60};
  const auto end = std::chrono::steady_clock::now() + kLimit;
  while (std::chrono::steady_clock::now() < end)
    if (holds(RunningDaemon::daemon->status().at("axes").at(0))) return true;
  return false;
}

TEST_F(Control, ALoadThatRunsAwayIsHeldAndFrictionStopsTheShaft) {
  const auto speed = [](const json& axis) { return axis.at("speed_rpm").get<double>(); };
  ASSERT_EQ(daemon->axisctl({"load", "1", "50"}).status, 0);
  EXPECT_TRUE(eventually([&](const json& axis) { return speed(axis) < -10799.0; }));
  EXPECT_GE(speed(daemon->status().at("axes").at(0)), -10801.0);
  EXPECT_TRUE(daemon->program().wait_for_output("axis 1: its load drives the shaft to 10800 rpm"));
  EXPECT_EQ(daemon->log_lines("its load drives the shaft"), 1U);
  EXPECT_NE(daemon->axisctl({"explain", "1"}).output.find("The load drives the shaft at -10800 rpm"),
            std::string::npos);

  ASSERT_EQ(daemon->axisctl({"load", "1", "5", "friction"}).status, 0);

  const json axis = daemon->status().at("axes").at(0);
  EXPECT_EQ(axis.at("load_torque_Nm"), 0.0);
  EXPECT_EQ(axis.at("load_friction_Nm"), 5.0);
  EXPECT_TRUE(eventually([&](const json& now) { return std::abs(speed(now)) <= 0.0; }));
  const fakes::Finished refused = daemon->axisctl({"load", "1", "-5", "friction"});
  EXPECT_EQ(refused.status, 4);
  EXPECT_EQ(refused.errors, "axisctl: TORQUE: expected a number 0 to 1000000, got -5.0\n");
  EXPECT_EQ(daemon->axisctl({"load", "1", "5", "spring"}).errors,
            "axisctl: TYPE: expected constant or friction, got \"spring\"\n");
  EXPECT_EQ(daemon->axisctl({"load", "1", "0"}).status, 0);
}

TEST_F(Control, ServesManyClientsAtOnce) {
  constexpr int kClients = 20;
  std::vector<ControlClient> clients;
  for (int i = 0; i < kClients; ++i) clients.emplace_back(daemon->control_socket());

  for (int i = 0; i < kClients; ++i) {
    clients[static_cast<std::size_t>(i)].send(json{{"id", i}, {"method", "status"}}.dump() + '\n');
  }

  for (int i = kClients; i-- > 0;) {
    const json answer = json::parse(clients[static_cast<std::size_t>(i)].line());
    EXPECT_EQ(answer.at("id"), i);
    EXPECT_EQ(answer.at("result").at("node_id"), 5);
  }
}

TEST_F(Control, SurvivesGarbage) {
  ControlClient vandal{daemon->control_socket()};
  ControlClient witness{daemon->control_socket()};

  for (const std::string& line :
       {std::string{"\x00\xFF\xFE garbage", 11}, std::string{"{\"id\":"}, std::string{"[]"}, std::string{},
        std::string(3000, '['), std::string{R"({"id":1,"method":7})"},
        std::string{R"({"id":1,"method":"nonsense"})"},
        std::string{R"({"id":1,"method":"load.set","params":{"axis":9,"torque_Nm":1}})"}}) {
    vandal.send(line + '\n');
    EXPECT_TRUE(json::parse(vandal.line()).contains("error")) << line;
  }

  EXPECT_EQ(witness.ask({{"id", 7}, {"method", "status"}}).at("id"), 7);
  EXPECT_TRUE(can->ask("605#4000100000000000", "585#430010009201FFFF"));
}

TEST_F(Control, HangsUpOnAClientWithoutEnd) {
  ControlClient vandal{daemon->control_socket()};

  vandal.send(std::string(65536, 'x'));

  EXPECT_TRUE(json::parse(vandal.line()).contains("error"));
  EXPECT_THROW(vandal.line(), std::runtime_error);
  EXPECT_EQ(daemon->axisctl({"status"}).status, 0);
}

TEST_F(Control, ADigitalInputAcknowledgesAFaultAndSwitchesTheMotorOn) {
  const auto switches = [](const char* input, const char* state) {
    const fakes::Finished finished = daemon->axisctl({"input", input, state});
    EXPECT_EQ(finished.status, 0) << finished.errors;
  };
  const auto inputs = [] { return daemon->status().at("control_unit").at("inputs"); };
  for (const auto& [request, answer] :
       {std::pair{"605#2BB6410002000000", "585#60B6410000000000"},
        std::pair{"605#233828000204D202", "585#6038280000000000"},     // p2104 = r0722.2
        std::pair{"605#234823000104D202", "585#6048230000000000"}}) {  // p0840 = r0722.1
    ASSERT_TRUE(can->ask(request, answer));
  }
  ASSERT_EQ(daemon->axisctl({"fault", "inject", "1", "F07860"}).status, 0);
  ASSERT_TRUE(wait_for_state(*can, kFault));

  switches("2", "on");
  ASSERT_TRUE(wait_for_state(*can, kSwitchOnDisabled));
  EXPECT_EQ(inputs(), json::array({2}));
  can->send("205#0E00");
  ASSERT_TRUE(wait_for_state(*can, kReadyToSwitchOn));
  switches("1", "on");
  ASSERT_TRUE(wait_for_state(*can, kOperationEnabled));
  EXPECT_EQ(inputs(), json::array({1, 2}));
  switches("1", "off");
  ASSERT_TRUE(wait_for_state(*can, kReadyToSwitchOn));
  switches("2", "off");
  EXPECT_EQ(inputs(), json::array());
}

TEST_F(Control, RefusesAnInputThatIsNone) {
  const auto refusal = [](const char* input) { return daemon->axisctl({"input", input, "on"}).errors; };
  EXPECT_EQ(refusal("18"), "axisctl: INPUT: expected 0 to 17, 20 or 21, got 18\n");
  EXPECT_EQ(refusal("22"), "axisctl: INPUT: expected an integer 0 to 21, got 22\n");
  ASSERT_TRUE(can->ask("605#2BB6410001000000", "585#60B6410000000000"));
  ASSERT_TRUE(can->ask("605#23D8220000010000", "585#60D8220000000000"));  // p0728.8 = 1
  EXPECT_EQ(refusal("8"), "axisctl: INPUT: DI/DO 8 is an output (p0728.8 = 1)\n");
  ASSERT_TRUE(can->ask("605#23D8220000000000", "585#60D8220000000000"));
  EXPECT_EQ(refusal("8"), "");
  EXPECT_EQ(daemon->axisctl({"input", "8", "off"}).status, 0);
}

TEST_F(Control, RefusesAnUnknownFaultInOneLine) {
  const auto finished = daemon->axisctl({"fault", "inject", "1", "1"});

  EXPECT_EQ(finished.status, 4);
  EXPECT_NE(finished.errors.find("no fault or alarm"), std::string::npos) << finished.errors;
}

}  // namespace
}  // namespace e2e
