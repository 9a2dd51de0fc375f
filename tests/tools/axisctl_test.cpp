#include <fstream>
#include <iterator>

#include "tests/tools/axisctl_fixture.hpp"

namespace {

using fakes::ControlServer;
using fakes::Finished;
using nlohmann::json;

struct Request {
  std::vector<std::string> words;
  json expected;
};

TEST_F(Axisctl, SendsWhatEachCommandMeans) {
  const std::vector<Request> requests{
      {{"fault", "inject", "1", "7860"},
       {{"method", "fault.inject"}, {"params", {{"axis", 1}, {"number", 7860}}}}},
      {{"fault", "inject", "2", "F07860"},
       {{"method", "fault.inject"}, {"params", {{"axis", 2}, {"number", 7860}}}}},
      {{"fault", "inject", "8", "F7860"},
       {{"method", "fault.inject"}, {"params", {{"axis", 8}, {"number", 7860}}}}},
      {{"fault", "inject", "1", "f30001"},
       {{"method", "fault.inject"}, {"params", {{"axis", 1}, {"number", 30001}}}}},
      {{"fault", "inject", "0", "F01000", "7"},
       {{"method", "fault.inject"}, {"params", {{"axis", 0}, {"number", 1000}, {"value", 7}}}}},
      {{"explain"}, {{"method", "explain"}}},
      {{"explain", "2"}, {{"method", "explain"}, {"params", {{"axis", 2}}}}},
      {{"fault", "ack", "3"}, {{"method", "fault.ack"}, {"params", {{"axis", 3}}}}},
      {{"load", "1", "2.5"}, {{"method", "load.set"}, {"params", {{"axis", 1}, {"torque_Nm", 2.5}}}}},
      {{"load", "1", "-0.75"}, {{"method", "load.set"}, {"params", {{"axis", 1}, {"torque_Nm", -0.75}}}}},
      {{"load", "1", "+1e1"}, {{"method", "load.set"}, {"params", {{"axis", 1}, {"torque_Nm", 10.0}}}}},
      {{"load", "1", "5", "friction"},
       {{"method", "load.set"}, {"params", {{"axis", 1}, {"torque_Nm", 5.0}, {"type", "friction"}}}}},
      {{"supply", "0"}, {{"method", "supply.set"}, {"params", {{"line_voltage_V", 0.0}}}}},
      {{"encoder", "2", "loss"}, {{"method", "encoder.fail"}, {"params", {{"axis", 2}, {"defect", "loss"}}}}},
      {{"input", "2", "on"}, {{"method", "input.set"}, {"params", {{"input", 2}, {"state", true}}}}},
      {{"input", "21", "off"}, {{"method", "input.set"}, {"params", {{"input", 21}, {"state", false}}}}},
      {{"bus", "restart"}, {{"method", "bus.restart"}}},
      {{"quit"}, {{"method", "quit"}}},
  };
  for (const Request& request : requests) {
    std::filesystem::remove(socket());
    ControlServer server{socket(), kDone};
    json expected = request.expected;
    expected["id"] = 1;

    const Finished run_ = run(request.words);

    EXPECT_EQ(run_.status, 0) << run_.errors;
    EXPECT_EQ(run_.output + run_.errors, "");
    EXPECT_EQ(json::parse(server.request()), expected);
  }
}

TEST_F(Axisctl, PrintsAReasonALine) {
  const json two = {"OFF2 is given.", "The node is Stopped."};
  {
    ControlServer server{socket(), answer({{"reasons", two}})};
    EXPECT_EQ(run({"explain", "1"}).output, "OFF2 is given.\nThe node is Stopped.\n");
  }
  std::filesystem::remove(socket());
  ControlServer server{
      socket(), answer({{"axes", {{{"axis", 1}, {"reasons", two}}, {{"axis", 2}, {"reasons", {"It turns."}}}}}})};

  EXPECT_EQ(run({"explain"}).output, "axis 1\n  OFF2 is given.\n  The node is Stopped.\naxis 2\n  It turns.\n");
}

TEST_F(Axisctl, ShowsWhatAnAnswerHoldsBesides) {
  ControlServer server{socket(), answer({{"acknowledged", 2}, {"left", "F07860"}})};

  EXPECT_EQ(run({"fault", "ack", "1"}).output, "acknowledged: 2\nleft: F07860\n");
}

TEST_F(Axisctl, PrintsNoControlCharacters) {
  const std::string wild =
      "\x1B[2J\x7F\xC2\x9B"
      "1m M\xC3\xBCller\n";
  const std::string tame = R"(\u001b[2J\u007f\u009b1m M)"
                           "\xC3\xBC"
                           R"(ller\u000a)";
  {
    ControlServer server{socket(), answer({{wild, wild}})};
    EXPECT_EQ(run({"fault", "ack", "1"}).output, tame + ": " + tame + "\n");
  }
  std::filesystem::remove(socket());
  {
    ControlServer server{socket(), R"({"id":1,"error":{"message":"\u001b[2J"}})"
                                   "\n"};
    EXPECT_EQ(run({"fault", "ack", "1"}).errors, R"(axisctl: \u001b[2J)"
                                                 "\n");
  }
  std::filesystem::remove(socket());
  ControlServer server{socket(), answer({{"name", "\x7F\xC2\x9B"}})};
  EXPECT_EQ(run({"--json", "status"}).output, R"({"name":"\u007f\u009b"})"
                                              "\n");
}

TEST_F(Axisctl, SaysThatNoDaemonAnswers) {
  const Finished run_ = run({"status"});

  EXPECT_EQ(run_.status, 5);
  EXPECT_EQ(run_.errors, "axisctl: " + socket() + ": no daemon answers here (No such file or directory)\n");
}

TEST_F(Axisctl, SaysThatASocketWasLeftByADeadDaemon) {
  { const ControlServer dead{socket(), kDone}; }

  const Finished run_ = run({"status"});

  EXPECT_EQ(run_.status, 5);
  EXPECT_EQ(run_.errors, "axisctl: " + socket() + ": no daemon answers here (Connection refused)\n");
}

TEST_F(Axisctl, SaysThatAPathIsTooLongForASocket) {
  const std::string path(201, '/');

  const Finished run_ = run({"--socket", path, "status"});

  EXPECT_EQ(run_.status, 5);
  EXPECT_EQ(run_.errors, "axisctl: " + path + ": too long for a socket: 201 bytes, at most 107\n");
}

TEST_F(Axisctl, PassesTheMessageOfTheDaemonOn) {
  ControlServer server{socket(), "{\"id\":1,\"error\":{\"message\":\"axis 9: the unit has 2\"}}\n"};

  const Finished run_ = run({"fault", "ack", "9"});

  EXPECT_EQ(run_.status, 1);
  EXPECT_EQ(run_.output, "");
  EXPECT_EQ(run_.errors, "axisctl: axis 9: the unit has 2\n");
}

TEST_F(Axisctl, ComplainsInTheWordsOfTheCommandLine) {
  const auto complaint = [&](const std::string& message, const std::vector<std::string>& words) {
    std::filesystem::remove(socket());
    ControlServer server{socket(), json{{"id", 1}, {"error", {{"message", message}}}}.dump() + "\n"};
    return run(words).errors;
  };

  EXPECT_EQ(complaint("torque_Nm: expected a number 0 to 1, got 5.0", {"load", "1", "5"}),
            "axisctl: TORQUE: expected a number 0 to 1, got 5.0\n");
  EXPECT_EQ(complaint("type: expected constant or friction, got \"x\"", {"load", "1", "5", "x"}),
            "axisctl: TYPE: expected constant or friction, got \"x\"\n");
  EXPECT_EQ(complaint("axis: expected 1, got 3", {"load", "3", "5"}), "axisctl: AXIS: expected 1, got 3\n");
  EXPECT_EQ(complaint("line_voltage_V: expected less", {"supply", "5000"}), "axisctl: VOLTAGE: expected less\n");
  EXPECT_EQ(complaint("defect: expected none", {"encoder", "1", "x"}), "axisctl: DEFECT: expected none\n");
  EXPECT_EQ(complaint("number: 1 is no fault", {"fault", "inject", "1", "1"}), "axisctl: NUMBER: 1 is no fault\n");
}

TEST_F(Axisctl, ReadsTheLongestAnswerThereMayBe) {
  json result{{"text", ""}};
  const std::size_t rest = 65'536 - answer(result).size();
  result["text"] = std::string(rest, 'x');
  ControlServer server{socket(), answer(result)};

  EXPECT_EQ(run({"status", "--json"}).output, result.dump() + "\n");
}

TEST_F(Axisctl, RefusesWrongUsage) {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"dance"},
      {"status", "now"},
      {"--bogus", "status"},
      {"fault"},
      {"fault", "inject"},
      {"fault", "inject", "1"},
      {"fault", "inject", "X", "7860"},
      {"fault", "inject", "1", "7860", "4294967296"},
      {"fault", "inject", "1", "7860", "x"},
      {"load", "0", "1"},
      {"fault", "inject", "-1", "7860"},
      {"fault", "inject", "1x", "7860"},
      {"fault", "inject", "99999999999", "7860"},
      {"fault", "inject", "1", "X07850"},
      {"fault", "inject", "1", "F"},
      {"fault", "inject", "1", "0"},
      {"fault", "inject", "1", "65536"},
      {"fault", "inject", "1", "78.60"},
      {"fault", "inject", "1", "7860", "2", "3"},
      {"fault", "ack"},
      {"fault", "ack", "one"},
      {"load", "1"},
      {"load", "1", "5", "friction", "now"},
      {"help", "dance"},
      {"help", "fault", "status"},
      {"load", "1", "much"},
      {"load", "1", "nan"},
      {"load", "1", "inf"},
      {"load", "1", "1e999"},
      {"load", "1", "5Nm"},
      {"load", "x", "5"},
      {"input", "2"},
      {"input", "two", "on"},
      {"input", "2", "1"},
      {"--node-id", "-1", "status"},
      {"--node-id", "128", "status"},
      {"--node-id", "two", "status"},
      {"--socket"},
  };
  ControlServer server{socket(), kDone};
  for (const auto& words : wrong) {
    const Finished run_ = run(words);

    EXPECT_EQ(run_.status, 2) << testing::PrintToString(words);
    EXPECT_EQ(run_.output, "");
    EXPECT_TRUE(run_.errors.starts_with("axisctl: ")) << run_.errors;
  }
  EXPECT_EQ(server.request(), "");
}

TEST_F(Axisctl, NamesTheWordThatIsWrong) {
  EXPECT_EQ(run({"input", "2", "high"}).errors, "axisctl: STATE: expected on or off, got \"high\"\n");
  EXPECT_EQ(run({"load", "X", "1"}).errors, "axisctl: AXIS: expected a number from 1, got \"X\"\n");
  EXPECT_EQ(run({"load", "1", "much"}).errors, "axisctl: TORQUE: expected a number of N·m, got \"much\"\n");
  EXPECT_EQ(run({"fault", "inject", "1", "X1"}).errors,
            "axisctl: NUMBER: expected a number such as 7860, F07860 or A07850, got \"X1\"\n");
}

TEST_F(Axisctl, SaysWhatAnUnknownSubcommandIsLikelyMeantToBe) {
  EXPECT_EQ(run({"statsu"}).errors, "axisctl: unknown subcommand statsu, did you mean status?\n");
  EXPECT_EQ(run({"--json", "stauts"}).errors, "axisctl: unknown subcommand stauts, did you mean status?\n");
  EXPECT_EQ(run({"fault", "injct", "1", "7860"}).errors,
            "axisctl: unknown subcommand injct, did you mean inject?\n");
  EXPECT_TRUE(run({"dance"}).errors.starts_with(
      "axisctl: unknown subcommand dance, expected one of: status, explain, state, "));
  EXPECT_EQ(run({"bus", "start"}).errors.substr(0, 47), "axisctl: unknown subcommand start, did you mean");
  EXPECT_TRUE(
      run({"fault", "quit"}).errors.starts_with("axisctl: unknown subcommand quit, expected one of: inject, ack"));
  EXPECT_TRUE(run({"fault"}).errors.starts_with("axisctl: expected a subcommand: inject, ack"));
  EXPECT_EQ(run({"help", "laod"}).errors, "axisctl: unknown subcommand laod, did you mean load?\n");
}

TEST_F(Axisctl, HelpsAsASubcommandToo) {
  EXPECT_EQ(run({"help"}).output, run({"--help"}).output);
  EXPECT_EQ(run({"help", "load"}).output, run({"load", "--help"}).output);
  EXPECT_EQ(run({"help", "fault", "inject"}).output, run({"fault", "inject", "--help"}).output);
  const Finished load = run({"help", "load"});
  EXPECT_EQ(load.status, 0);
  EXPECT_NE(load.output.find("Usage: axisctl load"), std::string::npos) << load.output;
  EXPECT_NE(load.output.find("friction: against the motion"), std::string::npos) << load.output;
  const std::string all = run({"help"}).output;
  EXPECT_NE(all.find("Act on the CAN controller"), std::string::npos) << all;
}

TEST_F(Axisctl, HasAPageThatIsUpToDate) {
  std::ifstream file{SOURCE_FOLDER "/docs/reference/axisctl-commands.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};

  EXPECT_TRUE(run({"--completion", "markdown"}).output == page)
      << "docs/reference/axisctl-commands.md: cmake --build BUILD --target update_generated";
}

TEST_F(Axisctl, ExplainsItself) {
  const Finished help = run({"--help"});
  const Finished version = run({"--version"});

  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.output.find("fault"), std::string::npos);
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.output.rfind("axisctl ", 0), 0u);
}

}  // namespace
