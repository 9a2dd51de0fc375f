#include <filesystem>

#include <unistd.h>

#include "tests/tools/with-can/with_can_fixture.hpp"

namespace with_can_test {
namespace {

/// The value of @p name in what env(1) printed; "(none)" if it is not there.
std::string variable(const fakes::Finished& result, const std::string& name) {
  const std::string text = "\n" + result.output;
  const std::size_t at = text.find("\n" + name + "=");
  if (at == std::string::npos) return "(none)";
  const std::size_t begin = at + name.size() + 2;
  return text.substr(begin, text.find('\n', begin) - begin);
}

TEST_F(WithCan, RunsTheCommandWithBusAndLibrary) {
  const fakes::Finished result = run({"--bus", path("bus"), "--", "env"});

  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(variable(result, "CAN_BUS"), path("bus"));
  EXPECT_TRUE(variable(result, "LD_PRELOAD").ends_with("/lib/axisd/libcan-preload.so"));
  EXPECT_TRUE(std::filesystem::exists(variable(result, "LD_PRELOAD")));
  EXPECT_EQ(result.errors, "");
}

TEST_F(WithCan, GivesTheCommandItsArguments) {
  EXPECT_EQ(run_on_bus({"echo", "--bus", "-x", "--", "a b"}).output, "--bus -x -- a b\n");
  EXPECT_EQ(run({"echo", "--bus", "x"}).output, "--bus x\n");
  EXPECT_EQ(run_on_bus({"sh", "-c", "exit 5"}).status, 5);
}

TEST_F(WithCan, MakesThePathAbsolute) {
  const fakes::Finished result = run({"--bus=some/../bus", "env"});

  EXPECT_EQ(variable(result, "CAN_BUS"), std::filesystem::current_path().string() + "/bus");
}

TEST_F(WithCan, TakesTheDefaultBus) {
  EXPECT_EQ(variable(run({"env"}, {"CAN_BUS=/x/bus"}), "CAN_BUS"), "/x/bus");
  EXPECT_EQ(variable(run({"env"}, {"XDG_RUNTIME_DIR=/x"}), "CAN_BUS"), "/x/can-bus");
  EXPECT_TRUE(variable(run({"env"}), "CAN_BUS").starts_with(::geteuid() == 0 ? "/run/can-bus" : "/tmp/can-bus-"));
}

#ifndef __SANITIZE_ADDRESS__  // which insists on being the first library of with-can
TEST_F(WithCan, KeepsWhatIsPreloadedAlready) {
  const fakes::Finished result = run({"env"}, {"LD_PRELOAD=libc.so.6"});

  EXPECT_TRUE(variable(result, "LD_PRELOAD").ends_with("/libcan-preload.so:libc.so.6"));
}

TEST_F(WithCan, RunsWithinItself) {
  const fakes::Finished result = run({"--bus", path("a"), WITH_CAN, "--bus", path("b"), "env"});

  EXPECT_EQ(variable(result, "CAN_BUS"), path("b"));
  EXPECT_EQ(variable(result, "LD_PRELOAD").find(':'), std::string::npos);
}
#endif

TEST_F(WithCan, RefusesAPathThatIsTooLong) {
  const std::string longest = "/" + std::string(106, 'x');

  EXPECT_EQ(variable(run({"--bus", longest, "env"}), "CAN_BUS"), longest);
  const fakes::Finished result = run({"--bus", longest + "x", "env"});
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(is_one_line_with(result.errors, "has 108 bytes, at most 107 are possible"));
  EXPECT_EQ(run({"env"}, {"CAN_BUS=" + longest + "x"}).status, 2);
}

TEST_F(WithCan, SaysWhatIsWrongWithItsOptions) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "expected a command to run"},
      {{"--bus", "/x", "--"}, "expected a command to run"},
      {{"--bus"}, "--bus: expected a value"},
      {{"--bus=", "env"}, "--bus: expected a path, got nothing"},
      {{"--bitrate", "999", "env"}, "--bitrate: expected 0 or an integer 1000 to 1000000 (bit/s), got \"999\""},
      {{"--bitrate", "125k", "env"}, "--bitrate: expected 0 or an integer 1000 to 1000000 (bit/s), got \"125k\""},
      {{"--time", "quick", "env"},
       "--time: expected real, scaled=K (0.001 to 1000), virtual or stepped, got \"quick\""},
      {{"--fast", "env"}, "unknown option --fast"},
  };
  for (const auto& [words, message] : cases) {
    const fakes::Finished result = run(words);

    EXPECT_EQ(result.status, 2) << message;
    EXPECT_TRUE(result.errors.starts_with("with-can: " + message + "\n")) << result.errors;
    EXPECT_NE(result.errors.find("usage: with-can"), std::string::npos);
  }
}

TEST_F(WithCan, PrintsHelpAndVersion) {
  EXPECT_TRUE(run({"--help"}).output.starts_with("usage: with-can "));
  EXPECT_TRUE(run({"--version"}).output.starts_with("with-can "));
}

TEST_F(WithCan, StartsABusWithABitRate) {
  EXPECT_EQ(run({"--bus", path("bus"), "--bitrate", "125000", "true"}).status, 0);
  EXPECT_EQ(run({"--bus", path("bus"), "--bitrate", "125000", "true"}).status, 0);

  const fakes::Finished other = run({"--bus", path("bus"), "--bitrate", "250000", "true"});

  EXPECT_EQ(other.status, 1);
  EXPECT_TRUE(is_one_line_with(other.errors, "runs at another bit rate than 250000 bit/s"));
}

TEST_F(WithCan, TakesTheBitRatesOfCanhub) {
  EXPECT_EQ(run({"--bus", path("slow"), "--bitrate", "1000", "true"}).status, 0);
  EXPECT_EQ(run({"--bus", path("instant"), "--bitrate", "0", "true"}).status, 0);

  const fakes::Finished other = run({"--bus", path("slow"), "--bitrate", "0", "true"});

  EXPECT_EQ(other.status, 1);
  EXPECT_TRUE(is_one_line_with(other.errors, "runs at another bit rate than 0 bit/s"));
}

TEST_F(WithCan, StartsABusWithATime) {
  const fakes::Finished result = run({"--bus", path("bus"), "--time", "virtual", "date", "-u", "+%F %T"});

  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.output, "2025-01-01 00:00:00\n");
}

TEST_F(WithCan, SaysThatABusGoesByAnotherTime) {
  EXPECT_EQ(run({"--bus", path("bus"), "--time", "real", "true"}).status, 0);

  const fakes::Finished other = run({"--bus", path("bus"), "--time", "virtual", "true"});

  EXPECT_EQ(other.status, 1);
  EXPECT_TRUE(is_one_line_with(other.errors, "goes by another time than virtual"));
}

TEST_F(WithCan, SaysThatAPathIsInUse) {
  std::ofstream{path("bus")} << "a file";

  const fakes::Finished result = run({"--bus", path("bus"), "--bitrate", "125000", "true"});

  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(is_one_line_with(result.errors, "is in use by something that is no CAN bus"));
}

TEST_F(WithCan, SaysThatThereIsNoHub) {
  const fakes::Finished result =
      run({"--bus", path("bus"), "--bitrate", "125000", "true"}, {"CAN_HUB=/nowhere/canhub"});

  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(is_one_line_with(result.errors, "/nowhere/canhub does not serve it: No such file or directory"));
}

}  // namespace
}  // namespace with_can_test
