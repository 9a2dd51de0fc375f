#include "tools/canopen-zoo/slave/defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;

constexpr std::uint16_t kCobIdSync = 0x1005, kCyclePeriod = 0x1006, kCobIdTime = 0x1012, kOverflow = 0x1019;
constexpr std::uint32_t kInvalidValue = 0x06090030;

/// Answers a write of one byte to 1019h by itself.
bool is_overflow(const Slave& slave, const Frame& frame, std::uint8_t value) {
  return writes(slave, frame, kOverflow) && frame.data[4] == value;
}

std::vector<WrongSlave> of_counter() {
  return {
      {.name = "TakesSyncCounterOf1",
       .what = "It confirms 1 for 1019h, which is reserved.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (is_overflow(slave, frame, 1)) confirm(slave, frame);
                        return !is_overflow(slave, frame, 1);
                      }},
       .found_by = {"sync.counter-refuses"}},
      {.name = "RefusesSyncCounterOf240",
       .what = "It refuses 240 for 1019h, which is allowed.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (is_overflow(slave, frame, 240)) refuse(slave, frame, kInvalidValue);
                        return !is_overflow(slave, frame, 240);
                      }},
       .found_by = {"sync.counter-takes"}},
      {.name = "ChangesItsSyncCounterWhileThereIsAPeriod",
       .what = "It takes values for 1019h while 1006h is not 0.",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(slave, frame, kOverflow) && stored(slave, kCyclePeriod) != 0;
                        if (wrong) pretend(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"sync.counter-locked"}},
      {.name = "DoesNotTellASyncOfUnexpectedLength",
       .what = "It sends no EMCY 8240h for a SYNC of unexpected length.",
       .defect = {.outgoing = [](Slave& slave, Frame& frame) { return !is_emergency(slave, frame, 0x8240); }},
       .found_by = {"sync.unexpected-length"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_sync_slaves() {
  std::vector<WrongSlave> all = of_counter();
  all.insert(all.end(),
             {{.name = "HasSyncUnder81ByDefault",
               .what = "1005h is 81h by default, not 80h.",
               .defect = {.table = [](auto& table) { row(table, kCobIdSync).initial = 0x81; },
                          .eds =
                              [](std::string& eds) {
                                const std::size_t section = eds.find("[1005]");
                                eds.replace(eds.find("DefaultValue=0x80", section), 17, "DefaultValue=0x81");
                              }},
               .found_by = {"sync.cob-id-default"}},
              {.name = "KeepsSyncUnder80",
               .what = "It goes on to hear SYNC under 80h whatever 1005h says.",
               .defect = {.incoming =
                              [](Slave& slave, Frame& frame) {
                                const auto set =
                                    static_cast<std::uint32_t>(stored(slave, kCobIdSync)) & canopen::cob_id::kBase;
                                if (frame.id == kSync)
                                  frame.id = set;
                                else if (frame.id == set)
                                  return false;
                                return true;
                              }},
               .found_by = {"sync.cob-id"}},
              {.name = "ChangesTheIdentifierOfTimeWhileItConsumesIt",
               .what = "It confirms 6C2h in 1012h while it consumes TIME, and forgets it.",
               .defect = {.incoming =
                              [](Slave& slave, Frame& frame) {
                                const bool wrong =
                                    writes(slave, frame, kCobIdTime) && value_of(frame) == 0x800006C2;
                                if (wrong) confirm(slave, frame);
                                return !wrong;
                              }},
               .found_by = {"sync.time-cob-id-locked"}},
              {.name = "StopsWithAShortTimeStamp",
               .what = "A TIME of five bytes stops it.",
               .defect = {.incoming =
                              [](Slave& slave, Frame& frame) {
                                if (frame.id == 0x100 && frame.length == 5)
                                  slave.node().command(canopen::NmtCommand::Stop, slave.now());
                                return true;
                              }},
               .found_by = {"sync.time-lengths"}}});
  return all;
}

}  // namespace zoo
