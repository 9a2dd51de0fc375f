#include "tests/tools/canopen-check/conformance_run.hpp"

namespace conformance_test {

std::vector<WrongSlave> wrong_device_slaves() {
  return {};
}

}  // namespace conformance_test
