// The program with more than one unit: each has its node and its state, and one control socket serves both.
#include "daemon/program/program.hpp"

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

/// Two units on one bus, on one thread or on two; the program itself runs in a thread of the test.
class TwoUnits : public testing::TestWithParam<std::size_t> {
 protected:
  TwoUnits() {
    setenv("NOTIFY_SOCKET", folder.path("notify").c_str(), 1);
    program.emplace(assignment, log);
    thread = std::thread{[this] { program->run(); }};
  }
  ~TwoUnits() override {
    end();
    unsetenv("NOTIFY_SOCKET");
  }
  void end() {
    if (!thread.joinable()) return;
    EXPECT_TRUE(ask("", "quit").contains("result"));
    thread.join();
  }

  /// The answer to @p method of unit @p name, of the program if that is empty.
  json ask(const std::string& name, const char* method, json params = json::object()) {
    if (!name.empty()) params["unit"] = name;
    e2e::ControlClient client{assignment.control.path};
    return client.ask({{"id", 1}, {"method", method}, {"params", params}});
  }
  json status(const std::string& name) { return ask(name, "status").at("result"); }
  Configuration unit(int node_id) const {
    Configuration configuration;
    configuration.address = bus::parse_address("unix:" + hub.path()).value();
    configuration.node_id = node_id;
    return configuration;
  }

  hub_test::RunningHub hub;
  fakes::TemporaryDirectory folder;
  e2e::NotifySocket manager{folder.path("notify")};
  Assignment assignment{.units = {unit(5), unit(6)},
                        .threads = GetParam(),
                        .control = {.path = folder.path("axisd.sock")},
                        .state_root = folder.path("state")};
  Log log{LogLevel::Error};
  std::optional<Program> program;
  std::thread thread;
};

TEST_P(TwoUnits, AreReadyWhenBothAre) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  EXPECT_EQ(manager.messages().size(), 2U) << "the first one tells its STATUS only";
  EXPECT_EQ(manager.messages().front(), "STATUS=1 of 2 units on their bus");
}

TEST_P(TwoUnits, AnswerForThemselves) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  EXPECT_EQ(status("5").at("node_id"), 5);
  EXPECT_EQ(status("6").at("node_id"), 6);

  EXPECT_EQ(ask("6", "load.set", {{"axis", 1}, {"torque_Nm", 3}}).at("result"), json::object());

  EXPECT_EQ(status("5").at("axes").at(0).at("load_torque_Nm"), 0.0);
  EXPECT_EQ(status("6").at("axes").at(0).at("load_torque_Nm"), 3.0);
}

TEST_P(TwoUnits, SaveTheirStatesAtPowerOff) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  end();
  std::size_t saved = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{folder.path("state")})
    if (entry.path().filename() == "retained.bin") ++saved;
  EXPECT_EQ(saved, 2U);
}

TEST_P(TwoUnits, AreNamed) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  const json units = ask("", "units").at("result").at("units");
  ASSERT_EQ(units.size(), 2U);
  const std::string first = units[0].at("unit");
  EXPECT_TRUE(first.ends_with("/5")) << first;

  EXPECT_EQ(status(first).at("node_id"), 5);
  EXPECT_EQ(status("unix:" + hub.path() + "/6").at("node_id"), 6);
}

TEST_P(TwoUnits, AreToBeChosen) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  const json neither = ask("", "status").at("error");
  EXPECT_EQ(neither.at("message").get<std::string>().find("unit: expected one of "), 0U) << neither;
  EXPECT_EQ(ask("7", "status").at("error").at("message"), "unit: expected a unit of this daemon, got \"7\"");
  EXPECT_EQ(ask("", "status", {{"unit", true}}).at("error").at("message"),
            "unit: expected a node-ID or BUS/NODE, got true");
}

TEST_P(TwoUnits, AreSwitchedOffAndOnOneByOne) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  EXPECT_EQ(ask("6", "load.set", {{"axis", 1}, {"torque_Nm", 3}}).at("result"), json::object());

  EXPECT_EQ(ask("6", "unit.off").at("result"), json::object());
  EXPECT_TRUE(ask("6", "status").at("error").at("message").get<std::string>().ends_with("(unit.on)"));
  EXPECT_EQ(status("5").at("node_id"), 5) << "the other one runs on";
  EXPECT_EQ(ask("6", "unit.off").at("result"), json::object()) << "it is off already";

  EXPECT_EQ(ask("6", "unit.on").at("result"), json::object());
  EXPECT_EQ(status("6").at("axes").at(0).at("load_torque_Nm"), 0.0) << "as configured";
  EXPECT_EQ(status("6").at("memory").at("retained"), "in use") << "what survives was on the disk";
}

TEST_P(TwoUnits, TellWhoHasSubscribedWhatHappens) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  e2e::ControlClient client{assignment.control.path};
  EXPECT_EQ(
      client.ask({{"id", 1}, {"method", "events.subscribe"}, {"params", {{"kinds", {"parameter", "power"}}}}})
          .at("result"),
      json::object());

  ASSERT_TRUE(ask("6", "parameter.write", {{"parameter", "p1120"}, {"value", 2.5}}).contains("result"));
  const json written = json::parse(client.line()).at("event");
  EXPECT_TRUE(written.at("unit").get<std::string>().ends_with("/6")) << written;
  EXPECT_EQ(written.at("kind"), "parameter");
  EXPECT_EQ(written.at("value"), 2.5);
  EXPECT_EQ(written.at("by"), "control");

  ASSERT_TRUE(ask("5", "unit.off").contains("result"));
  const json off = json::parse(client.line()).at("event");
  EXPECT_EQ(off.at("kind"), "power");
  EXPECT_EQ(off.at("on"), false);
  ASSERT_TRUE(ask("5", "unit.on").contains("result"));
  EXPECT_EQ(json::parse(client.line()).at("event").at("on"), true);

  client.send("{\"id\": 2, \"method\": \"events.unsubscribe\"}\n");
  EXPECT_EQ(json::parse(client.line()).at("id"), 2);
}

TEST_P(TwoUnits, TellWhatSignalsAreAgainAndAgain) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  e2e::ControlClient client{assignment.control.path};
  const json params{{"unit", "5"}, {"signals", {"1/speed", "dc_voltage"}}, {"period_ms", 5}};
  EXPECT_EQ(client.ask({{"id", 1}, {"method", "samples.subscribe"}, {"params", params}}).at("result"),
            json::object());

  double before = -1.0;
  for (int i = 0; i < 3; ++i) {
    const json sample = json::parse(client.line()).at("sample");
    EXPECT_EQ(sample.at("values").size(), 2U);
    EXPECT_EQ(sample.at("values").at(0), 0.0);
    EXPECT_GT(sample.at("t").get<double>(), before);
    before = sample.at("t");
  }

  EXPECT_EQ(ask("5", "samples.subscribe", {{"signals", {"1/no_such"}}, {"period_ms", 5}}).at("error").at("code"),
            "not-found");
}

TEST_P(TwoUnits, TellSamplesInLinesOfSeveral) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  e2e::ControlClient client{assignment.control.path};
  const json params{{"unit", "5"}, {"signals", {"1/speed", "dc_voltage"}}, {"period_ms", 1}, {"batch_ms", 20}};
  EXPECT_EQ(client.ask({{"id", 1}, {"method", "samples.subscribe"}, {"params", params}}).at("result"),
            json::object());
  double before = -1.0;
  for (int i = 0; i < 5; ++i) {
    const json samples = json::parse(client.line()).at("samples");
    ASSERT_EQ(samples.at("values").size(), 2U);
    ASSERT_FALSE(samples.at("t").empty());
    EXPECT_EQ(samples.at("values").at(1).size(), samples.at("t").size());
    for (const double time : samples.at("t")) {
      EXPECT_GT(time, before);
      before = time;
    }
  }
  EXPECT_EQ(ask("5", "samples.subscribe", {{"signals", {"1/no"}}, {"period_ms", 1}, {"batch_ms", 20}})
                .at("error")
                .at("code"),
            "not-found");
}

TEST_P(TwoUnits, TellSamplesAndFramesAgainAfterTheUnitWasOff) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  e2e::ControlClient samples{assignment.control.path};
  const json params{{"unit", "5"}, {"signals", {"1/speed"}}, {"period_ms", 1}, {"batch_ms", 20}};
  samples.ask({{"id", 1}, {"method", "samples.subscribe"}, {"params", params}});
  double before = json::parse(samples.line()).at("samples").at("t").at(0);
  e2e::ControlClient frames{assignment.control.path};
  frames.ask({{"id", 1}, {"method", "frames.subscribe"}, {"params", {{"unit", "5"}}}});
  EXPECT_TRUE(ask("5", "unit.off").contains("result"));
  EXPECT_TRUE(ask("5", "unit.on").contains("result"));
  const auto is_boot_up = [](const std::string& text) { return text.ends_with(" S 705#00"); };
  EXPECT_TRUE(is_boot_up(json::parse(frames.line()).at("frames").at("frames").at(0)));
  double time = 0.0;
  while ((time = json::parse(samples.line()).at("samples").at("t").at(0)) > before) before = time;
  EXPECT_LT(time, before);  // the unit has begun anew, and so has its time
  EXPECT_EQ(frames.ask({{"id", 2}, {"method", "frames.unsubscribe"}}).at("result"), json::object());
  EXPECT_EQ(ask("5", "unit.off").count("result"), 1U);
  EXPECT_EQ(ask("5", "frames.subscribe").at("error").at("code"), "off");
}

TEST_P(TwoUnits, AnswerWhateverElseAClientAsks) {
  ASSERT_TRUE(manager.wait_for("READY=1"));
  for (const char* const line : {"nonsense", "[1]", R"({"method": 1})", R"({"method": "status", "params": []})",
                                 R"({"method": "events.subscribe", "params": {"kinds": ["weather"]}})",
                                 R"({"method": "events.subscribe", "params": {"kinds": 7}})",
                                 R"({"method": "samples.subscribe", "params": {"unit": "5", "signals": {}}})"}) {
    e2e::ControlClient client{assignment.control.path};
    client.send(std::string{line} + '\n');
    const json answer = json::parse(client.line());
    EXPECT_TRUE(answer.at("error").contains("code")) << line;
    EXPECT_FALSE(answer.at("error").at("message").get<std::string>().empty()) << line;
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, TwoUnits, testing::Values(1U, 2U));

}  // namespace
}  // namespace axisd
