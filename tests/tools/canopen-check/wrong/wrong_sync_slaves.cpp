#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/defects.hpp"

namespace conformance_test {
namespace {

using canopen::Frame;

constexpr std::uint16_t kCobIdSync = 0x1005, kCyclePeriod = 0x1006, kCobIdTime = 0x1012, kOverflow = 0x1019;
constexpr std::uint32_t kInvalidValue = 0x06090030;

/// Answers a write of one byte to 1019h by itself.
bool is_overflow(const Frame& frame, std::uint8_t value) {
  return writes(frame, kOverflow) && frame.data[4] == value;
}

std::vector<WrongSlave> of_counter() {
  return {
      {.name = "TakesSyncCounterOf1",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (is_overflow(frame, 1)) confirm(slave, frame);
                        return !is_overflow(frame, 1);
                      }},
       .found_by = {"sync.counter-refuses"}},
      {.name = "RefusesSyncCounterOf240",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        if (is_overflow(frame, 240)) refuse(slave, frame, kInvalidValue);
                        return !is_overflow(frame, 240);
                      }},
       .found_by = {"sync.counter-takes"}},
      {.name = "ChangesItsSyncCounterWhileThereIsAPeriod",
       .defect = {.incoming =
                      [](Slave& slave, Frame& frame) {
                        const bool wrong = writes(frame, kOverflow) && stored(slave, kCyclePeriod) != 0;
                        if (wrong) pretend(slave, frame);
                        return !wrong;
                      }},
       .found_by = {"sync.counter-locked"}},
      {.name = "DoesNotTellASyncOfUnexpectedLength",
       .defect = {.outgoing = [](Slave&, Frame& frame) { return !is_emergency(frame, 0x8240); }},
       .found_by = {"sync.unexpected-length"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_sync_slaves() {
  std::vector<WrongSlave> all = of_counter();
  all.insert(all.end(),
             {{.name = "HasSyncUnder81ByDefault",
               .defect = {.table = [](auto& table) { row(table, kCobIdSync).initial = 0x81; },
                          .eds =
                              [](std::string& eds) {
                                const std::size_t section = eds.find("[1005]");
                                eds.replace(eds.find("DefaultValue=0x80", section), 17, "DefaultValue=0x81");
                              }},
               .found_by = {"sync.cob-id-default"}},
              {.name = "KeepsSyncUnder80",
               .defect = {.incoming =
                              [](Slave& slave, Frame& frame) {
                                if (frame.id == 0x6C1) return false;
                                if (frame.id == 0x80)
                                  frame.id = static_cast<std::uint32_t>(stored(slave, kCobIdSync));
                                return true;
                              }},
               .found_by = {"sync.cob-id"}},
              {.name = "ChangesTheIdentifierOfTimeWhileItConsumesIt",
               .defect = {.incoming =
                              [](Slave& slave, Frame& frame) {
                                const bool wrong = writes(frame, kCobIdTime) && value_of(frame) == 0x800006C2;
                                if (wrong) confirm(slave, frame);
                                return !wrong;
                              }},
               .found_by = {"sync.time-cob-id-locked"}},
              {.name = "StopsWithAShortTimeStamp",
               .defect = {.incoming =
                              [](Slave& slave, Frame& frame) {
                                if (frame.id == 0x100 && frame.length == 5)
                                  slave.node().command(canopen::NmtCommand::Stop, slave.now());
                                return true;
                              }},
               .found_by = {"sync.time-lengths"}}});
  return all;
}

}  // namespace conformance_test
