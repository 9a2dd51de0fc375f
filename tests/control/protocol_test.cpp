#include "control/protocol.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "control/methods.hpp"
#include "control/socket_name.hpp"

namespace {

using nlohmann::json;

/// Sets environment variables for one test.
struct ControlSocketPath : testing::Test {
  ControlSocketPath() {
    ::unsetenv("RUNTIME_DIRECTORY");
    ::unsetenv("XDG_RUNTIME_DIR");
  }
};

TEST_F(ControlSocketPath, LiesInTheRuntimeDirectoryOfTheService) {
  ::setenv("RUNTIME_DIRECTORY", "/run/axisd", 1);
  ::setenv("XDG_RUNTIME_DIR", "/run/user/1000", 1);

  EXPECT_EQ(control::default_socket_path("can0", "127"), "/run/axisd/axisd-can0-127.sock");
}

TEST_F(ControlSocketPath, LiesInTheFirstOfSeveralRuntimeDirectories) {
  ::setenv("RUNTIME_DIRECTORY", "/run/axisd:/run/other", 1);

  EXPECT_EQ(control::default_socket_path("vcan0", "2"), "/run/axisd/axisd-vcan0-2.sock");
}

TEST_F(ControlSocketPath, LiesInTheRuntimeDirectoryOfTheUserOtherwise) {
  ::setenv("RUNTIME_DIRECTORY", "", 1);
  ::setenv("XDG_RUNTIME_DIR", "/run/user/1000", 1);

  EXPECT_EQ(control::default_socket_path("vcan0", "2"), "/run/user/1000/axisd-vcan0-2.sock");
}

TEST_F(ControlSocketPath, LiesInRunOrTmpWithoutEnvironment) {
  EXPECT_EQ(control::runtime_directory(), ::geteuid() == 0 ? "/run" : "/tmp");
}

TEST(ControlSocketName, IsRecognised) {
  const auto name = control::parse_socket_name("axisd-vcan0-2.sock");
  ASSERT_TRUE(name);
  EXPECT_EQ(name->label, "vcan0");
  EXPECT_EQ(name->station, "2");
  const auto with_dash = control::parse_socket_name("axisd-my-can-127.sock");
  ASSERT_TRUE(with_dash);
  EXPECT_EQ(with_dash->label, "my-can");
  EXPECT_EQ(with_dash->station, "127");
  const auto switched_off = control::parse_socket_name("axisd-vcan0-0.sock");
  ASSERT_TRUE(switched_off);
  EXPECT_EQ(switched_off->station, "0");
  const auto unconfigured = control::parse_socket_name("axisd-my-can-unconfigured.sock");
  ASSERT_TRUE(unconfigured);
  EXPECT_EQ(unconfigured->label, "my-can");
  EXPECT_EQ(unconfigured->station, "unconfigured");
  const auto with_serial = control::parse_socket_name("axisd-my-can-unconfigured-4294967295.sock");
  ASSERT_TRUE(with_serial);
  EXPECT_EQ(with_serial->label, "my-can");
  EXPECT_EQ(with_serial->station, "unconfigured-4294967295");
  for (const char* other :
       {"axisd-unconfigured.sock", "axisd-vcan0-unconfigured-.sock", "axisd-vcan0-unconfigured-x.sock",
        "axisd-vcan0-unconfigured-4294967296.sock", "axisd-vcan0-configured.sock", "axisd-vcan0-255.sock",
        "axisd-vcan0.sock", "axisd--2.sock", "axisd-vcan0-.sock", "axisd-vcan0-x.sock", "axisd-vcan0-128.sock",
        "axisd-vcan0-2x.sock", "axisd-vcan0-2.lock", "axisd.sock", "axisd-.sock", "xaxisd-vcan0-2.sock", ""})
    EXPECT_FALSE(control::parse_socket_name(other)) << other;
}

TEST(ControlSocketName, SaysWhichUnitsHaveNoNodeId) {
  for (const char* station : {"unconfigured", "unconfigured-0", "unconfigured-7"}) {
    EXPECT_TRUE(control::is_unconfigured(station)) << station;
    EXPECT_TRUE(control::is_station(station)) << station;
  }
  for (const char* station : {"0", "5", "127"}) {
    EXPECT_FALSE(control::is_unconfigured(station)) << station;
    EXPECT_TRUE(control::is_station(station)) << station;
  }
  for (const char* other :
       {"", "-1", "128", "255", "5x", "unconfigured-", "unconfigured7", "unconfigured--1", "x"})
    EXPECT_FALSE(control::is_station(other)) << other;
}

TEST(ControlSocketAddress, HoldsUpTo107Bytes) {
  EXPECT_TRUE(control::socket_address(std::string(107, 'x')));
  EXPECT_EQ(control::socket_address(std::string(108, 'x')).error(),
            std::string(108, 'x') + ": too long for a socket: 108 bytes, at most 107");
  EXPECT_FALSE(control::socket_address(""));
}

TEST(ControlMethod, IsFoundByEveryNameOfTheTable) {
  for (const auto& row : control::kMethods) EXPECT_EQ(control::find_method(row.name), &row);
  EXPECT_EQ(control::find_method("fault"), nullptr);
}

TEST(ControlRequest, IsUnderstoodByTheOtherSide) {
  const auto request =
      control::parse_request(control::request_line(7, "fault.inject", {{"axis", 1}, {"number", 7860}}));

  ASSERT_TRUE(request);
  EXPECT_EQ(request->id, 7);
  EXPECT_EQ(request->method, "fault.inject");
  EXPECT_EQ(request->params, (json{{"axis", 1}, {"number", 7860}}));
}

TEST(ControlRequest, MayLeaveItsParametersAndItsIdOut) {
  const auto request = control::parse_request(R"({"method":"status"})");

  ASSERT_TRUE(request);
  EXPECT_TRUE(request->id.is_null());
  EXPECT_EQ(request->params, json::object());
}

TEST(ControlRequest, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(control::parse_request("status").error().error.message, R"(expected a JSON object, got "status")");
  EXPECT_EQ(control::parse_request("[1]").error().error.message, R"(expected a JSON object, got "[1]")");
  EXPECT_EQ(control::parse_request("\x1b[2J").error().error.message, R"(expected a JSON object, got "?[2J")");
  EXPECT_EQ(control::parse_request(R"({"id":7,"method":5})").error().id, 7);
  EXPECT_EQ(control::parse_request(R"({"id":[1],"method":"quit"})").error().error.message,
            "id: expected a number or a string");
  EXPECT_EQ(control::parse_request("status").error().error.code, control::ErrorCode::Malformed);
  EXPECT_FALSE(control::parse_request("{\"method\":\"\xff\"}")) << "is not UTF-8";
  EXPECT_FALSE(control::parse_request("{\"method\":\"quit\"")) << "does not end";
  EXPECT_FALSE(control::parse_request(R"({"method":"quit"} {})")) << "is two";
  const std::string deep = std::string(60000, '[') + std::string(60000, ']');
  EXPECT_FALSE(control::parse_request(R"({"id":)" + deep + "}"));
  EXPECT_EQ(control::parse_request(R"({"id":1})").error().error.message, "method: expected a string");
  EXPECT_EQ(control::parse_request(R"({"method":5})").error().error.message, "method: expected a string");
  EXPECT_EQ(control::parse_request(R"({"method":"quit","params":[1]})").error().error.message,
            "params: expected an object");
}

TEST(ControlAnswer, BringsItsResult) {
  const auto answer = control::parse_answer(control::result_line(1, {{"axis", 1}}), 1);

  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, (json{{"axis", 1}}));
}

TEST(ControlAnswer, BringsItsErrorWithCodeAndDetails) {
  const control::Error error{
      control::ErrorCode::OutOfRange, "p1120: expected 0 to 999999", {{"limits", {{"low", 0}}}}};
  const auto answer = control::parse_answer(control::error_line(1, error), 1);

  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().message, error.message);
  EXPECT_EQ(answer.error().code, error.code);
  EXPECT_EQ(answer.error().details, error.details);
}

TEST(ControlAnswer, BringsTheErrorOfALineThatWasNoRequest) {
  const control::Error error{control::ErrorCode::Malformed, "not JSON"};

  EXPECT_EQ(control::error_line(nullptr, error), R"({"error":{"code":"malformed","message":"not JSON"},"id":null})"
                                                 "\n");
  EXPECT_EQ(control::parse_answer(control::error_line(nullptr, error), 1).error().message, "not JSON");
}

TEST(ControlAnswer, MayHaveAnErrorWithACodeThatIsNotKnown) {
  for (const char* line :
       {R"({"id":1,"error":{"message":"no"}})", R"({"id":1,"error":{"code":"new","message":"no"}})",
        R"({"id":1,"error":{"code":5,"message":"no"}})"}) {
    const auto answer = control::parse_answer(line, 1);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().message, "no");
    EXPECT_EQ(answer.error().code, std::nullopt);
  }
}

TEST(ControlError, HasACodeOfItsOwn) {
  for (const auto& row : control::kErrorNames) {
    EXPECT_EQ(control::name_of(row.code), row.name);
    EXPECT_EQ(control::error_code_of(row.name), row.code);
  }
  EXPECT_EQ(control::error_code_of(""), std::nullopt);
}

TEST(ControlAnswer, ToAnotherRequestIsNone) {
  EXPECT_EQ(control::parse_answer(R"({"id":2,"result":{}})", 1).error().message,
            R"(not an answer: "{"id":2,"result":{}}")");
}

TEST(ControlAnswer, WithoutResultOrWithAStrangeErrorIsNone) {
  for (const char* line : {"", "{}", "null", "5", "{\"id\":1}", "{\"id\":1,\"error\":\"x\"}",
                           "{\"id\":1,\"error\":{\"message\":5}}", "{\"id\":1,\"result\":"})
    EXPECT_FALSE(control::parse_answer(line, 1)) << line;
}

TEST(ControlLine, SurvivesTextThatIsNotUtf8) {
  EXPECT_TRUE(control::parse_answer(control::result_line(1, {{"name", "\xff"}}), 1));
}

}  // namespace
