#include "tools/canopen-zoo/slave/sdo_tricks.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;

constexpr std::uint16_t kTpdo = 0x1802;  ///< parameters of the TPDO that checks reconfigure
constexpr std::uint32_t kFrames = 0x380;

std::uint32_t type_of(Slave& slave) {
  return held(slave, kTpdo, 2);
}

bool starts(const Frame& frame) {
  return frame.id == 0 && frame.data[0] == 1;
}

bool is_sync(const Frame& frame) {
  return frame.id == 0x80;
}

/// A frame of the TPDO, which maps kMirror alone.
Frame mirror_frame(const Slave& slave, std::uint32_t value) {
  return {.id = slave.cob_id(kFrames),
          .length = 2,
          .data = {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8U)}};
}

void put_mirror(Frame& frame, std::int64_t value) {
  frame.data[0] = static_cast<std::uint8_t>(value);
  frame.data[1] = static_cast<std::uint8_t>(value >> 8);
}

/// Drops the first event-driven frame behind each start.
Defect no_first_frame() {
  return {.incoming =
              [](Slave& slave, Frame& frame) {
                if (starts(frame)) slave.memory["fresh"] = 1;
                return true;
              },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                return frame.id != slave.cob_id(kFrames) || type_of(slave) < 254 ||
                       std::exchange(slave.memory["fresh"], 0) == 0;
              }};
}

/// Sends the first event-driven frame behind each start twice.
Defect two_first_frames() {
  Defect defect = no_first_frame();
  defect.outgoing = [](Slave& slave, Frame& frame) {
    if (frame.id == slave.cob_id(kFrames) && type_of(slave) >= 254 && std::exchange(slave.memory["fresh"], 0) != 0)
      slave.say(frame);
    return true;
  };
  return defect;
}

Defect every_second_period() {
  return {.outgoing = [](Slave& slave, Frame& frame) {
    const bool timed = frame.id == slave.cob_id(kFrames) && type_of(slave) >= 254 && held(slave, kTpdo, 5) != 0;
    return !timed || ++slave.memory["frames"] % 2 != 0;
  }};
}

/// True for an SDO that changes kMirror while the TPDO is in force with that type.
std::optional<Write> event_in(Slave& slave, const Frame& frame, std::uint32_t type) {
  const auto write = write_in(slave, frame);
  const bool event = write && write->index == kMirror && operational(slave) && type_of(slave) == type;
  return event ? write : std::nullopt;
}

Defect two_frames_for_an_event() {
  return {.incoming =
              [](Slave& slave, Frame& frame) {
                if (event_in(slave, frame, 255) && held(slave, kTpdo, 3) == 0) slave.memory["twice"] = 1;
                return true;
              },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                if (frame.id == slave.cob_id(kFrames) && std::exchange(slave.memory["twice"], 0) != 0)
                  slave.say(frame);
                return true;
              }};
}

Defect no_inhibit_time() {
  return {.incoming = [](Slave& slave, Frame& frame) {
    if (const auto event = event_in(slave, frame, 255); event && held(slave, kTpdo, 3) != 0)
      slave.say(mirror_frame(slave, event->value));
    return true;
  }};
}

Defect first_value_after_the_inhibit_time() {
  return {.outgoing = [](Slave& slave, Frame& frame) {
    if (frame.id != slave.cob_id(kFrames) || type_of(slave) != 255 || held(slave, kTpdo, 3) == 0) return true;
    const auto first = slave.memory.try_emplace("first", frame.data[0] | frame.data[1] << 8).first;
    put_mirror(frame, first->second);
    return true;
  }};
}

Defect misses_a_sync_now_and_then() {
  return {.outgoing = [](Slave& slave, Frame& frame) {
    return frame.id != slave.cob_id(kFrames) || type_of(slave) != 1 || ++slave.memory["frames"] % 150 != 0;
  }};
}

/// Sends the TPDO at each frame that fulfils @p when, in Operational with that type.
Defect says_a_frame(bool (*when)(const Frame&), std::uint32_t type) {
  return {.incoming = [when, type](Slave& slave, Frame& frame) {
    if (when(frame) && type_of(slave) == type && (held(slave, kTpdo, 1) & 0x80000000U) == 0 &&
        (operational(slave) || starts(frame)))
      slave.say(mirror_frame(slave, held(slave, kMirror, 0)));
    return true;
  }};
}

Defect present_values_in_type_252() {
  return {.outgoing = [](Slave& slave, Frame& frame) {
    if (frame.id == slave.cob_id(kFrames) && type_of(slave) == 252) put_mirror(frame, held(slave, kMirror, 0));
    return true;
  }};
}

Defect old_values_in_type_253() {
  return {.incoming =
              [](Slave& slave, Frame& frame) {
                if (is_sync(frame)) slave.memory["mirror"] = held(slave, kMirror, 0);
                return true;
              },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                if (frame.id == slave.cob_id(kFrames) && type_of(slave) == 253)
                  put_mirror(frame, slave.memory["mirror"]);
                return true;
              }};
}

/// Answers requests of the TPDO where @p answers says so.
Defect answers_requests(bool (*answers)(Slave&)) {
  return {.incoming = [answers](Slave& slave, Frame& frame) {
    if (frame.remote && frame.id == slave.cob_id(kFrames) && answers(slave)) slave.say(mirror_frame(slave, 0));
    return true;
  }};
}

std::vector<WrongSlave> wrong_events() {
  return {
      {"SendsNoFirstFrame",
       "It does not send its event-driven TPDO 3 on the way to Operational.",
       no_first_frame(),
       {"pdo.first-frame"}},
      {"SendsItsFirstFrameTwice",
       "It sends its event-driven TPDO 3 twice on the way to Operational.",
       two_first_frames(),
       {"pdo.event-timer-off"}},
      {"RepeatsHalfAsOften",
       "It sends TPDO 3 only every second time that the event timer has passed.",
       every_second_period(),
       {"pdo.event-timer", "pdo.event-timer-change"}},
      {"TakesNoEventTimerInOperational",
       "It confirms an event timer for TPDO 3 in Operational, and forgets it.",
       pretends_to_write([](Slave& slave, const Write& write) {
         return write.index == kTpdo && write.sub_index == 5 && operational(slave);
       }),
       {"pdo.event-timer-change"}},
      {"SendsAnEventTwice",
       "It sends TPDO 3 twice for a change of 2007h.",
       two_frames_for_an_event(),
       {"pdo.event"}},
      {"KeepsNoInhibitTime", "It sends TPDO 3 within its inhibit time.", no_inhibit_time(), {"pdo.inhibit-time"}},
      {"LosesTheLastValue",
       "TPDO 3 shows the first value behind its inhibit time, not the last one.",
       first_value_after_the_inhibit_time(),
       {"pdo.inhibit-time"}},
  };
}

std::vector<WrongSlave> wrong_synchronous_tpdos() {
  return {
      {"MissesASyncNowAndThen",
       "It leaves out TPDO 3 with every 150th SYNC.",
       misses_a_sync_now_and_then(),
       {"pdo.sync-count"}},
      {"CountsToTwo",
       "Type 3 of TPDO 3 becomes 2: it comes with every second SYNC.",
       writes_otherwise([](Slave&, const Write& write) -> std::optional<std::uint32_t> {
         if (write.index != kTpdo || write.sub_index != 2 || write.value != 3) return std::nullopt;
         return 2;
       }),
       {"pdo.every-nth-sync"}},
      {"SendsWithoutSync",
       "It sends TPDO 3 of type 1 at Start, without a SYNC.",
       says_a_frame(starts, 1),
       {"pdo.no-sync"}},
      {"SendsType0WithEverySync",
       "It sends TPDO 3 of type 0 with every SYNC, changed or not.",
       says_a_frame(is_sync, 0),
       {"pdo.acyclic"}},
      {"KnowsNoStartValue",
       "A SYNC start value of 3 for TPDO 3 becomes 0.",
       writes_otherwise([](Slave&, const Write& write) -> std::optional<std::uint32_t> {
         if (write.index != kTpdo || write.sub_index != 6 || write.value != 3) return std::nullopt;
         return 0;
       }),
       {"pdo.sync-start-value"}},
      {"LosesATpdoBesideOthers",
       "It never sends TPDO 1 while TPDO 2 is synchronous.",
       {.outgoing = [](Slave& slave,
                       Frame& frame) { return frame.id != slave.cob_id(0x180) || held(slave, 0x1801, 2) != 1; }},
       {"pdo.all-with-sync"}},
  };
}

std::vector<WrongSlave> wrong_requests() {
  return {
      {"AnswersNoRequests",
       "It does not answer remote requests of TPDOs.",
       {.policy = [](canopen::Policy& policy) { policy.tpdo_requests = false; }},
       {"pdo.remote-request", "pdo.remote-request-sync", "pdo.remote-request-present"}},
      {"AnswersForbiddenRequests",
       "It answers remote requests of TPDO 3 though bit 30 of its COB-ID forbids them.",
       answers_requests([](Slave& slave) {
         return operational(slave) && (held(slave, kTpdo, 1) & 0x40000000U) != 0 && type_of(slave) == 255;
       }),
       {"pdo.remote-request-forbidden"}},
      {"ShowsPresentValuesInType252",
       "TPDO 3 of type 252 shows present values, not those of the last SYNC.",
       present_values_in_type_252(),
       {"pdo.remote-request-sync"}},
      {"ShowsOldValuesInType253",
       "TPDO 3 of type 253 shows values of the last SYNC, not present ones.",
       old_values_in_type_253(),
       {"pdo.remote-request-present"}},
      {"AnswersRequestsWhenStopped",
       "It answers remote requests of TPDO 3 in Stopped.",
       answers_requests([](Slave& slave) {
         return slave.node().state() == canopen::NmtState::Stopped && type_of(slave) == 255;
       }),
       {"pdo.remote-request-state"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_pdo_transmission_slaves() {
  std::vector<WrongSlave> slaves = wrong_events();
  for (const auto more : {wrong_synchronous_tpdos, wrong_requests})
    for (WrongSlave& slave : more()) slaves.push_back(std::move(slave));
  return slaves;
}

}  // namespace zoo
