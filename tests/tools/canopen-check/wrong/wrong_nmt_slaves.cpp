#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/defects.hpp"

namespace conformance_test {
namespace {

using canopen::Frame;
using canopen::NmtCommand;
using canopen::NmtState;

bool is_boot_up(const Frame& frame) {
  return frame.id == kErrorControlOf5 && frame.length == 1 && frame.data[0] == 0;
}

/// Commands that are obeyed otherwise.
std::vector<WrongSlave> of_commands() {
  return {
      {.name = "IgnoresStartInStopped",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        return !(is_command(frame, NmtCommand::Start) &&
                                 slave.node().state() == NmtState::Stopped);
                      }},
       .found_by = {"nmt.transitions"}},
      {.name = "IgnoresResetInStopped",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        return !(is_command(frame, NmtCommand::ResetNode) &&
                                 slave.node().state() == NmtState::Stopped);
                      }},
       .found_by = {"nmt.resets-in-every-state"}},
      {.name = "IgnoresCommandsToAll",
       .defect = {.incoming = [](Slave&, Frame& frame) { return !(frame.id == 0 && frame.data[1] == 0); }},
       .found_by = {"nmt.node-id-0"}},
      {.name = "ObeysCommandsToOthers",
       .defect = {.incoming =
                      [](Slave&, Frame& frame) {
                        if (frame.id == 0 && frame.length == 2 && frame.data[1] != 0) frame.data[1] = 5;
                        return true;
                      }},
       .found_by = {"nmt.other-node-id"}},
      {.name = "HangsOnLongCommands",
       .defect = hangs_on([](const Frame& frame) { return frame.id == 0 && frame.length > 2; }),
       .found_by = {"nmt.wrong-length"}},
      {.name = "StopsOnUnknownCommands",
       .defect = {.policy =
                      [](canopen::Policy& policy) { policy.unknown_command = canopen::UnknownCommand::Stop; }},
       .found_by = {"nmt.unknown-command"}},
  };
}

std::vector<WrongSlave> of_boot_up() {
  return {
      {.name = "BootsWithoutAWord",
       .defect = {.outgoing = [](Slave&, Frame& frame) { return !is_boot_up(frame); }},
       .found_by = {"nmt.boot-up-after-reset-node", "nmt.boot-up-after-reset-communication"}},
      {.name = "BootsWithoutAWordAfterResetCommunication",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == 0 && !frame.remote) slave.memory["command"] = frame.data[0];
                        return true;
                      },
                  .outgoing = [](Slave& slave,
                                 Frame& frame) { return !(is_boot_up(frame) && slave.memory["command"] == 130); }},
       .found_by = {"nmt.boot-up-after-reset-communication"}},
      {.name = "BootsWithTwoMessages",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_boot_up(frame)) slave.say(frame);
                        return true;
                      }},
       .found_by = {"nmt.boot-up-once"}},
      {.name = "StartsByItself",
       .defect = {.policy = [](canopen::Policy& policy) { policy.start_state = NmtState::Operational; }},
       .found_by = {"nmt.pre-operational-after-boot-up"}},
  };
}

/// Says what a TPDO would be with the third SYNC in a row in @p state.
WrongSlave with_tpdo_in(NmtState state, const char* name, const char* check) {
  return {.name = name,
          .defect = {.incoming =
                         [state](Slave& slave, Frame& frame) {
                           std::int64_t& syncs = slave.memory["syncs"];
                           syncs = frame.id == 0x80 && slave.node().state() == state ? syncs + 1 : 0;
                           if (syncs == 3) slave.say({.id = 0x185, .length = 6});
                           return true;
                         }},
          .found_by = {check}};
}

/// Takes what RPDO 1 brings in @p state.
WrongSlave with_rpdo_in(NmtState state, const char* name, const char* check) {
  return {.name = name,
          .defect = {.incoming =
                         [state](Slave& slave, Frame& frame) {
                           if (frame.id == 0x205 && frame.length == 2 && slave.node().state() == state)
                             slave.dictionary().cell<std::uint16_t>(kStep, 0).set(
                                 static_cast<std::uint16_t>(frame.data[0] | frame.data[1] << 8U));
                           return true;
                         }},
          .found_by = {check}};
}

/// Goes on with an upload of 1008h that a reset has ended.
bool goes_on_after_reset(Slave& slave, const Frame& frame) {
  constexpr std::int64_t kNone = 0, kBegun = 1, kReset = 2;
  std::int64_t& transfer = slave.memory["transfer"];
  if (is_command(frame, NmtCommand::ResetCommunication) && transfer == kBegun) transfer = kReset;
  if (frame.id != kRequestOf5) return true;
  const bool segment = frame.data[0] == 0x60;
  if (segment && transfer == kReset) {
    slave.say({.id = kResponseOf5, .length = 8, .data = {0x00, 'R', 'i', 'g', 'h', 't', ' ', 's'}});
    return false;
  }
  transfer = frame.data[0] == 0x40 && frame.data[1] == 0x08 && frame.data[2] == 0x10 ? kBegun : kNone;
  return true;
}

std::vector<WrongSlave> of_services() {
  return {
      with_tpdo_in(NmtState::PreOperational, "SendsTpdosInPreOperational", "nmt.no-tpdo-in-pre-operational"),
      with_tpdo_in(NmtState::Stopped, "SendsTpdosInStopped", "nmt.no-tpdo-in-stopped"),
      with_rpdo_in(NmtState::PreOperational, "TakesRpdosInPreOperational", "nmt.no-rpdo-in-pre-operational"),
      with_rpdo_in(NmtState::Stopped, "TakesRpdosInStopped", "nmt.no-rpdo-in-stopped"),
      {.name = "AnswersSdoInStopped",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == kRequestOf5 && slave.node().state() == NmtState::Stopped)
                          slave.say({.id = kResponseOf5, .length = 8, .data = {0x43, 0x00, 0x10, 0x00}});
                        return true;
                      }},
       .found_by = {"nmt.no-sdo-in-stopped"}},
      {.name = "GoesOnWithATransferAfterAReset",
       .defect = {.incoming = [](Slave& slave, Frame& frame) { return goes_on_after_reset(slave, frame); }},
       .found_by = {"nmt.reset-during-sdo"}},
      {.name = "KeepsItsHeartbeatTimeOverAReset",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        slave.memory["time"] =
                            is_command(frame, NmtCommand::ResetCommunication) ? stored(slave, 0x1017) : 0;
                        return true;
                      },
                  .after_reset =
                      [](Slave& slave) {
                        const std::int64_t time = slave.memory["time"];
                        if (time == 250) slave.dictionary().set(*slave.dictionary().lookup(0x1017, 0), time);
                      }},
       .found_by = {"nmt.reset-communication-objects"}},
      {.name = "ForgetsTheApplicationWithTheCommunication",
       .defect = {.after_reset = [](Slave& slave) { slave.dictionary().cell<std::uint16_t>(kStep, 0).set(1); }},
       .found_by = {"nmt.reset-application-objects"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_nmt_slaves() {
  std::vector<WrongSlave> all = of_commands();
  for (auto more : {of_boot_up(), of_services()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace conformance_test
