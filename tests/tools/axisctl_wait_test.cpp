// Subcommands of axisctl that are more than a row of the protocol.
#include "tests/tools/axisctl_fixture.hpp"

namespace {

using fakes::ControlServer;
using fakes::Finished;
using nlohmann::json;

const json kStatus = {
    {"nmt_state", "Operational"},
    {"bus", {{"link", "up"}}},
    {"control_unit", {{"faults", json::array()}}},
    {"axes",
     {{{"axis", 1}, {"state", "Operation enabled"}, {"faults", json::array()}},
      {{"axis", 2}, {"state", "Fault"}, {"faults", {{{"number", 7860}, {"text", "External"}}}}}}}};

/// Exit statuses of `axisctl wait` with the unit as above.
struct Waiting : Axisctl {
  int wait(std::vector<std::string> words) const {
    std::filesystem::remove(socket());
    ControlServer server{socket(), answer(kStatus)};
    words.insert(words.begin(), "wait");
    return run(words).status;
  }
};

TEST_F(Waiting, EndsWhenItHolds) {
  EXPECT_EQ(wait({"ready"}), 0);
  EXPECT_EQ(wait({"nmt", "operational"}), 0);
  EXPECT_EQ(wait({"state", "1", "operation-enabled"}), 0);
  EXPECT_EQ(wait({"state", "2", "FAULT"}), 0);
  EXPECT_EQ(wait({"fault"}), 0);
  EXPECT_EQ(wait({"fault", "2", "F07860"}), 0);
  EXPECT_EQ(wait({"no-fault", "1"}), 0);
}

TEST_F(Waiting, SaysWhatThereIsNotToWaitFor) {
  EXPECT_EQ(wait({"state", "1", "dancing"}), 2);
  EXPECT_EQ(wait({"nmt", "dancing"}), 2);
  EXPECT_EQ(wait({"fault", "2", "X1"}), 2);
  EXPECT_EQ(wait({"value", "1/speed", "above", "5"}), 2);
  EXPECT_EQ(wait({"value", "1/speed", "gt", "fast"}), 2);
  EXPECT_EQ(wait({"state", "9", "fault"}), 4);
  EXPECT_EQ(wait({"ready", "--timeout", "-1"}), 2);
}

TEST_F(Waiting, EndsWithItsLimit) {
  const Finished run_ = run({"wait", "ready", "--timeout", "0.05"});

  EXPECT_EQ(run_.status, 6);
  EXPECT_NE(run_.errors.find("it has not come true within 0.05 s"), std::string::npos) << run_.errors;
}

TEST_F(Waiting, DoesNotWaitForAUnitThatIsNotThere) {
  EXPECT_EQ(run({"wait", "state", "1", "fault", "--timeout", "60"}).status, 5);
}

TEST_F(Axisctl, ShowsSamplesAndEventsAsTheyCome) {
  {
    ControlServer server{socket(), answer(json::object()) +
                                       R"({"sample":{"unit":"vcan0/2","t":1.5,"values":[2.5]}})"
                                       "\n"};
    EXPECT_EQ(run({"watch", "1/speed", "--count", "1", "--json"}).output,
              R"({"t":1.5,"unit":"vcan0/2","values":[2.5]})"
              "\n");
  }
  std::filesystem::remove(socket());
  ControlServer server{socket(), answer(json::object()) +
                                     R"({"event":{"t":1.5,"unit":"vcan0/2","kind":"nmt","state":"Stopped"}})"
                                     "\n"};
  const Finished run_ = run({"monitor", "nmt"});

  EXPECT_EQ(run_.output, "    1.500000  vcan0/2  nmt  state Stopped\n");
  EXPECT_EQ(run_.status, 7) << "the daemon is gone";
}

TEST_F(Axisctl, ListsUnits) {
  ControlServer server{folder.path("axisd.sock"),
                       answer({{"units", {{{"unit", "can0/5"}, {"node_id", 5}, {"axes", 2}, {"on", false}}}}})};

  EXPECT_EQ(run({"-b", "units"}).output, "can0/5  off  2  none  " + folder.path("axisd.sock") + "\n");
}

}  // namespace
