#include "farm/agent/program/options.hpp"

#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace farm::agent {
namespace {

class AgentOptions : public testing::Test {
 protected:
  AgentOptions() {
    ::setenv("RUNTIME_DIRECTORY", "/run/agent:/run/other", 1);
    ::setenv("STATE_DIRECTORY", "/var/lib/agent", 1);
  }
  ~AgentOptions() override {
    ::unsetenv("RUNTIME_DIRECTORY");
    ::unsetenv("STATE_DIRECTORY");
  }

  static Options parse(std::vector<const char*> words) {
    words.insert(words.begin(), "axisd-agent");
    return parse_command_line(static_cast<int>(words.size()), words.data()).value();
  }
  /// What is wrong with @p words beside those that are needed.
  static std::string error_of(std::vector<const char*> words) {
    words.insert(words.begin(), {"--farm", "nats://localhost/lab"});
    try {
      parse(words);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "nothing";
  }
};

TEST_F(AgentOptions, HaveDefaults) {
  const Options options = parse({"--farm", "nats://localhost/lab"});

  EXPECT_EQ(options.farm.name, "lab");
  EXPECT_FALSE(options.host.empty());
  EXPECT_EQ(options.capacity, 100u);
  EXPECT_TRUE(options.buses.empty());
  EXPECT_EQ(options.runtime, "/run/agent");
  EXPECT_EQ(options.state, "/var/lib/agent");
  EXPECT_TRUE(options.security.empty());
  EXPECT_FALSE(options.drain_on_stop);
}

TEST_F(AgentOptions, AreTakenAsTheyAreGiven) {
  const Options options = parse({"--farm",    "nats://192.0.2.1/lab",
                                 "--plain",   "--credentials",
                                 "/etc/user", "--host",
                                 "a",         "--capacity",
                                 "7",         "--bus",
                                 "line1",     "--bus",
                                 "line2",     "--runtime-directory",
                                 "/r",        "--state-directory",
                                 "/s",        "--control-group",
                                 "axisd",     "--control-group",
                                 "other",     "--drain-on-stop"});

  EXPECT_EQ(options.security, (std::vector<std::string>{"--credentials", "/etc/user", "--plain"}));
  EXPECT_EQ(options.host, "a");
  EXPECT_EQ(options.capacity, 7u);
  EXPECT_EQ(options.buses, (std::set<std::string>{"line1", "line2"}));
  EXPECT_EQ(options.runtime, "/r");
  EXPECT_EQ(options.state, "/s");
  EXPECT_EQ(options.control_group, "other") << "the last one: that of a service can be replaced";
  EXPECT_TRUE(options.drain_on_stop);
}

TEST_F(AgentOptions, ThatCannotBeUsedAreSaidInOneLine) {
  EXPECT_EQ(error_of({"--capacity", "0"}), "--capacity: expected a number of units, 1 to 1000000, got \"0\"");
  EXPECT_EQ(error_of({"--host", "a.b"}),
            "--host: expected a name of 1 to 32 letters, digits, '-' and '_', got \"a.b\"");
  EXPECT_EQ(error_of({"--bus", ""}), "--bus: expected a name of 1 to 32 letters, digits, '-' and '_', got \"\"");
  EXPECT_EQ(error_of({"--log-level", "loud"}),
            "--log-level: expected error, warning, notice, info or debug, got \"loud\"");
  EXPECT_EQ(error_of({"--tls-cert", "x"}), "--tls-cert and --tls-key go with each other");
  EXPECT_EQ(error_of({"what"}).find("The following argument was not expected: what"), 0u);
  EXPECT_THROW(parse({}), UsageError) << "a farm has to be named";
}

}  // namespace
}  // namespace farm::agent
