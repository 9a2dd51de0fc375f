#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;
using canopen::NmtCommand;
using canopen::NmtState;

bool is_boot_up(const Slave& slave, const Frame& frame) {
  return frame.id == slave.cob_id(kErrorControl) && frame.length == 1 && frame.data[0] == 0;
}

/// Commands that are obeyed otherwise.
std::vector<WrongSlave> of_commands() {
  return {
      {.name = "IgnoresStartInStopped",
       .what = "It does not obey Start in Stopped.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        return !(is_command(frame, NmtCommand::Start) &&
                                 slave.node().state() == NmtState::Stopped);
                      }},
       .found_by = {"nmt.transitions"}},
      {.name = "IgnoresResetInStopped",
       .what = "It does not obey Reset node in Stopped.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        return !(is_command(frame, NmtCommand::ResetNode) &&
                                 slave.node().state() == NmtState::Stopped);
                      }},
       .found_by = {"nmt.resets-in-every-state"}},
      {.name = "IgnoresCommandsToAll",
       .what = "It does not obey NMT commands with node-ID 0.",
       .defect = {.incoming = [](Slave&, Frame& frame) { return !(frame.id == 0 && frame.data[1] == 0); }},
       .found_by = {"nmt.node-id-0"}},
      {.name = "ObeysCommandsToOthers",
       .what = "It obeys NMT commands that are for another node.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == 0 && frame.length == 2 && frame.data[1] != 0)
                          frame.data[1] = slave.node_id();
                        return true;
                      }},
       .found_by = {"nmt.other-node-id"}},
      {.name = "HangsOnLongCommands",
       .what = "After an NMT command of more than two bytes it is silent until a reset.",
       .defect = hangs_on([](const Slave&, const Frame& frame) { return frame.id == 0 && frame.length > 2; }),
       .found_by = {"nmt.wrong-length"}},
      {.name = "StopsOnUnknownCommands",
       .what = "An NMT command that does not exist stops it.",
       .defect = {.policy =
                      [](canopen::Policy& policy) { policy.unknown_command = canopen::UnknownCommand::Stop; }},
       .found_by = {"nmt.unknown-command"}},
  };
}

std::vector<WrongSlave> of_boot_up() {
  return {
      {.name = "BootsWithoutAWord",
       .what = "It sends no boot-up message.",
       .defect = {.outgoing = [](Slave& slave, Frame& frame) { return !is_boot_up(slave, frame); }},
       .found_by = {"nmt.boot-up-after-reset-node", "nmt.boot-up-after-reset-communication"}},
      {.name = "BootsWithoutAWordAfterResetCommunication",
       .what = "It sends no boot-up message after Reset communication.",
       .defect = {
           .incoming =
               [](Slave& slave, Frame& frame) {
                 if (frame.id == 0 && !frame.remote) slave.memory["command"] = frame.data[0];
                 return true;
               },
           .outgoing = [](Slave& slave,
                          Frame& frame) { return !(is_boot_up(slave, frame) && slave.memory["command"] == 130); }},
       .found_by = {"nmt.boot-up-after-reset-communication"}},
      {.name = "BootsWithTwoMessages",
       .what = "It sends its boot-up message twice.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_boot_up(slave, frame)) slave.say(frame);
                        return true;
                      }},
       .found_by = {"nmt.boot-up-once"}},
      {.name = "StartsByItself",
       .what = "It goes to Operational by itself after boot-up.",
       .defect = {.policy = [](canopen::Policy& policy) { policy.start_state = NmtState::Operational; }},
       .found_by = {"nmt.pre-operational-after-boot-up"}},
  };
}

/// Says what a TPDO would be with the third SYNC in a row in @p state.
WrongSlave with_tpdo_in(NmtState state, const char* name, const char* what, const char* check) {
  return {.name = name,
          .what = what,
          .defect = {.incoming =
                         [state](Slave& slave, Frame& frame) {
                           std::int64_t& syncs = slave.memory["syncs"];
                           syncs = frame.id == 0x80 && slave.node().state() == state ? syncs + 1 : 0;
                           if (syncs == 3) slave.say({.id = slave.cob_id(0x180), .length = 6});
                           return true;
                         }},
          .found_by = {check}};
}

/// Takes what RPDO 1 brings in @p state.
WrongSlave with_rpdo_in(NmtState state, const char* name, const char* what, const char* check) {
  return {
      .name = name,
      .what = what,
      .defect = {.incoming =
                     [state](Slave& slave, Frame& frame) {
                       if (frame.id == slave.cob_id(0x200) && frame.length == 2 && slave.node().state() == state)
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
  if (frame.id != slave.cob_id(kSdoRequest)) return true;
  const bool segment = frame.data[0] == 0x60;
  if (segment && transfer == kReset) {
    slave.say({.id = slave.cob_id(kSdoResponse), .length = 8, .data = {0x00, 'R', 'i', 'g', 'h', 't', ' ', 's'}});
    return false;
  }
  transfer = frame.data[0] == 0x40 && frame.data[1] == 0x08 && frame.data[2] == 0x10 ? kBegun : kNone;
  return true;
}

std::vector<WrongSlave> of_services() {
  return {
      with_tpdo_in(NmtState::PreOperational, "SendsTpdosInPreOperational",
                   "It sends a TPDO with every third SYNC in Pre-operational.", "nmt.no-tpdo-in-pre-operational"),
      with_tpdo_in(NmtState::Stopped, "SendsTpdosInStopped", "It sends a TPDO with every third SYNC in Stopped.",
                   "nmt.no-tpdo-in-stopped"),
      with_rpdo_in(NmtState::PreOperational, "TakesRpdosInPreOperational",
                   "It takes the values of RPDO 1 in Pre-operational.", "nmt.no-rpdo-in-pre-operational"),
      with_rpdo_in(NmtState::Stopped, "TakesRpdosInStopped", "It takes the values of RPDO 1 in Stopped.",
                   "nmt.no-rpdo-in-stopped"),
      {.name = "AnswersSdoInStopped",
       .what = "It answers SDO requests in Stopped.",
       .defect =
           {.incoming =
                [](Slave& slave, Frame& frame) {
                  if (frame.id == slave.cob_id(kSdoRequest) && slave.node().state() == NmtState::Stopped)
                    slave.say({.id = slave.cob_id(kSdoResponse), .length = 8, .data = {0x43, 0x00, 0x10, 0x00}});
                  return true;
                }},
       .found_by = {"nmt.no-sdo-in-stopped"}},
      {.name = "GoesOnWithATransferAfterAReset",
       .what = "It goes on with an SDO upload that a reset has ended.",
       .defect = {.incoming = [](Slave& slave, Frame& frame) { return goes_on_after_reset(slave, frame); }},
       .found_by = {"nmt.reset-during-sdo"}},
      {.name = "KeepsItsHeartbeatTimeOverAReset",
       .what = "A heartbeat time of 250 ms survives Reset communication.",
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
       .what = "Reset communication sets 2001h, an object of the application, back too.",
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

}  // namespace zoo
