#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;
using canopen::NmtCommand;

constexpr std::uint16_t kHeartbeatTime = 0x1017, kConsumers = 0x1016, kLifeTimeFactor = 0x100D;
constexpr std::uint32_t kHighestNodeId = 127;

/// True for heartbeats; with guarding the same identifier holds answers.
bool is_heartbeat(Slave& slave, const Frame& frame) {
  return frame.id == slave.cob_id(kErrorControl) && frame.data[0] != 0 && stored(slave, kHeartbeatTime) != 0;
}

bool is_guarding_answer(Slave& slave, const Frame& frame) {
  return frame.id == slave.cob_id(kErrorControl) && frame.data[0] != 0 && stored(slave, kHeartbeatTime) == 0;
}

enum class Error : std::uint8_t { Other, Heartbeat, Guarding };

/// True for the end of an error if the last one that was told is @p error.
bool ends_error(Slave& slave, const Frame& frame, Error error) {
  std::int64_t& last = slave.memory["error"];
  if (is_emergency(slave, frame, 0)) return last == static_cast<std::int64_t>(error);
  if (frame.id != slave.cob_id(kEmcy)) return false;
  const Error lost = of_heartbeat(frame) ? Error::Heartbeat : Error::Guarding;
  last = static_cast<std::int64_t>(is_emergency(slave, frame, 0x8130) ? lost : Error::Other);
  return false;
}

std::vector<WrongSlave> of_heartbeat_producer() {
  return {
      {.name = "LeavesOutHeartbeats",
       .what = "It leaves out every fourth heartbeat of a period of 100 ms.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(is_heartbeat(slave, frame) && stored(slave, kHeartbeatTime) == 100 &&
                                 ++slave.memory["beats"] % 4 == 0);
                      }},
       .found_by = {"error-control.heartbeat-period"}},
      {.name = "BeginsItsHeartbeatLate",
       .what = "It leaves out the first two heartbeats after 1017h was set to 200 ms.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (writes(slave, frame, kHeartbeatTime)) slave.memory["beats"] = 0;
                        return true;
                      },
                  .outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(is_heartbeat(slave, frame) && stored(slave, kHeartbeatTime) == 200 &&
                                 ++slave.memory["beats"] <= 2);
                      }},
       .found_by = {"error-control.heartbeat-begins"}},
      {.name = "DoesNotEndItsHeartbeat",
       .what = "A heartbeat of 100 ms goes on after 0 was written to 1017h.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (is_command(frame, NmtCommand::EnterPreOperational)) slave.node().reload(slave.now());
                        const bool ends = writes(slave, frame, kHeartbeatTime) &&
                                          (value_of(frame) & 0xFFFFU) == 0 && stored(slave, kHeartbeatTime) == 100;
                        if (ends) pretend(slave, frame);
                        return !ends;
                      }},
       .found_by = {"error-control.heartbeat-ends"}},
      {.name = "AlwaysTellsPreOperational",
       .what = "Its heartbeat says Pre-operational in every state.",
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
       .what = "It takes a second heartbeat consumer for a node that it watches already.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const std::int64_t first = stored(slave, kConsumers, 1) >> 16;
                        const bool second =
                            writes(slave, frame, kConsumers, 2) && first != 0 && value_of(frame) >> 16U == first;
                        if (second) confirm(slave, frame);
                        return !second;
                      }},
       .found_by = {"error-control.consumer-node-twice"}},
      {.name = "WatchesWithoutAFirstHeartbeat",
       .what = "It watches a node from the write to 1016h on, not from the first heartbeat on.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const std::uint32_t node = value_of(frame) >> 16U;
                        if (!writes(slave, frame, kConsumers, 1) || node == 0 || node > kHighestNodeId)
                          return true;
                        slave.node().on_frame(frame, slave.now());
                        slave.node().on_frame({.id = kErrorControl + node, .length = 1, .data = {5}}, slave.now());
                        return false;
                      }},
       .found_by = {"error-control.consumer-begins"}},
      {.name = "DoesNotTellALostHeartbeat",
       .what = "It sends no EMCY 8130h when a heartbeat that it watches is lost.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(is_emergency(slave, frame, 0x8130) && of_heartbeat(frame));
                      }},
       .found_by = {"error-control.consumer-loss"}},
      {.name = "DoesNotTellThatAHeartbeatIsBack",
       .what = "It sends no EMCY 0000h when a lost heartbeat is back.",
       .defect = {.outgoing = [](Slave& slave,
                                 Frame& frame) { return !ends_error(slave, frame, Error::Heartbeat); }},
       .found_by = {"error-control.consumer-return"}},
  };
}

/// A guarding request that the master has not sent.
void ask_itself(Slave& slave) {
  slave.memory["mute"] = 1;
  slave.node().on_frame({.id = slave.cob_id(kErrorControl), .length = 1, .remote = true}, slave.now());
  slave.memory["mute"] = 0;
}

std::vector<WrongSlave> of_guarding() {
  return {
      {.name = "AnswersNoGuarding",
       .what = "It does not answer node guarding.",
       .defect = {.outgoing = [](Slave& slave, Frame& frame) { return !is_guarding_answer(slave, frame); }},
       .found_by = {"error-control.guarding-answer"}},
      {.name = "DoesNotToggle",
       .what = "The toggle bit of its guarding answers stays 0.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_guarding_answer(slave, frame)) frame.data[0] &= 0x7FU;
                        return true;
                      }},
       .found_by = {"error-control.guarding-toggle"}},
      {.name = "TogglesTheOtherWay",
       .what = "The toggle bit of its guarding answers begins with 1.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_guarding_answer(slave, frame)) frame.data[0] ^= 0x80U;
                        return true;
                      }},
       .found_by = {"error-control.guarding-toggle"}},
      {.name = "AnswersGuardingOfOthers",
       .what = "It answers guarding requests to other nodes under its own identifier.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.remote && frame.id > kErrorControl && frame.id <= kErrorControl + kHighestNodeId)
                          frame.id = slave.cob_id(kErrorControl);
                        return true;
                      }},
       .found_by = {"error-control.guarding-other-node"}},
      {.name = "IsGuardedWithoutARequest",
       .what = "Life guarding begins with the write to 100Dh, before the first guarding request.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (!writes(slave, frame, kLifeTimeFactor)) return true;
                        slave.node().on_frame(frame, slave.now());
                        ask_itself(slave);
                        return false;
                      },
                  .outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(frame.id == slave.cob_id(kErrorControl) && slave.memory["mute"] == 1);
                      }},
       .found_by = {"error-control.life-guarding-begins"}},
      {.name = "DoesNotTellALostMaster",
       .what = "It sends no EMCY 8130h when guarding requests fail to come.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        return !(is_emergency(slave, frame, 0x8130) && !of_heartbeat(frame));
                      }},
       .found_by = {"error-control.life-guarding-event"}},
      {.name = "DoesNotTellThatItsMasterIsBack",
       .what = "It sends no EMCY 0000h when guarding requests come again.",
       .defect = {.outgoing = [](Slave& slave,
                                 Frame& frame) { return !ends_error(slave, frame, Error::Guarding); }},
       .found_by = {"error-control.life-guarding-resumes"}},
      {.name = "AnswersGuardingBesideItsHeartbeat",
       .what = "It answers guarding although its heartbeat is on.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.remote && frame.id == slave.cob_id(kErrorControl) &&
                            stored(slave, kHeartbeatTime) != 0)
                          slave.say({.id = slave.cob_id(kErrorControl), .length = 1, .data = {0x7F}});
                        return true;
                      }},
       .found_by = {"error-control.heartbeat-wins"}},
  };
}

std::vector<WrongSlave> of_error_behaviour() {
  return {
      {.name = "DoesNotStopWithAnError",
       .what = "It goes to Pre-operational with a communication error although 1029h:01 says Stopped.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (writes(slave, frame, 0x1029, 1) && frame.data[4] == 2) frame.data[4] = 1;
                        return true;
                      }},
       .found_by = {"error-control.error-behaviour"}},
      {.name = "StaysOperationalWithAnErrorByDefault",
       .what = "1029h:01 is 1 by default: it stays Operational with a communication error.",
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

}  // namespace zoo
