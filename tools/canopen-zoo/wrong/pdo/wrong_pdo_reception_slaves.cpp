#include "tools/canopen-zoo/slave/sdo_tricks.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;

constexpr std::uint32_t kFrames = 0x400;  ///< the RPDO that checks reconfigure

bool comes(Slave& slave, const Frame& frame, std::uint32_t type, std::uint8_t length) {
  return frame.id == slave.cob_id(kFrames) && !frame.remote && operational(slave) &&
         held(slave, 0x1402, 2) == type && frame.length == length;
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
  return {.outgoing = [](Slave& slave, Frame& frame) {
    return frame.id != slave.cob_id(kEmcy) || frame.data[0] != 0x50 || frame.data[1] != 0x82;
  }};
}

}  // namespace

std::vector<WrongSlave> wrong_pdo_reception_slaves() {
  return {
      {"TakesSynchronousValuesAtOnce",
       "RPDO 3 of type 1 works at once, not with the next SYNC.",
       synchronous_values_at_once(),
       {"pdo.rpdo-synchronous"}},
      {"LosesSynchronousRpdos", "RPDO 3 of type 1 has no effect.", loses(1, 2), {"pdo.rpdo-synchronous"}},
      {"LosesEventDrivenRpdos", "RPDO 3 of type 255 has no effect.", loses(255, 2), {"pdo.rpdo-event-driven"}},
      {"ProcessesShortRpdos",
       "It takes an RPDO 3 that is too short for its mapping.",
       processes_short_frames(),
       {"pdo.rpdo-too-short"}},
      {"LosesLongRpdos",
       "It drops an RPDO 3 that is longer than its mapping.",
       loses(255, 3),
       {"pdo.rpdo-too-long"}},
      {"SaysNothingOfDeadlines",
       "It sends no EMCY 8250h when RPDO 3 is late.",
       says_nothing_of_deadlines(),
       {"pdo.rpdo-deadline"}},
  };
}

}  // namespace zoo
