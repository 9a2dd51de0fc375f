#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tests/tools/canopen-check/slave/sdo_tricks.hpp"

namespace conformance_test {
namespace {

constexpr std::uint32_t kInvalid = 0x80000000, kNoRemote = 0x40000000, kDeviceState = 0x08000022;
constexpr std::uint16_t kTpdo = 0x1802;  ///< parameters of the TPDO that checks reconfigure
constexpr canopen::TypeRange kEveryType[]{{0, 255}};

bool valid(Slave& slave, std::uint16_t index) {
  return (held(slave, index, 1) & kInvalid) == 0;
}

/// True for a download to the COB-ID of a PDO.
bool cob_id(const Write& write) {
  const bool parameters = write.index >= 0x1400 && write.index < 0x1A00 && (write.index & 0x200U) == 0;
  return parameters && write.sub_index == 1;
}

bool restricted(std::uint32_t identifier) {
  return identifier == 0x6E0 || identifier == 0x77F;
}

Defect reserved_entry_that_exists() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    const bool asked = frame.id == 0x605 && frame.data[0] == 0x40 && frame.data[1] == 0x02 &&
                       frame.data[2] == 0x18 && frame.data[3] == 4;
    if (asked) slave.say({.id = 0x585, .length = 8, .data = {0x4F, 0x02, 0x18, 4}});
    return !asked;
  }};
}

Defect identifier_without_effect() {
  return {.outgoing = [](Slave&, canopen::Frame& frame) {
    if (frame.id == 0x6A2) frame.id = 0x385;
    return true;
  }};
}

Defect limit_in_the_eds() {
  return {.eds = [](std::string& eds) {
    const std::size_t section = eds.find("[1402sub1]");
    eds.insert(eds.find("PDOMapping", section), "LowLimit=0x1\nHighLimit=0x80000680\n");
  }};
}

std::vector<WrongSlave> wrong_identifiers() {
  return {
      {"HasTheReservedEntryOfATpdo", reserved_entry_that_exists(), {"pdo.reserved-entry"}},
      {"TakesAnotherIdentifierWhileValid",
       pretends_to_write([](Slave& slave, const Write& write) {
         return cob_id(write) && valid(slave, write.index) && (write.value & kInvalid) == 0 &&
                (write.value & 0x7FFU) == 0x6A1;
       }),
       {"pdo.identifier-lock"}},
      {"ForgetsAnotherIdentifier", forgets(kTpdo, 1, kInvalid | 0x6A1), {"pdo.identifier-change"}},
      {"SendsUnderItsFormerIdentifier", identifier_without_effect(), {"pdo.identifier-in-force"}},
      {"CutsIdentifiersOf29Bits",
       pretends_to_write(
           [](Slave&, const Write& write) { return cob_id(write) && (write.value & 0x20000000U) != 0; }),
       {"pdo.frame-bit"}},
      {"ForgetsTheRequestBit",
       writes_otherwise([](Slave&, const Write& write) -> std::optional<std::uint32_t> {
         if (!cob_id(write) || write.value != (kInvalid | kNoRemote | 0x385)) return std::nullopt;
         return kInvalid | 0x385;
       }),
       {"pdo.remote-request-bit"}},
      {"TakesRestrictedIdentifiersForPdos",
       pretends_to_write(
           [](Slave&, const Write& write) { return cob_id(write) && restricted(write.value & ~kNoRemote); }),
       {"pdo.restricted-identifiers"}},
      {"RefusesRestrictedIdentifiersWithAnotherCode",
       refuses_to_write(
           [](Slave&, const Write& write) { return cob_id(write) && restricted(write.value & ~kNoRemote); },
           0x06040043),
       {"pdo.restricted-identifiers"}},
      {"TakesCobIdsBeyondTheEds", limit_in_the_eds(), {"pdo.cob-id-limits"}},
      {"NeverMakesItsLastTpdoValid",
       refuses_to_write(
           [](Slave&, const Write& write) {
             return write.index == 0x1803 && write.sub_index == 1 && (write.value & kInvalid) == 0;
           },
           kDeviceState),
       {"pdo.all-valid"}},
  };
}

std::vector<WrongSlave> wrong_settings() {
  return {
      {"TakesReservedTypesOfRpdos",
       {.policy = [](canopen::Policy& policy) { policy.rpdo_types = kEveryType; }},
       {"pdo.transmission-types"}},
      {"TakesReservedTypesOfTpdos",
       {.policy = [](canopen::Policy& policy) { policy.tpdo_types = kEveryType; }},
       {"pdo.transmission-types"}},
      {"RefusesATypeWithAnotherCode",
       refuses_to_write(
           [](Slave&, const Write& write) {
             return write.index == kTpdo && write.sub_index == 2 && write.value == 240;
           },
           kDeviceState),
       {"pdo.transmission-types"}},
      {"ChangesTheInhibitTimeWhileValid",
       pretends_to_write([](Slave& slave, const Write& write) {
         return write.index == kTpdo && write.sub_index == 3 && valid(slave, kTpdo) &&
                write.value != held(slave, kTpdo, 3);
       }),
       {"pdo.inhibit-time-lock"}},
      {"KeepsItsInhibitTimeForEver",
       refuses_to_write(
           [](Slave&, const Write& write) {
             return write.index == kTpdo && write.sub_index == 3 && write.value == 0x40;
           },
           kDeviceState),
       {"pdo.inhibit-time-change"}},
      {"LocksItsPdosInOperational",
       {.policy = [](canopen::Policy& policy) { policy.pdo_changes_in_operational = false; }},
       {"pdo.parameters-in-operational", "pdo.mapping-in-operational"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_pdo_parameter_slaves() {
  std::vector<WrongSlave> slaves = wrong_identifiers();
  for (WrongSlave& slave : wrong_settings()) slaves.push_back(std::move(slave));
  return slaves;
}

}  // namespace conformance_test
