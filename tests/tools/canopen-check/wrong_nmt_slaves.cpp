#include "tests/tools/canopen-check/conformance_run.hpp"

namespace conformance_test {

std::vector<WrongSlave> wrong_nmt_slaves() {
  return {
      {.name = "BootsWithoutAWord",
       .defect = {.outgoing = [](Slave&,
                                 canopen::Frame& frame) { return frame.id != 0x705 || frame.data[0] != 0; }},
       .found_by = {"nmt.boot-up-after-reset-node"}},
  };
}

}  // namespace conformance_test
