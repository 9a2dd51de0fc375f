#include "tests/tools/axisctl_fixture.hpp"

namespace {

using fakes::ControlServer;
using fakes::Finished;
using nlohmann::json;

const json kStatus = json::parse(R"({
  "version": "0.1.0", "interface": "vcan0", "node_id": 5, "nmt_state": "Operational", "uptime_s": 12.3,
  "bus": {"state": "error-active", "link": "up", "received": 10, "sent": 20, "dropped": 0, "queued": 1, "refused": 2},
  "leds": {"run": "on", "error": "single flash"},
  "dc_link_V": 538.5, "cycle_ms": 4.0,
  "skipped_cycles": 0,
  "axes": [
    {"axis": 1, "name": "X", "type": "servo", "state": "Operation enabled", "statusword": "0x1637",
     "controlword": "0x000F", "speed_rpm": 1499.75, "setpoint_rpm": 1500, "torque_Nm": 0.5, "load_torque_Nm": 0.5,
     "current_A": 1.25, "motor_temperature_C": 35.5, "position": 4096, "faults": [], "alarms": []},
    {"axis": 2, "name": "Y", "type": "servo", "state": "Fault", "statusword": "0x0218", "controlword": "0x0000",
     "speed_rpm": 0.0, "setpoint_rpm": 0, "torque_Nm": 0.0, "load_torque_Nm": 0.0, "position": -7,
     "faults": [{"number": 7860, "text": "External fault 1"}, {"number": 30001, "text": "Overcurrent"}],
     "alarms": [{"number": 7850, "text": "External alarm 1"}], "colour": "green"}]})");

TEST_F(Axisctl, ShowsTheStatusInAlignedLines) {
  ControlServer server{socket(), answer(kStatus)};

  const Finished run_ = run({"status"});

  EXPECT_EQ(run_.status, 0);
  EXPECT_EQ(run_.errors, "");
  EXPECT_EQ(run_.output, R"(interface       vcan0
node-ID         5
NMT state       Operational
up for          12.300 s
bus             dropped 0, link up, queued 1, received 10, refused 2, sent 20, state error-active
LEDs            error single flash, run on
DC link         538.500 V
cycle           4.000 ms
skipped cycles  0
axisd version   0.1.0
axis 1 X (servo)
  state           Operation enabled
  controlword     0x000F
  statusword      0x1637
  speed setpoint  1500 rpm
  speed           1499.750 rpm
  torque          0.500 N·m
  load torque     0.500 N·m
  current         1.250 A
  motor           35.500 °C
  position        4096
  faults          none
  alarms          none
axis 2 Y (servo)
  state           Fault
  controlword     0x0000
  statusword      0x0218
  speed setpoint  0 rpm
  speed           0.000 rpm
  torque          0.000 N·m
  load torque     0.000 N·m
  position        -7
  faults          F07860 External fault 1, F30001 Overcurrent
  alarms          A07850 External alarm 1
  colour          green
)");
  EXPECT_EQ(json::parse(server.request()), (json{{"id", 1}, {"method", "status"}}));
}

TEST_F(Axisctl, ShowsTheTerminalsAndTheInfeed) {
  ControlServer server{socket(), answer(json::parse(R"({
    "control_unit": {"faults": [], "alarms": [], "inputs": [1, 16], "outputs": []},
    "infeed": {"drive_object": 2, "name": "ALM", "state": "Fault", "operates": false,
               "faults": [{"number": 7802, "text": "Infeed or power unit not ready"}], "alarms": []}})"))};

  EXPECT_EQ(run({"status"}).output, R"(control unit
  faults          none
  alarms          none
  inputs at 1     1, 16
  outputs at 1    none
infeed ALM
  drive object    2
  state           Fault
  operates        false
  faults          F07802 Infeed or power unit not ready
  alarms          none
)");
}

TEST_F(Axisctl, PrintsTheResultAsOneLineOfJson) {
  ControlServer server{socket(), answer(kStatus)};

  const Finished run_ = run({"status", "--json"});

  EXPECT_EQ(run_.status, 0);
  EXPECT_EQ(run_.output, kStatus.dump() + "\n");
}

TEST_F(Axisctl, ShowsAStatusOfAnotherShapeAsFarAsItCan) {
  for (const char* shape : {"{}", "[1,2]", "null", R"({"axes":5})", R"({"axes":[3,{"faults":[5,{}],"axis":"x"}]})",
                            R"({"bus":null,"uptime_s":"long","node_id":[]})"}) {
    std::filesystem::remove(socket());
    ControlServer server{socket(), answer(json::parse(shape))};

    EXPECT_EQ(run({"status"}).status, 0) << shape;
  }
}

}  // namespace
