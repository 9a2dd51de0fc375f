#include <gtest/gtest.h>

#include "farm/agent/host/checks.hpp"
#include "farm/agent/host/hub_programs.hpp"
#include "farm/agent/host/unit_programs.hpp"

namespace farm::agent {
namespace {

using Words = std::vector<std::string>;

TEST(HubCommand, JoinsTheBusOverTheServerOfTheFarm) {
  const HubCommand command{.program = "/usr/bin/canhub", .server = "tls://a:4222", .options = {"--tls-ca", "/ca"}};

  EXPECT_EQ(command.words({"line1", 0}, "/run/line1/can-bus"),
            (Words{"/usr/bin/canhub", "--path", "/run/line1/can-bus", "--join", "tls://a:4222/line1", "--tls-ca",
                   "/ca"}));
  EXPECT_EQ(command.words({"line1", 500'000}, "/p").back(), "500000");
}

TEST(UnitCommand, NamesTheFilesOfTheUnit) {
  const UnitCommand command{.program = "/usr/bin/axisd", .options = {"--log-level", "info"}};

  EXPECT_EQ(command.words({"/run", "/state"}, {"line1", "5"}),
            (Words{"/usr/bin/axisd", "--config", "/run/line1/5.json", "--control", "/run/axisd-line1-5.sock",
                   "--state-directory", "/state", "--log-level", "info"}));
}

TEST(Check, SaysInOneLineWhatAxisdSays) {
  EXPECT_EQ(problem_of_check("axisd: /run/5.check: /axes/0/motr: unknown key\nmore\n", "/run/5.check"),
            "configuration: /axes/0/motr: unknown key");
  EXPECT_EQ(problem_of_check("", "/run/5.check"), "");
}

}  // namespace
}  // namespace farm::agent
