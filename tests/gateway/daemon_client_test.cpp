#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "gateway/units/daemons.hpp"
#include "tests/gateway/gateway_fixture.hpp"

namespace gateway {
namespace {

using nlohmann::json;

class DaemonsTest : public testing::Test, public Daemons::Listener {
 protected:
  std::unique_ptr<FakeDaemon> daemon(std::function<std::string(std::string)> answer = answer_of_unit) {
    return std::make_unique<FakeDaemon>(events, path, std::move(answer));
  }
  void look_for_unit() {
    daemons.listen(this);
    wait_until(events, [this] { return !daemons.units().empty(); });
  }
  /// What the unit answers to @p method, or the code of the error.
  std::string ask(const std::string& method, const json& params = json::object()) {
    const auto client = daemons.find("vcan0/5");
    if (!client) return client.error().code;
    std::string told;
    (*client)->ask(method, params,
                   [&told](const Answer& answer) { told = answer ? answer->dump() : answer.error().code; });
    wait_until(events, [&told] { return !told.empty(); });
    return told;
  }
  void on_event(const json& event) override { seen.push_back(event.dump()); }
  void on_units() override { ++changes; }

  fakes::TemporaryDirectory folder;
  std::string path = folder.path("axisd.sock");
  axisd::ServiceEvents events{[] {}};
  axisd::Log log{axisd::LogLevel::Error};
  std::list<std::string> seen;
  int changes = 0;
  Daemons daemons{events, std::make_unique<SocketReach>(std::vector{path}), log};
};

TEST_F(DaemonsTest, AnswersComeToThoseWhoHaveAsked) {
  const auto unit = daemon();
  look_for_unit();
  EXPECT_EQ(ask("status"), R"({"method":"status","params":{}})");
  EXPECT_EQ(ask("explain"), "refused");

  DaemonClient& client = *daemons.find("vcan0/5").value();
  std::vector<std::string> told;
  for (const char* const method : {"nmt.get", "explain", "supply.get"})
    client.ask(method, json::object(), [&told](const Answer& answer) {
      told.push_back(answer ? answer->at("method").get<std::string>() : answer.error().code);
    });
  wait_until(events, [&told] { return told.size() == 3; });
  EXPECT_EQ(told, (std::vector<std::string>{"nmt.get", "refused", "supply.get"}));
}

TEST_F(DaemonsTest, UnitsThatAreNotThereAreToldApartFromThoseThatAreGone) {
  auto unit = daemon();
  look_for_unit();
  EXPECT_EQ(daemons.find("vcan0/6").error().code, "unknown-unit");
  unit.reset();
  wait_until(events, [this] { return daemons.units().empty(); });
  EXPECT_EQ(daemons.find("vcan0/5").error().code, "no-daemon");
  unit = daemon();
  wait_until(events, [this] { return !daemons.units().empty(); });
  EXPECT_EQ(ask("status"), R"({"method":"status","params":{}})");
  EXPECT_EQ(changes, 3);
}

TEST_F(DaemonsTest, WhatIsNoAnswerEndsTheConnectionToThisDaemon) {
  for (const char* const junk :
       {"hello\n", "[]\n", "{}\n", "{\"id\":77,\"result\":{}}\n", "{\"error\":{}}\n", "\n",
        "{\"id\":null,\"error\":{\"code\":\"overflow\",\"message\":\"make room\"}}\n"}) {
    std::string answer = "none";
    const auto unit = daemon([&answer](const std::string& line) {
      return line.find("\"units\"") != std::string::npos ? answer_of_unit(line) : answer;
    });
    look_for_unit();
    answer = junk;
    EXPECT_EQ(ask("status"), "broken-daemon") << junk;
    EXPECT_TRUE(daemons.units().empty()) << junk;
  }
}

TEST_F(DaemonsTest, ALineWithoutEndEndsTheConnection) {
  const auto unit = daemon([](const std::string& line) {
    return line.find("\"units\"") != std::string::npos ? answer_of_unit(line) : std::string(70000, 'x');
  });
  look_for_unit();
  EXPECT_EQ(ask("status"), "broken-daemon");
}

TEST_F(DaemonsTest, ARequestThatIsTooLongForALineIsNotSent) {
  const auto unit = daemon();
  look_for_unit();
  EXPECT_EQ(ask("status", {{"a", std::string(65536, 'x')}}), "too-long");
  EXPECT_EQ(ask("status"), R"({"method":"status","params":{}})");
}

TEST_F(DaemonsTest, SoManyRequestsWaitAndNoMore) {
  const auto unit = daemon();
  look_for_unit();
  DaemonClient& client = *daemons.find("vcan0/5").value();
  std::size_t refused = 0;
  std::size_t answered = 0;
  for (std::size_t n = 0; n < DaemonClient::kMostWaiting + 5; ++n)
    client.ask("status", json::object(), [&](const Answer& answer) { ++(answer ? answered : refused); });
  EXPECT_EQ(refused, 5U);
  wait_until(events, [&answered] { return answered == DaemonClient::kMostWaiting; });
}

TEST_F(DaemonsTest, EventsAreAskedForWhileSomebodyWantsThem) {
  const auto unit = daemon();
  look_for_unit();
  const auto asked_for = [&unit](std::string_view method) {
    return std::ranges::any_of(
        unit->lines, [method](const std::string& line) { return line.find(method) != std::string::npos; });
  };
  EXPECT_FALSE(asked_for("events.subscribe"));
  daemons.want_events(true);
  wait_until(events, [&] { return asked_for("events.subscribe"); });
  unit->tell("{\"event\":{\"kind\":\"nmt\",\"t\":1}}\n");
  wait_until(events, [this] { return !seen.empty(); });
  EXPECT_EQ(seen.front(), R"({"kind":"nmt","t":1})");
  daemons.want_events(false);
  wait_until(events, [&] { return asked_for("events.unsubscribe"); });
}

TEST_F(DaemonsTest, ADaemonMayAnswerInAnotherOrder) {
  std::vector<std::string> lines;
  const auto unit = daemon([&lines](const std::string& line) -> std::string {
    if (line.find("\"units\"") != std::string::npos) return answer_of_unit(line);
    lines.push_back(line);
    if (lines.size() < 2) return "";
    return answer_of_unit(lines[1]) + answer_of_unit(lines[0]);
  });
  look_for_unit();
  std::vector<std::string> told;
  for (const char* const method : {"status", "nmt.get"})
    (*daemons.find("vcan0/5"))->ask(method, json::object(), [&told](const Answer& answer) {
      told.push_back(answer->at("method").get<std::string>());
    });
  wait_until(events, [&told] { return told.size() == 2; });
  EXPECT_EQ(told, (std::vector<std::string>{"nmt.get", "status"}));
}

TEST_F(DaemonsTest, TheLastWordOfADaemonIsWhyTheConnectionHasEnded) {
  const auto unit = daemon([](const std::string& line) -> std::string {
    if (line.find("\"units\"") != std::string::npos) return answer_of_unit(line);
    return "{\"id\":null,\"error\":{\"code\":\"unreachable\",\"message\":\"the server is gone\"}}\n";
  });
  look_for_unit();
  std::string why;
  (*daemons.find("vcan0/5"))->ask("status", json::object(), [&why](const Answer& answer) {
    why = answer.error().message;
  });
  wait_until(events, [&why] { return !why.empty(); });
  EXPECT_EQ(why, path + ": the server is gone");
}

TEST_F(DaemonsTest, ALongListOfUnitsComesInPages) {
  const auto unit = daemon([](const std::string& line) -> std::string {
    const json request = json::parse(line);
    const int from = request.value("/params/from"_json_pointer, 0);
    json result{{"units", {{{"unit", "line1/" + std::to_string(from)}}}}};
    if (from < 2) result["next"] = from + 1;
    return json{{"id", request["id"]}, {"result", result}}.dump() + '\n';
  });
  look_for_unit();
  EXPECT_EQ(daemons.units(), (std::vector<std::string>{"line1/0", "line1/1", "line1/2"}));
}

/// A daemon whose units come and go, as those of a farm do.
struct FarmTest : DaemonsTest {
  class ChangingReach final : public Reach {
   public:
    explicit ChangingReach(std::vector<std::string> paths) : sockets_{std::move(paths)} {}
    std::vector<std::string> places() const override { return sockets_.places(); }
    bool are_named() const noexcept override { return sockets_.are_named(); }
    bool do_units_change() const noexcept override { return true; }
    tl::expected<os::Descriptor, std::string> connect(const std::string& place) override {
      return sockets_.connect(place);
    }

   private:
    SocketReach sockets_;
  };
  std::string answer_to(const std::string& line) const {
    const json request = json::parse(line);
    json answer{{"id", request["id"]}};
    if (request["method"] != "units")
      answer["result"] = json::object();
    else if (hosts.empty())
      answer["error"] = {{"code", "unreachable"}, {"message", "the server is gone"}};
    else
      for (const auto& [name, host] : hosts) answer["result"]["units"].push_back({{"unit", name}, {"host", host}});
    return answer.dump() + '\n';
  }

  std::map<std::string, std::string> hosts{{"line1/5", "a"}};
  std::unique_ptr<FakeDaemon> server = daemon([this](const std::string& line) { return answer_to(line); });
  Daemons farm{events, std::make_unique<ChangingReach>(std::vector{path}), log};
};

TEST_F(FarmTest, UnitsComeAndMoveAndGo) {
  wait_until(events, [this] { return farm.units() == std::vector<std::string>{"line1/5"}; });
  EXPECT_EQ(farm.host_of("line1/5"), "a");
  hosts = {{"line1/5", "b"}, {"line1/6", "b"}};
  wait_until(events, [this] { return farm.units().size() == 2; });
  EXPECT_EQ(farm.host_of("line1/5"), "b");
  hosts = {{"line1/6", "b"}};
  wait_until(events, [this] { return farm.units() == std::vector<std::string>{"line1/6"}; });
  EXPECT_EQ(farm.host_of("line1/5"), "");
}

TEST_F(FarmTest, EventsAreAskedForAgainWhenTheServerIsBack) {
  farm.want_events(true);
  const auto asked = [this] {
    return std::ranges::count_if(
        server->lines, [](const std::string& line) { return line.find("events.subscribe") != std::string::npos; });
  };
  wait_until(events, [&] { return farm.units().size() == 1 && asked() == 1; });
  hosts.clear();
  const std::size_t before = server->lines.size();
  wait_until(events, [&] { return server->lines.size() > before + 1; });
  hosts = {{"line1/5", "a"}};
  wait_until(events, [&] { return asked() == 2; });
}

}  // namespace
}  // namespace gateway
