#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
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
       .what = "1014h is 90h + node-ID by default, not 80h + node-ID.",
       .defect = {.table = [](auto& table) { row(table, kCobIdEmcy).initial = 0x90; },
                  .eds =
                      [](std::string& eds) {
                        const std::size_t section = eds.find("[1014]");
                        eds.replace(eds.find("$NODEID+0x80", section), 12, "$NODEID+0x90");
                      }},
       .found_by = {"emcy.cob-id-default"}},
      {.name = "ChangesTheIdentifierOfValidEmcy",
       .what = "It confirms 6C3h in 1014h while EMCY is valid, and forgets it.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(slave, frame, kCobIdEmcy) && value_of(frame) == 0x6C3 &&
                                           stored(slave, kCobIdEmcy) == slave.cob_id(kEmcy);
                        if (wrong) confirm(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"emcy.cob-id-locked"}},
      {.name = "KeepsTheIdentifierOfEmcy",
       .what = "It goes on to send EMCY under 80h + node-ID whatever 1014h says.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == (stored(slave, kCobIdEmcy) & canopen::cob_id::kBase))
                          frame.id = slave.cob_id(kEmcy);
                        return true;
                      }},
       .found_by = {"emcy.cob-id"}},
      {.name = "SendsEmcyThatIsInvalid",
       .what = "It sends EMCY though bit 31 of 1014h is set.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool off = writes(slave, frame, kCobIdEmcy) && value_of(frame) >> 31U != 0;
                        if (off) pretend(slave, frame);
                        return !off;
                      }},
       .found_by = {"emcy.disabled"}},
      {.name = "IgnoresTheInhibitTimeOfEmcy",
       .what = "The inhibit time in 1015h stays 0.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(slave, frame, kInhibitTime);
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
       .what = "Its EMCY 8130h has seven bytes.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_emergency(slave, frame, 0x8130)) frame.length = 7;
                        return true;
                      }},
       .found_by = {"emcy.length"}},
      {.name = "SendsAnotherErrorCode",
       .what = "It sends EMCY 8100h where 8130h is stated.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_emergency(slave, frame, 0x8130)) frame.data[0] = 0x00;
                        return true;
                      }},
       .found_by = {"emcy.code", "emcy.history-newest"}},
      {.name = "SendsAnotherErrorRegister",
       .what = "The error register in its EMCY 8130h differs from 1001h.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_emergency(slave, frame, 0x8130)) frame.data[2] |= 0x02U;
                        return true;
                      }},
       .found_by = {"emcy.register"}},
      {.name = "ShowsNoCommunicationError",
       .what = "The bit of communication errors stays 0 in its error register.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (is_emergency(slave, frame, 0x8130)) frame.data[2] &= 0xEFU;
                        if (shows(slave, frame, kErrorRegister)) frame.data[4] &= 0xEFU;
                        return true;
                      }},
       .found_by = {"emcy.register-bits"}},
      {.name = "DoesNotTellTheEndOfAnError",
       .what = "It sends no EMCY 0000h after an error of SYNC has ended.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (frame.id == slave.cob_id(kEmcy) && !is_emergency(slave, frame, 0))
                          slave.memory["sync"] = is_emergency(slave, frame, 0x8240) ? 1 : 0;
                        return !(is_emergency(slave, frame, 0) && slave.memory["sync"] == 1);
                      }},
       .found_by = {"emcy.error-reset"}},
  };
}

std::vector<WrongSlave> of_history() {
  return {
      {.name = "HasTheNewestErrorElsewhere",
       .what = "1003h:01 is not the error that was told last.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (shows(slave, frame, kHistory, 1)) change(frame, 0x20);
                        return true;
                      }},
       .found_by = {"emcy.history-newest"}},
      {.name = "CountsMoreErrorsThanItHas",
       .what = "1003h:00 is one too high.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        if (shows(slave, frame, kHistory) && frame.data[4] != 0) ++frame.data[4];
                        return true;
                      }},
       .found_by = {"emcy.history-count"}},
      {.name = "ShowsEmptyEntriesAs0",
       .what = "Empty entries of 1003h read as 0 instead of an abort.",
       .defect = {.outgoing =
                      [](Slave& slave, Frame& frame) {
                        constexpr std::uint32_t kNoData = 0x08000024;
                        const bool empty = frame.id == slave.cob_id(kSdoResponse) && frame.data[0] == 0x80 &&
                                           frame.data[1] == 0x03 && frame.data[2] == 0x10 &&
                                           value_of(frame) == kNoData;
                        if (empty) frame.data = {0x43, 0x03, 0x10, frame.data[3]};
                        return true;
                      }},
       .found_by = {"emcy.history-empty-entry"}},
      {.name = "DoesNotDeleteItsHistory",
       .what = "It confirms 0 for 1003h:00 and deletes nothing.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(slave, frame, kHistory) && frame.data[4] == 0;
                        if (wrong) confirm(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"emcy.history-deleted"}},
      {.name = "TakesOtherValuesForItsHistory",
       .what = "It confirms values other than 0 for 1003h:00.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(slave, frame, kHistory) && frame.data[4] != 0;
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

}  // namespace zoo
