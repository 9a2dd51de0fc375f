// What a subscriber is told of a unit while a master and an operator work with it.
#include "daemon/control/events/event_json.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using namespace std::chrono_literals;

class EventsOfAUnit : public ControlledUnit, private EventListener {
 protected:
  EventsOfAUnit() { listen(); }
  ~EventsOfAUnit() override { unit().events().remove(*this); }
  EventsOfAUnit(const EventsOfAUnit&) = delete;
  EventsOfAUnit& operator=(const EventsOfAUnit&) = delete;

  void listen() { EXPECT_TRUE(unit().events().add(*this)); }
  void stop_listening() { unit().events().remove(*this); }
  /// What has been told since the last call, without times.
  std::vector<json> told() { return std::exchange(told_, {}); }
  /// What of that is of @p kind.
  std::vector<json> told(std::string_view kind) {
    std::vector<json> events = told();
    std::erase_if(events, [kind](const json& event) { return event.at("kind") != kind; });
    return events;
  }
  static json nmt(std::string_view before, std::string_view state) {
    return {{"kind", "nmt"}, {"before", before}, {"state", state}};
  }
  /// The states that axis 1 went through.
  Lines states() {
    Lines states;
    for (const json& event : told("drive-state")) states.push_back(event.at("state"));
    return states;
  }
  /// Lets a master enable the operation of the axis.
  void enable() {
    for (const char* const controlword : {"06", "07", "0F"}) {
      answer(std::string{"605#2B406000"} + controlword + "000000");
      run(20ms);
    }
  }
  /// Server 0 shows the parameters of the first axis from now on.
  void open_window() {
    answer("605#2BB6410002000000");
    told();
  }

 private:
  void on_event(const UnitEvent& event) noexcept override {
    json line = event_json(unit(), event);
    EXPECT_GE(line.at("t").get<double>(), 0.0);
    line.erase("t");
    told_.push_back(std::move(line));
  }
  std::vector<json> told_;
};

using Told = std::vector<nlohmann::json>;

TEST_F(EventsOfAUnit, TellOfAResetAndAStart) {
  answer("000#8105");
  EXPECT_EQ(told(), (Told{nmt("Pre-operational", "Initialising"),
                          {{"kind", "boot-up"}, {"node_id", 5}},
                          nmt("Initialising", "Pre-operational")}));

  answer("000#0105");
  EXPECT_EQ(told(), Told{nmt("Pre-operational", "Operational")});
}

TEST_F(EventsOfAUnit, TellTheStatesOfAnAxisThatIsSwitchedOn) {
  enable();
  EXPECT_EQ(states(), (Lines{"Ready to switch on", "Switched on", "Operation enabled"}));
}

TEST_F(EventsOfAUnit, TellOfAFaultItsEmergencyAndItsAcknowledgement) {
  result_of("fault.inject", {{"axis", 1}, {"number", 7900}, {"value", 3}});
  run(10ms);
  const Told come = told();
  ASSERT_EQ(come.size(), 4U);
  EXPECT_EQ(come[1], (json{{"kind", "control"},
                           {"method", "fault.inject"},
                           {"text", "axis 1, number 7900, value 3"},
                           {"by", "control"}}));
  EXPECT_EQ(come[0].at("kind"), "emcy");
  EXPECT_EQ(come[0].at("data").get<std::string>().size(), 16U);
  EXPECT_EQ(come[2], (json{{"kind", "fault"},
                           {"drive_object", 2},
                           {"axis", 1},
                           {"number", 7900},
                           {"name", "F07900"},
                           {"text", come[2].at("text")},
                           {"value", 3},
                           {"active", true}}));
  EXPECT_EQ(come[3].at("state"), "Fault");

  result_of("fault.ack", {{"axis", 1}});
  run(10ms);
  const Told gone = told("fault");
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(gone[0].at("active"), false);
}

TEST_F(EventsOfAUnit, TellWhatAClientOfTheSocketHasDone) {
  result_of("load.set", {{"axis", 1}, {"torque_Nm", 1.5}});
  EXPECT_EQ(
      told("control"),
      (Told{{{"kind", "control"}, {"method", "load.set"}, {"text", "axis 1, torque_Nm 1.5"}, {"by", "control"}}}));
  result_of("load.get", {{"axis", 1}});
  result_of("if1.exchange", {{"do", 2}});
  static_cast<void>(error_of("panel.set", {{"axis", 1}, {"on", true}, {"speed_rpm", 1}}));
  EXPECT_TRUE(told("control").empty()) << "looks and refusals";
}

TEST_F(EventsOfAUnit, TellACommandThatIsRenewedOnce) {
  result_of("panel.take", {{"axis", 1}});
  for (int i = 0; i < 3; ++i) result_of("panel.set", {{"axis", 1}, {"on", false}, {"speed_rpm", 0}});
  result_of("panel.set", {{"axis", 1}, {"on", false}, {"speed_rpm", 10}});
  const Told done = told("control");
  ASSERT_EQ(done.size(), 3U);
  EXPECT_EQ(done[0].at("method"), "panel.take");
  EXPECT_EQ(done[2].at("method"), "panel.set");
}

TEST_F(EventsOfAUnit, CutTheTextOfALongRequest) {
  static_cast<void>(
      ask("inject.add", {{"kind", "heartbeat.late"}, {"delay_ms", 5}, {"until", std::string(200, 'x')}}));
  told();
  result_of("inject.add", {{"kind", "heartbeat.late"},
                           {"delay_ms", 5},
                           {"after", 3},
                           {"every", 2},
                           {"for_ms", 60000},
                           {"until", "10 heartbeat"},
                           {"while", "operational"},
                           {"probability", 0.5},
                           {"seed", 123456789},
                           {"times", 4000000000}});
  const Told done = told("control");
  ASSERT_EQ(done.size(), 1U);
  EXPECT_LE(done[0].at("text").get<std::string>().size(), 95U);
}

TEST_F(EventsOfAUnit, TellWhichSdoServerHasWrittenAParameter) {
  open_window();
  answer("605#236024000000A040");
  EXPECT_EQ(told(), (Told{{{"kind", "parameter"},
                           {"drive_object", 2},
                           {"axis", 1},
                           {"parameter", "p1120"},
                           {"before", 10.0},
                           {"value", 5.0},
                           {"by", "sdo"},
                           {"server", 0}}}));
}

TEST_F(EventsOfAUnit, TellWhatTheControlSocketHasWritten) {
  result_of("parameter.write", {{"parameter", "p1120"}, {"value", 2.5}});
  EXPECT_EQ(told(), (Told{{{"kind", "parameter"},
                           {"drive_object", 2},
                           {"axis", 1},
                           {"parameter", "p1120"},
                           {"before", 10.0},
                           {"value", 2.5},
                           {"by", "control"}}}));
}

TEST_F(EventsOfAUnit, TellOfObjectsHoweverTheyAreWritten) {
  const json written{{"kind", "object"}, {"object", "1017:00"}, {"before", 0.0},
                     {"value", 1000.0},  {"by", "sdo"},         {"server", 0}};
  answer("605#2B171000E8030000");
  EXPECT_EQ(told(), Told{written});

  answer("605#2B17100000000000");
  told();
  answer("605#2117100002000000");
  EXPECT_EQ(told(), Told{}) << "nothing is written before the last segment has come";
  answer("605#0BE8030000000000");
  EXPECT_EQ(told(), Told{written});
}

TEST_F(EventsOfAUnit, TellOfWritesThatAreRefused) {
  open_window();
  answer("605#236024000000C8C2");
  answer("605#2B00100001000000");
  const auto refusal = [](const char* object, const char* code, const char* text) {
    return json{{"kind", "refusal"}, {"object", object}, {"abort_code", code},
                {"text", text},      {"by", "sdo"},      {"server", 0}};
  };
  EXPECT_EQ(told(), (Told{refusal("2460:00", "0x06090032", "value too low"),
                          refusal("1000:00", "0x06010002", "read only")}));
}

TEST_F(EventsOfAUnit, NameTheSourceThatAnInputIsConnectedTo) {
  result_of("parameter.write", {{"parameter", "1/p0840"}, {"value", "1"}});
  const Told written = told("parameter");
  ASSERT_EQ(written.size(), 1U);
  EXPECT_EQ(written[0].at("value"), "1");
  EXPECT_TRUE(written[0].at("before").is_string()) << written[0];
}

TEST_F(EventsOfAUnit, TellWhatARecordHasWritten) {
  result_of("parameter.record", {{"request", "01020202 10010460 0000 10010460 0000 0801 40400000 0801 BF800000"}});
  const Told written = told("parameter");
  ASSERT_EQ(written.size(), 1U) << "the second value was refused";
  EXPECT_EQ(written[0].at("value"), 3.0);
  EXPECT_EQ(written[0].at("before"), 10.0);
  EXPECT_EQ(written[0].at("parameter"), "p1120");
}

TEST_F(EventsOfAUnit, SayNothingOfReads) {
  answer("605#4000100000000000");
  answer("605#40FF100000000000");
  EXPECT_EQ(told(), Told{});
}

TEST_F(EventsOfAUnit, TellWhenParametersAreSaved) {
  answer("605#2310100173617665");
  await_write();
  const Told saved = told();
  ASSERT_EQ(saved.size(), 2U);
  EXPECT_EQ(saved[0], (json{{"kind", "store"}, {"done", true}}));
  EXPECT_EQ(saved[1].at("object"), "1010:01") << "whose answer has waited for that";
}

TEST_F(EventsOfAUnit, TellOfTheBusThatGoesAway) {
  port().down = true;
  unit().bus().turn(now(), true);
  EXPECT_EQ(told("link"), (Told{{{"kind", "link"}, {"up", false}}}));
}

TEST_F(EventsOfAUnit, AreNotMadeForNobody) {
  stop_listening();
  EXPECT_FALSE(unit().events().is_watched());
  answer("000#0105");
  enable();
  EXPECT_EQ(told(), Told{});

  listen();
  EXPECT_EQ(told(), Told{}) << "what was before is no news";
  answer("000#8005");
  EXPECT_EQ(told("nmt"), Told{nmt("Operational", "Pre-operational")});
}

}  // namespace
}  // namespace axisd
