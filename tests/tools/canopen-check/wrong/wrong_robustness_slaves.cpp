#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/defects.hpp"

namespace conformance_test {

using canopen::Frame;
using canopen::NmtCommand;

std::vector<WrongSlave> wrong_robustness_slaves() {
  return {
      {.name = "IsResetByALongSync",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == 0x80 && frame.length == 7)
                          slave.node().command(NmtCommand::ResetCommunication, slave.now());
                        return true;
                      }},
       .found_by = {"robustness.random-frames"}},
      {.name = "AnswersARemoteFrameThatIsNoRequest",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.remote && frame.id == 0x7E0) slave.say({.id = 0x7E0, .length = 1});
                        return true;
                      }},
       .found_by = {"robustness.all-identifiers"}},
      {.name = "IsWornOutByResets",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        std::int64_t& resets = slave.memory["resets"];
                        const bool reset = is_command(frame, NmtCommand::ResetNode) ||
                                           is_command(frame, NmtCommand::ResetCommunication);
                        resets = reset ? resets + 1 : 0;
                        return true;
                      },
                  .outgoing =
                      [](Slave& slave, Frame& frame) {
                        return frame.id != kErrorControlOf5 || frame.data[0] != 0 || slave.memory["resets"] < 15;
                      }},
       .found_by = {"robustness.resets"}},
  };
}

}  // namespace conformance_test
