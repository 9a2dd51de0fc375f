#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "farm/agent/host/checks.hpp"
#include "farm/agent/host/unit_programs.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/farm/agent/process/process_fixture.hpp"

namespace farm::agent {
namespace {

const UnitName kUnit{"line1", "5"};

/// Keeps what it is told, a line each.
class ToldOutcomes final : public Outcomes {
 public:
  void on_not_judged(const Check& check, const std::string& why) override {
    add(check.unit.text() + " not judged: " + why);
  }
  void on_judged(const Check& check, const std::string& problem) override {
    add(check.unit.text() + " judged: " + problem);
  }
  void on_unit_found(const UnitStart& unit) override { add(unit.unit.text() + " found"); }
  void on_unit_started(const UnitName& unit) override { add(unit.text() + " started"); }
  void on_unit_ended(const UnitName& unit, const std::string& why) override {
    add(unit.text() + " ended: " + why);
  }
  void on_saved(const UnitName&, bool) override {}
  void on_hub_found(const std::string& bus, std::uint32_t) override { add(bus + " found"); }
  void on_hub_started(const std::string& bus) override { add(bus + " started"); }
  void on_hub_ended(const std::string& bus, const std::string& why) override { add(bus + " ended: " + why); }
  void on_warning(const std::string& text) override { add(text); }

  std::vector<std::string> lines;

 private:
  void add(std::string line) { lines.push_back(std::move(line)); }
};

class Unconnected final : public Link::Listener {
 public:
  void on_up() override {}
  void on_down(const std::string&) override {}
};

/// A script stands for axisd, and nobody for the server.
class ProgramsTest : public ProcessFixture {
 protected:
  std::string program(const std::string& script) {
    std::ofstream{root.path("axisd")} << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(root.path("axisd"), std::filesystem::perms::owner_all);
    return root.path("axisd");
  }
  void expect_lines(const std::vector<std::string>& expected) {
    wait_for([&] { return outcomes.lines.size() >= expected.size(); });
    EXPECT_EQ(outcomes.lines, expected);
  }
  /// Of a unit that nobody else has run since.
  UnitStart start_of_known(const UnitName& unit) {
    EXPECT_TRUE(replace_file(folders.note(unit), text_of(UnitNote{{7, "g"}, "{}", std::nullopt})));
    return {unit, "{}", 7, "g"};
  }

  fakes::TemporaryDirectory root;
  Folders folders{root.path("run"), root.path("state")};
  ToldOutcomes outcomes;
  Unconnected unconnected;
  Link link{events, nats::Server{"nats://127.0.0.1:1", {}, {}, {}, {}}, "test", unconnected};
  StoredState state{events, link, "lab", folders, outcomes};
};

TEST_F(ProgramsTest, AxisdJudgesConfigurations) {
  Checks checks{events, folders,
                program("grep -q bad \"$3\" && echo \"axisd: $3: /bad: unknown key\" >&2 && exit 2; exit 0"),
                outcomes};

  checks.judge({kUnit, R"({"bad":1})"});
  expect_lines({"line1/5 judged: configuration: /bad: unknown key"});
  checks.judge({kUnit, "{}"});
  expect_lines({"line1/5 judged: configuration: /bad: unknown key", "line1/5 judged: "});
  EXPECT_FALSE(std::filesystem::exists(folders.configuration(kUnit) + ".check")) << "nothing is left";
}

TEST_F(ProgramsTest, AnAxisdThatDoesNotJudgeSaysNothingOfTheConfiguration) {
  Checks checks{events, folders, program("kill -9 $$"), outcomes};

  checks.judge({kUnit, "{}"});

  expect_lines(
      {"line1/5 not judged: the configuration cannot be judged: axisd --check-config: was ended by signal 9"});
}

TEST_F(ProgramsTest, WhatIsGoodForOneUnitIsGoodForOthers) {
  const std::string counter = root.path("count");
  Checks checks{events, folders, program("echo x >>" + counter), outcomes};

  for (const char* const node : {"1", "2", "3"}) {
    checks.judge({{"line1", node}, "{}"});
    ASSERT_TRUE(wait_for([&] { return outcomes.lines.size() == static_cast<std::size_t>(node[0] - '0'); }));
  }
  EXPECT_EQ(std::filesystem::file_size(counter), 2u);
}

TEST_F(ProgramsTest, AUnitThatCannotBeStartedSaysWhy) {
  UnitPrograms units{events, folders, {program("exit 3"), {}}, state, outcomes};

  units.start(start_of_known(kUnit));

  expect_lines({"line1/5 ended: axisd has ended with status 3, the log of the agent says why"});
}

TEST_F(ProgramsTest, AUnitThatIsStoppedBeforeItsTurnIsNotStarted) {
  const std::string mark = root.path("started-");
  UnitPrograms units{
      events, folders, {program("touch " + mark + "$(basename $2); exec sleep 100"), {}}, state, outcomes};
  for (const char* const node : {"1", "2", "3", "4", "5"}) units.start(start_of_known({"line1", node}));

  units.stop({"line1", "5"});
  expect_lines({"line1/5 ended: "});
  for (const char* const node : {"1", "2", "3", "4"}) {
    ASSERT_TRUE(wait_for([&] { return std::filesystem::exists(mark + node + ".json"); })) << node;
    units.stop({"line1", node});
  }
  wait_for([&] { return outcomes.lines.size() == 5; });
  EXPECT_EQ(outcomes.lines.size(), 5u);
  EXPECT_FALSE(std::filesystem::exists(mark + "5.json"));
}

TEST_F(ProgramsTest, AUnitWaitsForWhatItHasSavedElsewhere) {
  UnitPrograms units{events, folders, {program("exit 3"), {}}, state, outcomes};

  units.start({kUnit, "{}", 9, "g"});

  expect_lines({"line1/5 ended: what it has saved cannot be fetched: no connection"});
}

}  // namespace
}  // namespace farm::agent
