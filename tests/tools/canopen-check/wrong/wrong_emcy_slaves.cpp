#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/defects.hpp"

namespace conformance_test {
namespace {

using canopen::Frame;

constexpr std::uint16_t kErrorRegister = 0x1001, kHistory = 0x1003, kCobIdEmcy = 0x1014, kInhibitTime = 0x1015;

/// Shows other bits in the least byte of an answer.
void change(Frame& answer, std::uint8_t bits) {
  answer.data[4] = static_cast<std::uint8_t>(answer.data[4] ^ bits);
}

std::vector<WrongSlave> of_parameters() {
  return {
      {.name = "HasEmcyUnderAnotherIdentifierByDefault",
       .defect = {.table = [](auto& table) { row(table, kCobIdEmcy).initial = 0x90; },
                  .eds =
                      [](std::string& eds) {
                        const std::size_t section = eds.find("[1014]");
                        eds.replace(eds.find("$NODEID+0x80", section), 12, "$NODEID+0x90");
                      }},
       .found_by = {"emcy.cob-id-default"}},
      {.name = "ChangesTheIdentifierOfValidEmcy",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(frame, kCobIdEmcy) && value_of(frame) == 0x6C3 &&
                                           stored(slave, kCobIdEmcy) == kEmcyOf5;
                        if (wrong) confirm(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"emcy.cob-id-locked"}},
      {.name = "KeepsTheIdentifierOfEmcy",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (frame.id == 0x6C3) frame.id = kEmcyOf5;
                        return true;
                      }},
       .found_by = {"emcy.cob-id"}},
      {.name = "SendsEmcyThatIsInvalid",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool off = writes(frame, kCobIdEmcy) && value_of(frame) >> 31U != 0;
                        if (off) pretend(slave, frame);
                        return !off;
                      }},
       .found_by = {"emcy.disabled"}},
      {.name = "IgnoresTheInhibitTimeOfEmcy",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(frame, kInhibitTime);
                        if (wrong) {
                          frame.data[6] = frame.data[7] = 0;
                          pretend(slave, frame);
                        }
                        return !wrong;
                      }},
       .found_by = {"emcy.inhibit-time"}},
  };
}

std::vector<WrongSlave> of_messages() {
  return {
      {.name = "SendsEmcyOfSevenBytes",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (is_emergency(frame, 0x8130)) frame.length = 7;
                        return true;
                      }},
       .found_by = {"emcy.length"}},
      {.name = "SendsAnotherErrorCode",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (is_emergency(frame, 0x8130)) frame.data[0] = 0x00;
                        return true;
                      }},
       .found_by = {"emcy.code", "emcy.history-newest"}},
      {.name = "SendsAnotherErrorRegister",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (is_emergency(frame, 0x8130)) frame.data[2] |= 0x02U;
                        return true;
                      }},
       .found_by = {"emcy.register"}},
      {.name = "ShowsNoCommunicationError",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (is_emergency(frame, 0x8130)) frame.data[2] &= 0xEFU;
                        if (shows(frame, kErrorRegister)) frame.data[4] &= 0xEFU;
                        return true;
                      }},
       .found_by = {"emcy.register-bits"}},
      {.name = "DoesNotTellTheEndOfAnError",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == kEmcyOf5 && !is_emergency(frame, 0))
                          slave.memory["sync"] = is_emergency(frame, 0x8240) ? 1 : 0;
                        return !(is_emergency(frame, 0) && slave.memory["sync"] == 1);
                      }},
       .found_by = {"emcy.error-reset"}},
  };
}

std::vector<WrongSlave> of_history() {
  return {
      {.name = "HasTheNewestErrorElsewhere",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (shows(frame, kHistory, 1)) change(frame, 0x20);
                        return true;
                      }},
       .found_by = {"emcy.history-newest"}},
      {.name = "CountsMoreErrorsThanItHas",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        if (shows(frame, kHistory) && frame.data[4] != 0) ++frame.data[4];
                        return true;
                      }},
       .found_by = {"emcy.history-count"}},
      {.name = "ShowsEmptyEntriesAs0",
       .defect = {.outgoing =
                      [](Slave&, Frame& frame) {
                        constexpr std::uint32_t kNoData = 0x08000024;
                        const bool empty = frame.id == kResponseOf5 && frame.data[0] == 0x80 &&
                                           frame.data[1] == 0x03 && frame.data[2] == 0x10 &&
                                           value_of(frame) == kNoData;
                        if (empty) frame.data = {0x43, 0x03, 0x10, frame.data[3]};
                        return true;
                      }},
       .found_by = {"emcy.history-empty-entry"}},
      {.name = "DoesNotDeleteItsHistory",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(frame, kHistory) && frame.data[4] == 0;
                        if (wrong) confirm(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"emcy.history-deleted"}},
      {.name = "TakesOtherValuesForItsHistory",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(frame, kHistory) && frame.data[4] != 0;
                        if (wrong) confirm(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"emcy.history-other-values"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_emcy_slaves() {
  std::vector<WrongSlave> all = of_parameters();
  for (auto more : {of_messages(), of_history()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace conformance_test
