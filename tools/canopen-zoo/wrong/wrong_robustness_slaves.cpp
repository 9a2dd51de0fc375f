#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {

using canopen::Frame;
using canopen::NmtCommand;

std::vector<WrongSlave> wrong_robustness_slaves() {
  return {
      {.name = "IsResetByALongSync",
       .what = "A SYNC of seven bytes resets its communication.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == 0x80 && frame.length == 7)
                          slave.node().command(NmtCommand::ResetCommunication, slave.now());
                        return true;
                      }},
       .found_by = {"robustness.random-frames"}},
      {.name = "AnswersARemoteFrameThatIsNoRequest",
       .what = "It answers a remote frame under 7E0h, which is nobody's request.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (frame.remote && frame.id == 0x7E0) slave.say({.id = 0x7E0, .length = 1});
                        return true;
                      }},
       .found_by = {"robustness.all-identifiers"}},
      {.name = "IsWornOutByResets",
       .what = "After fifteen resets in a row it sends no more boot-up messages.",
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
                        return frame.id != slave.cob_id(kErrorControl) || frame.data[0] != 0 ||
                               slave.memory["resets"] < 15;
                      }},
       .found_by = {"robustness.resets"}},
  };
}

}  // namespace zoo
