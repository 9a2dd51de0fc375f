#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/defects.hpp"

namespace conformance_test {
namespace {

using canopen::Frame;
using canopen::NmtCommand;

constexpr std::uint16_t kHeartbeatTime = 0x1017, kConsumers = 0x1016, kLifeTimeFactor = 0x100D;

/// True for heartbeats; with guarding the same identifier holds answers.
bool is_heartbeat(Slave& slave, const Frame& frame) {
  return frame.id == kErrorControlOf5 && frame.data[0] != 0 && stored(slave, kHeartbeatTime) != 0;
}

bool is_guarding_answer(Slave& slave, const Frame& frame) {
  return frame.id == kErrorControlOf5 && frame.data[0] != 0 && stored(slave, kHeartbeatTime) == 0;
}

enum class Error : std::uint8_t { Other, Heartbeat, Guarding };

/// True for the end of an error if the last one that was told is @p error.
bool ends_error(Slave& slave, const Frame& frame, Error error) {
  std::int64_t& last = slave.memory["error"];
  if (is_emergency(frame, 0)) return last == static_cast<std::int64_t>(error);
  if (frame.id != kEmcyOf5) return false;
  const Error lost = of_heartbeat(frame) ? Error::Heartbeat : Error::Guarding;
  last = static_cast<std::int64_t>(is_emergency(frame, 0x8130) ? lost : Error::Other);
  return false;
}

std::vector<WrongSlave> of_heartbeat_producer() {
  return {
      {.name = "LeavesOutHeartbeats",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(is_heartbeat(slave, frame) && stored(slave, kHeartbeatTime) == 100 &&
                                 ++slave.memory["beats"] % 4 == 0);
                      }},
       .found_by = {"error-control.heartbeat-period"}},
      {.name = "BeginsItsHeartbeatLate",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (writes(frame, kHeartbeatTime)) slave.memory["beats"] = 0;
                        return true;
                      },
                  .outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(is_heartbeat(slave, frame) && stored(slave, kHeartbeatTime) == 200 &&
                                 ++slave.memory["beats"] <= 2);
                      }},
       .found_by = {"error-control.heartbeat-begins"}},
      {.name = "DoesNotEndItsHeartbeat",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (is_command(frame, NmtCommand::EnterPreOperational)) slave.node().reload(slave.now());
                        const bool ends = writes(frame, kHeartbeatTime) && (value_of(frame) & 0xFFFFU) == 0 &&
                                          stored(slave, kHeartbeatTime) == 100;
                        if (ends) pretend(slave, frame);
                        return !ends;
                      }},
       .found_by = {"error-control.heartbeat-ends"}},
      {.name = "AlwaysTellsPreOperational",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_heartbeat(slave, frame)) frame.data[0] = 0x7F;
                        return true;
                      }},
       .found_by = {"error-control.heartbeat-state"}},
  };
}

std::vector<WrongSlave> of_heartbeat_consumer() {
  return {
      {.name = "WatchesANodeTwice",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool second = writes(frame, kConsumers, 2) && value_of(frame) >> 16U == 127;
                        if (second) confirm(slave, frame);
                        return !second;
                      }},
       .found_by = {"error-control.consumer-node-twice"}},
      {.name = "WatchesWithoutAFirstHeartbeat",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (!writes(frame, kConsumers, 1) || value_of(frame) >> 16U != 127) return true;
                        slave.node().on_frame(frame, slave.now());
                        slave.node().on_frame({.id = 0x77F, .length = 1, .data = {5}}, slave.now());
                        return false;
                      }},
       .found_by = {"error-control.consumer-begins"}},
      {.name = "DoesNotTellALostHeartbeat",
       .defect = {.outgoing = [](Slave&,
                                 Frame& frame) { return !(is_emergency(frame, 0x8130) && of_heartbeat(frame)); }},
       .found_by = {"error-control.consumer-loss"}},
      {.name = "DoesNotTellThatAHeartbeatIsBack",
       .defect = {.outgoing = [](Slave& slave,
                                 Frame& frame) { return !ends_error(slave, frame, Error::Heartbeat); }},
       .found_by = {"error-control.consumer-return"}},
  };
}

/// A guarding request that the master has not sent.
void ask_itself(Slave& slave) {
  slave.memory["mute"] = 1;
  slave.node().on_frame({.id = kErrorControlOf5, .length = 1, .remote = true}, slave.now());
  slave.memory["mute"] = 0;
}

std::vector<WrongSlave> of_guarding() {
  return {
      {.name = "AnswersNoGuarding",
       .defect = {.outgoing = [](Slave& slave, Frame& frame) { return !is_guarding_answer(slave, frame); }},
       .found_by = {"error-control.guarding-answer"}},
      {.name = "DoesNotToggle",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_guarding_answer(slave, frame)) frame.data[0] &= 0x7FU;
                        return true;
                      }},
       .found_by = {"error-control.guarding-toggle"}},
      {.name = "TogglesTheOtherWay",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_guarding_answer(slave, frame)) frame.data[0] ^= 0x80U;
                        return true;
                      }},
       .found_by = {"error-control.guarding-toggle"}},
      {.name = "AnswersGuardingOfOthers",
       .defect = {.incoming =
                      [](Slave&, Frame& frame) {
                        if (frame.remote && frame.id == 0x77F) frame.id = kErrorControlOf5;
                        return true;
                      }},
       .found_by = {"error-control.guarding-other-node"}},
      {.name = "IsGuardedWithoutARequest",
       .defect = {
           .incoming =
               [](Slave& slave, Frame& frame) {
                 if (!writes(frame, kLifeTimeFactor)) return true;
                 slave.node().on_frame(frame, slave.now());
                 ask_itself(slave);
                 return false;
               },
           .outgoing = [](Slave& slave,
                          Frame& frame) { return !(frame.id == kErrorControlOf5 && slave.memory["mute"] == 1); }},
       .found_by = {"error-control.life-guarding-begins"}},
      {.name = "DoesNotTellALostMaster",
       .defect = {.outgoing = [](Slave&,
                                 Frame& frame) { return !(is_emergency(frame, 0x8130) && !of_heartbeat(frame)); }},
       .found_by = {"error-control.life-guarding-event"}},
      {.name = "DoesNotTellThatItsMasterIsBack",
       .defect = {.outgoing = [](Slave& slave,
                                 Frame& frame) { return !ends_error(slave, frame, Error::Guarding); }},
       .found_by = {"error-control.life-guarding-resumes"}},
      {.name = "AnswersGuardingBesideItsHeartbeat",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.remote && frame.id == kErrorControlOf5 && stored(slave, kHeartbeatTime) != 0)
                          slave.say({.id = kErrorControlOf5, .length = 1, .data = {0x7F}});
                        return true;
                      }},
       .found_by = {"error-control.heartbeat-wins"}},
  };
}

std::vector<WrongSlave> of_error_behaviour() {
  return {
      {.name = "DoesNotStopWithAnError",
       .defect = {.incoming =
                      [](Slave&, Frame& frame) {
                        if (writes(frame, 0x1029, 1) && frame.data[4] == 2) frame.data[4] = 1;
                        return true;
                      }},
       .found_by = {"error-control.error-behaviour"}},
      {.name = "StaysOperationalWithAnErrorByDefault",
       .defect = {.table = [](auto& table) { row(table, 0x1029, 1).initial = 1; },
                  .eds =
                      [](std::string& eds) {
                        const std::size_t section = eds.find("[1029sub1]");
                        eds.replace(eds.find("DefaultValue=0x0", section), 16, "DefaultValue=0x1");
                      }},
       .found_by = {"error-control.error-behaviour-default"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_error_control_slaves() {
  std::vector<WrongSlave> all = of_heartbeat_producer();
  for (auto more : {of_heartbeat_consumer(), of_guarding(), of_error_behaviour()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace conformance_test
