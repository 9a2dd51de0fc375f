#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/sdo_tricks.hpp"

namespace conformance_test {
namespace {

using canopen::Frame;

constexpr std::uint32_t kFrames = 0x405;  ///< the RPDO that checks reconfigure

bool comes(Slave& slave, const Frame& frame, std::uint32_t type, std::uint8_t length) {
  return frame.id == kFrames && !frame.remote && operational(slave) && held(slave, 0x1402, 2) == type &&
         frame.length == length;
}

Defect synchronous_values_at_once() {
  return {.incoming = [](Slave& slave, Frame& frame) {
    if (comes(slave, frame, 1, 2))
      slave.dictionary().set(*slave.dictionary().lookup(kStep, 0), frame.data[0] | frame.data[1] << 8);
    return true;
  }};
}

Defect loses(std::uint32_t type, std::uint8_t length) {
  return {.incoming = [=](Slave& slave, Frame& frame) {
    return !comes(slave, frame, type, length) || held(slave, 0x1402, 5) != 0;
  }};
}

Defect processes_short_frames() {
  return {.incoming = [](Slave& slave, Frame& frame) {
    if (comes(slave, frame, 255, 1)) frame.length = 2;
    return true;
  }};
}

Defect says_nothing_of_deadlines() {
  return {.outgoing = [](Slave&, Frame& frame) {
    return frame.id != 0x85 || frame.data[0] != 0x50 || frame.data[1] != 0x82;
  }};
}

}  // namespace

std::vector<WrongSlave> wrong_pdo_reception_slaves() {
  return {
      {"TakesSynchronousValuesAtOnce", synchronous_values_at_once(), {"pdo.rpdo-synchronous"}},
      {"LosesSynchronousRpdos", loses(1, 2), {"pdo.rpdo-synchronous"}},
      {"LosesEventDrivenRpdos", loses(255, 2), {"pdo.rpdo-event-driven"}},
      {"ProcessesShortRpdos", processes_short_frames(), {"pdo.rpdo-too-short"}},
      {"LosesLongRpdos", loses(255, 3), {"pdo.rpdo-too-long"}},
      {"SaysNothingOfDeadlines", says_nothing_of_deadlines(), {"pdo.rpdo-deadline"}},
  };
}

}  // namespace conformance_test
