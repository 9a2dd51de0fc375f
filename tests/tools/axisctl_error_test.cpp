// What axisctl says and ends with when it gets no result.
#include "tests/tools/axisctl_fixture.hpp"

namespace {

using fakes::ControlServer;
using fakes::Finished;
using nlohmann::json;

/// The error of a daemon, and what axisctl ends with.
struct ErrorCase {
  const char* code;
  int status;
};

TEST_F(Axisctl, EndsWithAStatusForEachKindOfError) {
  for (const auto& [code, status] : {ErrorCase{"malformed", 10},
                                     {"unknown-method", 10},
                                     {"unknown-unit", 2},
                                     {"bad-parameter", 4},
                                     {"not-found", 4},
                                     {"out-of-range", 4},
                                     {"read-only", 3},
                                     {"refused", 3},
                                     {"off", 8},
                                     {"busy", 9},
                                     {"overflow", 9},
                                     {"of-tomorrow", 1}}) {
    std::filesystem::remove(socket());
    ControlServer server{socket(), json{{"id", 1}, {"error", {{"code", code}, {"message", "no"}}}}.dump() + "\n"};
    const Finished run_ = run({"fault", "ack", "1"});

    EXPECT_EQ(run_.status, status) << code;
    EXPECT_EQ(run_.errors, "axisctl: no\n") << code;
  }
}

TEST_F(Axisctl, TellsAProgramWhyThereIsNoResult) {
  ControlServer server{
      socket(),
      json{{"id", 1}, {"error", {{"code", "out-of-range"}, {"message", "no"}, {"limits", {{"low", 0}}}}}}.dump() +
          "\n"};

  const Finished run_ = run({"--json", "fault", "ack", "1"});

  EXPECT_EQ(json::parse(run_.output),
            (json{{"error",
                   {{"code", "out-of-range"}, {"message", "no"}, {"limits", {{"low", 0}}}, {"exit_status", 4}}}}));
}

struct BadAnswer {
  int status;
  std::string answer;
  std::string complaint;
};

TEST_F(Axisctl, DoesNotTakeAnythingElseForAnAnswer) {
  const std::vector<BadAnswer> answers{
      {7, "", "closed the connection without an answer"},
      {7, "{\"id\":1,\"result\":{}}", "closed the connection without an answer"},
      {10, "hello\n", "not an answer: \"hello\""},
      {10, "{\"id\":2,\"result\":{}}\n", "not an answer"},
      {10, "\n", "not an answer"},
      {10, std::string(70'000, 'x') + "\n", "longer than 65536 bytes"},
      {10, std::string(65'536, ' ') + "\n", "longer than 65536 bytes"},
  };
  for (const BadAnswer& bad : answers) {
    std::filesystem::remove(socket());
    ControlServer server{socket(), bad.answer};

    const Finished run_ = run({"status"});

    EXPECT_EQ(run_.status, bad.status) << bad.answer.substr(0, 40);
    EXPECT_EQ(run_.output, "");
    EXPECT_NE(run_.errors.find(bad.complaint), std::string::npos) << run_.errors;
  }
}

}  // namespace
