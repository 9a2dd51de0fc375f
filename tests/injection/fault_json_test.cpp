#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

using nlohmann::json;

std::string problem_of(std::string_view text) {
  const auto fault = read_fault(json::parse(text), unit_kinds());
  return fault ? "" : fault.error().message();
}

TEST(FaultJson, IsReadAndWrittenAlike) {
  const json value{{"kind", "sdo.abort"},
                   {"code", "0x8000000"},
                   {"object", "0x6040"},
                   {"sub_index", 0},
                   {"server", 2},
                   {"step", 3},
                   {"event", "frame 185"},
                   {"after", 10},
                   {"every", 5},
                   {"times", 3},
                   {"probability", 0.25},
                   {"seed", 7},
                   {"while", "operational"},
                   {"until", "10 heartbeat"},
                   {"for_ms", 500}};
  const auto fault = read_fault(value, unit_kinds());
  ASSERT_TRUE(fault) << fault.error().message();
  EXPECT_EQ(json_of(*fault), value);
}

TEST(FaultJson, TakesNumbersAndTexts) {
  const auto fault = read_fault(
      json::parse(R"({"kind": "sdo.abort", "code": 134217728, "object": "6040", "times": "2"})"), unit_kinds());
  ASSERT_TRUE(fault) << fault.error().message();
  EXPECT_EQ(fault->value(Argument::Code), 0x08000000U);
  EXPECT_EQ(fault->value(Argument::Object), 0x6040U);
  EXPECT_EQ(fault->when.times, 2U);
}

TEST(FaultJson, IsWrittenAsWordsToo) {
  const Fault fault = fault_of("tpdo.late delay_ms=20 pdo=2 while=operational until=10 frame 705");
  EXPECT_EQ(fault.value(Argument::DelayMs), 20U);
  EXPECT_EQ(fault.when.during, State::Operational);
  EXPECT_EQ(fault.when.until, (Milestone{10, {EventKind::Frame, 0x705}}));
}

TEST(FaultJson, SaysWhatIsWrong) {
  EXPECT_EQ(problem_of("5"), "expected an object with a kind, got 5");
  EXPECT_NE(problem_of(R"({"kind": "sdo.lat"})").find("kind: expected sdo.deaf, sdo.silent"), std::string::npos);
  EXPECT_EQ(problem_of(R"({"kind": "sdo.late"})"),
            "delay_ms: expected a whole number from 1 to 3600000, got nothing");
  EXPECT_EQ(problem_of(R"({"kind": "sdo.late", "delay_ms": 0})"),
            "delay_ms: expected a whole number from 1 to 3600000, got 0");
  EXPECT_EQ(problem_of(R"({"kind": "sdo.late", "delay_ms": -1})"),
            "delay_ms: expected a whole number from 1 to 3600000, got -1");
  EXPECT_EQ(problem_of(R"({"kind": "sdo.abort", "code": "0x100000000"})"),
            "code: expected a number from 0h to FFFFFFFFh (\"0xFFFFFFFF\"), got \"0x100000000\"");
  EXPECT_EQ(
      problem_of(R"({"kind": "sdo.silent", "pdo": 1})"),
      "pdo: unknown key, expected one of: kind, object, sub_index, server, step, event, after, every, times, "
      "probability, seed, while, until, for_ms");
  EXPECT_EQ(problem_of(R"({"kind": "heartbeat.state", "state": "fault"})"),
            "state: expected stopped, pre-operational or operational, got \"fault\"");
  EXPECT_EQ(problem_of(R"({"kind": "sdo.silent", "probability": 1.5})"),
            "probability: expected a number from 0 to 1, got 1.5");
  EXPECT_EQ(problem_of(R"({"kind": "sdo.silent", "times": 0})"),
            "times: expected a whole number from 1 to 4294967295, got 0");
  EXPECT_NE(
      problem_of(R"({"kind": "sdo.silent", "until": "10"})").find("until: expected a count from 1 and an event"),
      std::string::npos);
}

TEST(FaultJson, OfAKindSaysWhatItTakes) {
  for (const Kind& kind : unit_kinds()) {
    const json told = json_of(kind);
    EXPECT_EQ(told["kind"], kind.name);
    EXPECT_EQ(told["arguments"].size(), kind.arguments.size());
  }
}

}  // namespace
}  // namespace injection
