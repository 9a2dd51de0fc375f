#include <algorithm>

#include "tools/canopen-zoo/slave/sdo_defects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using Table = std::vector<canopen::EntryDescription>;
using enum canopen::DataType;

void replace(std::string& text, std::string_view old, std::string_view with) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos) throw std::invalid_argument{"not in the EDS: " + std::string{old}};
  text.replace(at, old.size(), with);
}

/// Puts @p entry where it belongs.
void insert(Table& table, const canopen::EntryDescription& entry) {
  const auto behind = std::ranges::find_if(table, [&](const canopen::EntryDescription& each) {
    return std::pair{each.index, each.sub_index} > std::pair{entry.index, entry.sub_index};
  });
  table.insert(behind, entry);
}

Defect with_entry(const canopen::EntryDescription& entry) {
  return {.table = [=](Table& table) { insert(table, entry); }};
}

}  // namespace

std::vector<WrongSlave> wrong_device_slaves() {
  return {
      {.name = "IsOfAnotherVendor",
       .what = "1018h:01 holds another vendor-ID than the EDS.",
       .defect = {.table = [](Table& table) { row(table, 0x1018, 1).initial = 0x99; }},
       .found_by = {"device.identity"}},
      {.name = "SharesItsNodeId",
       .what = "Each answer about 1000h comes twice, as if two slaves had the node-ID.",
       .defect = {.outgoing =
                      [](Slave& slave, canopen::Frame& frame) {
                        if (is_answer(slave, frame, 0x43, 0x1000)) slave.say(frame);
                        return true;
                      }},
       .found_by = {"device.alone"}},
      {.name = "HasAnUnprintableName",
       .what = "The device name in 1008h has a control character in it.",
       .defect = {.table = [](Table& table) { row(table, 0x1008).text = "Right\x01slave"; },
                  .eds = [](std::string& eds) { replace(eds, "DefaultValue=Right slave\n", ""); }},
       .found_by = {"device.names"}},
      {.name = "CountsItsSubIndicesWrongly",
       .what = "1018h:00 says 3 where the object has sub-indices up to 4.",
       .defect = {.table = [](Table& table) { row(table, 0x1018, 0).initial = 3; }},
       .found_by = {"device.sub-index-count"}},
      {.name = "HasAnotherConstant",
       .what = "1009h, a constant, holds another text than the EDS.",
       .defect = {.table = [](Table& table) { row(table, 0x1009).text = "2"; }},
       .found_by = {"device.constants"}},
      {.name = "HidesASubIndex",
       .what = "It has 1018h:05, of which its EDS knows nothing.",
       .defect = with_entry({.index = 0x1018, .sub_index = 5, .type = Unsigned32}),
       .found_by = {"device.other-sub-indices"}},
      {.name = "HidesAnObject",
       .what = "It has object 6000h, of which its EDS knows nothing.",
       .defect = with_entry({.index = 0x6000, .type = Unsigned32}),
       .found_by = {"device.other-objects"}},
      {.name = "TellsAnotherStructure",
       .what = "1018h:FF describes another structure than the object has.",
       .defect = with_entry({.index = 0x1018, .sub_index = 0xFF, .type = Unsigned32, .initial = 7}),
       .found_by = {"device.structure"}},
      {.name = "LacksAnObject",
       .what = "2004h is in its EDS but not in its dictionary.",
       .defect = {.table =
                      [](Table& table) {
                        std::erase_if(table, [](const auto& entry) { return entry.index == kText; });
                      }},
       .found_by = {"device.readable"}},
      {.name = "HasAnotherLength",
       .what = "2006h has four bytes where its EDS says eight.",
       .defect = {.table =
                      [](Table& table) {
                        row(table, kWide).type = Unsigned32;
                        row(table, kWide).initial = 1;
                      }},
       .found_by = {"device.length"}},
      {.name = "LiesOutsideItsLimits",
       .what = "2000h holds 0, and its EDS says that 1 is the least.",
       .defect = {.eds =
                      [](std::string& eds) {
                        replace(eds, "[2000]\nParameterName=Counter\n",
                                "[2000]\nParameterName=Counter\nLowLimit=1\nHighLimit=0xFFFFFFFF\n");
                      }},
       .found_by = {"device.limits"}},
      {.name = "RefusesItsOwnValue",
       .what = "It refuses to take for 2006h the value that it has just told.",
       .defect = answers(0x21, kWide, 0, kAbortCommand, 0x06090030),
       .found_by = {"device.write-back"}},
      {.name = "HasAnotherDefault",
       .what = "2006h starts with another value than the EDS says.",
       .defect = {.table = [](Table& table) { row(table, kWide).initial = 1; }},
       .found_by = {"device.defaults"}},
  };
}

}  // namespace zoo
