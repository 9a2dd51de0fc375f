#include <gtest/gtest.h>

#include "can/hub/faults/answer.hpp"
#include "can/userbus/protocol.hpp"
#include "tests/can/hub/faults/faulty_bus.hpp"

namespace {

using namespace faulty;
using nlohmann::json;

/// A fault that a bus cannot have, and what is said about it.
struct Wrong {
  const char* words;
  const char* message;
};

void PrintTo(const Wrong& row, std::ostream* out) {
  *out << row.words;
}

class WrongBusFaults : public testing::TestWithParam<Wrong> {};

TEST_P(WrongBusFaults, AreRefusedInOneLine) {
  Bus bus;

  EXPECT_EQ(bus.inject(GetParam().words), GetParam().message);
  EXPECT_EQ(bus.faults.list(bus.now), json::array());
}

INSTANTIATE_TEST_SUITE_P(
    Words, WrongBusFaults,
    testing::Values(
        Wrong{"bus.dorp",
              "kind: expected bus.drop, bus.delay, bus.duplicate, bus.corrupt, bus.cut, bus.babble, "
              "bus.error-frames, bus.bit-rate or bus.load, got \"bus.dorp\""},
        Wrong{"{\"kind\":", "expected words (bus.drop id=185) or JSON, got {\"kind\":"},
        Wrong{"bus.drop while=operational", "while: expected nothing: a bus has no state, got \"operational\""},
        Wrong{"bus.drop event=sync",
              "event: expected frame, or frame with an identifier (\"frame 185\"): a bus sees frames alone, got "
              "\"sync\""},
        Wrong{"bus.drop until=3 heartbeat",
              "until: expected a count from 1 and frame, or frame with an identifier "
              "(\"frame 185\"): a bus sees frames alone, got \"3 heartbeat\""},
        Wrong{"bus.drop mask=7FF", "mask: expected an id beside it, got \"0x7FF\""},
        Wrong{"bus.delay", "delay_ms: expected a whole number from 1 to 3600000, got nothing"},
        Wrong{"bus.corrupt byte=8", "byte: expected a whole number from 0 to 7, got \"8\""},
        Wrong{"bus.cut members=rw",
              "members: expected process identifiers, kinds (raw, bcm, port, socketcand), interfaces or URLs of "
              "bridges, "
              "with commas between, got \"rw\""},
        Wrong{"bus.cut members=7,,8",
              "members: expected process identifiers, kinds (raw, bcm, port, socketcand), interfaces or URLs of "
              "bridges, "
              "with commas between, got \"\""},
        Wrong{"bus.babble id=1",
              "period_us: expected a time: a bus without a bit rate takes any number of frames at once, got "
              "nothing"},
        Wrong{"bus.load percent=5", "expected a bus with a bit rate for a share of its time, got one without"},
        Wrong{"bus.bit-rate bit_rate=999",
              "bit_rate: expected a whole number from 1000 to 1000000, got \"999\""}));

TEST(BusFaultWords, AreToldAsJsonThatMeansTheSame) {
  Bus bus;
  bus.inject(
      "bus.cut members=raw,can1 id=180 mask=780 event=frame 080 after=2 times=1 for_ms=10 seed=5 probability=0.5");
  bus.inject("bus.error-frames class=error-passive period_ms=20 until=10 frame 185");
  const json first = bus.faults.list(bus.now);

  for (const json& row : first) {
    Bus again;
    ASSERT_TRUE(again.faults.inject(row["fault"], again.now));
    EXPECT_EQ(again.faults.list(again.now)[0]["fault"], row["fault"]);
  }
  EXPECT_EQ(first[0]["fault"]["members"], "raw,can1");
  EXPECT_EQ(first[0]["fault"]["id"], "0x180");
}

TEST(BusFaultWords, TakeAProcessAsANumber) {
  Bus bus;
  ASSERT_TRUE(bus.faults.inject(json{{"kind", "bus.cut"}, {"members", 4711}}, bus.now));
  EXPECT_EQ(bus.faults.list(bus.now)[0]["fault"]["members"], "4711");
}

TEST(BusFaults, AreOfALimitedNumber) {
  Bus bus;
  for (std::size_t i = 0; i < hub::faults::Faults::kMost; ++i) bus.inject("bus.drop");

  EXPECT_EQ(bus.inject("bus.drop"), "expected 64 faults at most, take some of them back first");
}

/// What a member is answered.
json ask(Bus& bus, const std::string& request, int error = 0) {
  const hub::faults::Answer answer = hub::faults::answer(bus.faults, request, bus.now);
  EXPECT_EQ(answer.error, error) << answer.text;
  EXPECT_LT(answer.text.size(), userbus::kLongestMessage - sizeof(userbus::Reply));
  return json::parse(answer.text);
}

TEST(BusFaultAnswer, IsToldInPagesThatFitAMessage) {
  Bus bus;
  for (std::size_t i = 0; i < hub::faults::Faults::kMost; ++i)
    bus.inject("bus.cut members=" + std::string(180, '1') + ",can0 id=180");  // no such process: a wrong word
  EXPECT_EQ(bus.faults.list(bus.now).size(), 0u);
  for (std::size_t i = 0; i < hub::faults::Faults::kMost; ++i)
    bus.inject("bus.cut members=unix:" + std::string(180, 'x') + " id=180 mask=780");

  std::vector<unsigned> numbers;
  while (numbers.size() < hub::faults::Faults::kMost) {
    const json part = ask(bus, json{{"method", "inject.list"}, {"params", {{"behind", numbers.size()}}}}.dump());
    EXPECT_EQ(part["rows"], hub::faults::Faults::kMost);
    ASSERT_FALSE(part["faults"].empty());
    for (const json& row : part["faults"]) numbers.push_back(row["id"].get<unsigned>());
  }
  for (unsigned i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], i + 1);
}

TEST(BusFaultAnswer, DoesWhatItsMethodSays) {
  Bus bus;

  EXPECT_EQ(ask(bus, R"({"method": "inject.add", "params": {"fault": {"kind": "bus.drop", "id": 389}}})"),
            (json{{"id", 1}}));
  EXPECT_EQ(ask(bus, R"({"method": "inject.list"})")["faults"][0]["fault"],
            (json{{"kind", "bus.drop"}, {"id", "0x185"}}));
  EXPECT_EQ(ask(bus, R"({"method": "inject.kinds"})")["kinds"][0]["kind"], "bus.drop");
  EXPECT_EQ(ask(bus, R"({"method": "inject.remove", "params": {"id": 1}})"), (json{{"removed", 1}}));
  EXPECT_EQ(ask(bus, R"({"method": "inject.remove"})"), (json{{"removed", 0}}));
}

TEST(BusFaultAnswer, SaysWhatIsWrongWithARequest) {
  const std::string methods = "method: expected one of inject.add, inject.list, inject.remove, inject.kinds, got ";
  for (const auto& [request, message] : std::vector<std::pair<std::string, std::string>>{
           {"", methods + "nothing"},
           {"[]", methods + "nothing"},
           {R"({"method": 5})", methods + "5"},
           {R"({"method": "inject.drop"})", methods + "\"inject.drop\""},
           {R"({"method": "inject.add", "params": 5})", "params: expected an object, got 5"},
           {R"({"method": "inject.add"})", "fault: expected an object or words, got nothing"},
           {R"({"method": "inject.add", "params": {"fault": 5}})", "expected an object with a kind, got 5"},
           {R"({"method": "inject.remove", "params": {"id": 7}})", "id: expected the number of a fault, got 7"},
           {R"({"method": "inject.remove", "params": {"id": -1}})", "id: expected a whole number, got -1"}}) {
    Bus bus;
    EXPECT_EQ(ask(bus, request, EINVAL), (json{{"message", message}})) << request;
  }
}

}  // namespace
