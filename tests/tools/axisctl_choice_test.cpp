// Which daemon axisctl talks to.
#include "tests/tools/axisctl_fixture.hpp"

namespace {

using fakes::ControlServer;
using fakes::Finished;

TEST_F(Axisctl, TakesTheOnlyDaemonThereIs) {
  ControlServer server{folder.path("axisd-can7-99.sock"), kDone};

  EXPECT_EQ(run({"quit"}).status, 0);
  EXPECT_NE(server.request(), "");
}

TEST_F(Axisctl, ListsTheDaemonsIfThereAreSeveral) {
  ControlServer first{folder.path("axisd-vcan0-2.sock"), kDone};
  ControlServer second{folder.path("axisd-vcan0-3.sock"), kDone};

  const Finished run_ = run({"quit"});

  EXPECT_EQ(run_.status, 2);
  EXPECT_EQ(run_.output, "");
  EXPECT_EQ(run_.errors,
            "axisctl: several units fit; choose one with --unit, --socket, or --interface and --node-id:\n  " +
                folder.path("axisd-vcan0-2.sock") + "\n  " + folder.path("axisd-vcan0-3.sock") + "\n");
}

TEST_F(Axisctl, FindsTheOnlyDaemonThatFitsWhatIsSaid) {
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"axisd-can7-5.sock", {"--node-id", "5", "quit"}},
           {"axisd-my-can-5.sock", {"quit", "--node-id=5"}},
           {"axisd-can7-99.sock", {"--interface", "can7", "quit"}},
       }) {
    ControlServer wanted{folder.path(file), kDone};
    ControlServer another{folder.path("axisd-vcan0-2.sock"), kDone};

    EXPECT_EQ(run(words).status, 0) << file;
    EXPECT_NE(wanted.request(), "") << file;
    EXPECT_EQ(another.request(), "") << file;
    std::filesystem::remove(folder.path("axisd-vcan0-2.sock"));
    std::filesystem::remove(folder.path(file));
  }
}

TEST_F(Axisctl, ListsTheDaemonsOfANodeIdThatIsOnSeveralInterfaces) {
  ControlServer first{folder.path("axisd-can0-5.sock"), kDone};
  ControlServer second{folder.path("axisd-vcan0-5.sock"), kDone};
  ControlServer another{folder.path("axisd-vcan0-6.sock"), kDone};

  const Finished run_ = run({"--node-id", "5", "quit"});

  EXPECT_EQ(run_.status, 2);
  EXPECT_EQ(run_.errors,
            "axisctl: several units fit; choose one with --unit, --socket, or --interface and --node-id:\n  " +
                folder.path("axisd-can0-5.sock") + "\n  " + folder.path("axisd-vcan0-5.sock") + "\n");
}

TEST_F(Axisctl, TakesNoSocketThatADeadDaemonHasLeftForAnother) {
  { const ControlServer dead{folder.path("axisd-can0-5.sock"), kDone}; }
  ControlServer wanted{folder.path("axisd-vcan1-5.sock"), kDone};

  EXPECT_EQ(run({"--node-id", "5", "quit"}).status, 0);
  EXPECT_NE(wanted.request(), "");
}

TEST_F(Axisctl, SaysThatNoDaemonFits) {
  ControlServer another{socket(), kDone};

  EXPECT_EQ(
      run({"--node-id", "5", "quit"}).errors,
      "axisctl: no daemon with node-ID 5 runs: it would have its control socket in " + folder.path("") + "\n");
  EXPECT_EQ(run({"--interface", "can1", "quit"}).status, 5);
  EXPECT_EQ(another.request(), "");
}

TEST_F(Axisctl, ChoosesByInterfaceAndNodeWithTheDefaultForTheOther) {
  for (const auto& [file, words] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"axisd-vcan0-3.sock", {"--node-id", "3", "quit"}},
           {"axisd-can1-2.sock", {"quit", "--interface", "can1"}},
           {"axisd-can1-3.sock", {"--interface=can1", "--node-id=3", "quit"}},
           {"axisd-unix-bus-bd35932a-2.sock", {"--interface", "unix:/tmp/bus", "quit"}},
           {"other", {"--socket", folder.path("other"), "--node-id", "3", "quit"}}}) {
    ControlServer wanted{folder.path(file), kDone};
    ControlServer another{folder.path("axisd-vcan1-127.sock"), kDone};

    EXPECT_EQ(run(words).status, 0) << file;
    EXPECT_NE(wanted.request(), "") << file;
    EXPECT_EQ(another.request(), "") << file;
    std::filesystem::remove(folder.path("axisd-vcan1-127.sock"));
    std::filesystem::remove(folder.path(file));
  }
}

TEST_F(Axisctl, TakesTheUnitThatIsNamed) {
  for (const auto& [file, unit] : std::vector<std::pair<std::string, std::string>>{
           {"axisd-can7-5.sock", "5"},
           {"axisd-can7-5.sock", "can7/5"},
           {"axisd-unix-bus-bd35932a-5.sock", "unix:/tmp/bus/5"},
           {"axisd-unix-bus-bd35932a-5.sock", "unix-bus-bd35932a/5"}}) {
    ControlServer wanted{folder.path(file), kDone};
    ControlServer another{folder.path("axisd-vcan0-2.sock"), kDone};

    EXPECT_EQ(run({"--unit", unit, "quit"}).status, 0) << unit;
    EXPECT_NE(wanted.request(), "") << unit;
    EXPECT_EQ(another.request(), "") << unit;
    std::filesystem::remove(folder.path("axisd-vcan0-2.sock"));
    std::filesystem::remove(folder.path(file));
  }
}

TEST_F(Axisctl, FindsUnitsWithoutNodeId) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--unit", "can7/unconfigured-7", "quit"},
                                             {"--unit", "unconfigured-7", "quit"},
                                             {"--interface", "can7", "--node-id", "255", "quit"}}) {
    ControlServer wanted{folder.path("axisd-can7-unconfigured-7.sock"), kDone};
    ControlServer another{folder.path("axisd-vcan0-unconfigured.sock"), kDone};

    EXPECT_EQ(run(words).status, 0) << words[1];
    EXPECT_NE(wanted.request(), "") << words[1];
    EXPECT_EQ(another.request(), "") << words[1];
    std::filesystem::remove(folder.path("axisd-can7-unconfigured-7.sock"));
    std::filesystem::remove(folder.path("axisd-vcan0-unconfigured.sock"));
  }
}

TEST_F(Axisctl, ListsTheUnitsWithoutNodeIdOfABus) {
  ControlServer first{folder.path("axisd-can7-unconfigured-7.sock"), kDone};
  ControlServer second{folder.path("axisd-can7-unconfigured.sock"), kDone};
  ControlServer another{folder.path("axisd-can7-5.sock"), kDone};

  EXPECT_EQ(run({"--node-id", "255", "quit"}).errors,
            "axisctl: several units fit; choose one with --unit, --socket, or --interface and --node-id:\n  " +
                folder.path("axisd-can7-unconfigured-7.sock") + "\n  " +
                folder.path("axisd-can7-unconfigured.sock") + "\n");
  EXPECT_EQ(run({"--unit", "can8/unconfigured", "quit"}).errors,
            "axisctl: no daemon on can8 without node-ID runs: it would have its control socket in " +
                folder.path("") + "\n");
}

TEST_F(Axisctl, NamesTheUnitToADaemonOfMany) {
  ControlServer server{folder.path("axisd.sock"), kDone};

  EXPECT_EQ(run({"--socket", folder.path("axisd.sock"), "--unit", "can0/5", "fault", "ack", "1"}).status, 0);

  EXPECT_EQ(nlohmann::json::parse(server.request())["params"], (nlohmann::json{{"axis", 1}, {"unit", "can0/5"}}));
}

TEST_F(Axisctl, RefusesAUnitThatNoneCanBe) {
  for (const char* unit : {"", "x", "can0/", "128", "-1", "can0/5x", "/5", "tcp://host/5"})
    EXPECT_EQ(run({"--unit", unit, "quit"}).status, 2) << unit;
  EXPECT_EQ(run({"--unit", "5", "--node-id", "5", "quit"}).status, 2);
  EXPECT_EQ(run({"--unit", "can0/5", "quit"}).errors,
            "axisctl: no daemon on can0 with node-ID 5 runs: it would have its control socket in " +
                folder.path("") + "\n");
  EXPECT_EQ(run({"--unit", "can0/5", "quit"}).status, 5);
}

TEST_F(Axisctl, SaysWhatAnInterfaceIs) {
  const Finished run_ = run({"--interface", "tcp://host", "quit"});

  EXPECT_EQ(run_.status, 2);
  EXPECT_EQ(run_.errors,
            "axisctl: --interface: expected a name of 1 to 15 characters without spaces, unix:PATH, "
            "udp-multicast://GROUP:PORT[?interface=NAME] or socketcand://HOST:PORT/NAME, got \"tcp://host\"\n");
}

}  // namespace
