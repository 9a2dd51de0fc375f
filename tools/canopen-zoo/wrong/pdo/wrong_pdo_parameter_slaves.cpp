#include "tools/canopen-zoo/slave/sdo_tricks.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
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

/// The identifier of the PDO whose parameters are at @p index.
std::uint32_t identifier_of(Slave& slave, std::uint16_t index) {
  return held(slave, index, 1) & canopen::cob_id::kBase;
}

Defect reserved_entry_that_exists() {
  return {.incoming = [](Slave& slave, canopen::Frame& frame) {
    const bool asked = frame.id == slave.cob_id(kSdoRequest) && frame.data[0] == 0x40 && frame.data[1] == 0x02 &&
                       frame.data[2] == 0x18 && frame.data[3] == 4;
    if (asked) slave.say({.id = slave.cob_id(kSdoResponse), .length = 8, .data = {0x4F, 0x02, 0x18, 4}});
    return !asked;
  }};
}

Defect identifier_without_effect() {
  return {.outgoing = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id == identifier_of(slave, kTpdo)) frame.id = slave.cob_id(0x380);
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
      {"HasTheReservedEntryOfATpdo",
       "1802h:04, which is reserved, can be read.",
       reserved_entry_that_exists(),
       {"pdo.reserved-entry"}},
      {"TakesAnotherIdentifierWhileValid",
       "It confirms another identifier for a PDO that is valid, and forgets it.",
       pretends_to_write([](Slave& slave, const Write& write) {
         return cob_id(write) && valid(slave, write.index) && (write.value & kInvalid) == 0 &&
                canopen::is_assignable(write.value & ~kNoRemote, false) &&
                (write.value & canopen::cob_id::kBase) != identifier_of(slave, write.index);
       }),
       {"pdo.identifier-lock"}},
      {"ForgetsAnotherIdentifier",
       "It confirms 6A1h as the identifier of TPDO 3 while that is invalid, and forgets it.",
       forgets(kTpdo, 1, kInvalid | 0x6A1),
       {"pdo.identifier-change"}},
      {"SendsUnderItsFormerIdentifier",
       "It sends TPDO 3 under its former identifier after a change.",
       identifier_without_effect(),
       {"pdo.identifier-in-force"}},
      {"CutsIdentifiersOf29Bits",
       "It confirms identifiers of 29 bits for PDOs, which it cannot use, and forgets them.",
       pretends_to_write(
           [](Slave&, const Write& write) { return cob_id(write) && (write.value & 0x20000000U) != 0; }),
       {"pdo.frame-bit"}},
      {"ForgetsTheRequestBit",
       "Bit 30 of the COB-ID of TPDO 3 is lost when it is written.",
       writes_otherwise([](Slave& slave, const Write& write) -> std::optional<std::uint32_t> {
         if (!cob_id(write) || write.value != (kInvalid | kNoRemote | slave.cob_id(0x380))) return std::nullopt;
         return kInvalid | slave.cob_id(0x380);
       }),
       {"pdo.remote-request-bit"}},
      {"TakesRestrictedIdentifiersForPdos",
       "It confirms restricted identifiers for PDOs, and forgets them.",
       pretends_to_write([](Slave&, const Write& write) {
         return cob_id(write) && canopen::is_restricted(write.value & ~kNoRemote);
       }),
       {"pdo.restricted-identifiers"}},
      {"RefusesRestrictedIdentifiersWithAnotherCode",
       "It refuses restricted identifiers for PDOs with 06040043h.",
       refuses_to_write(
           [](Slave&, const Write& write) {
             return cob_id(write) && canopen::is_restricted(write.value & ~kNoRemote);
           },
           0x06040043),
       {"pdo.restricted-identifiers"}},
      {"TakesCobIdsBeyondTheEds",
       "It takes a COB-ID for RPDO 3 that is beyond the limits of its EDS.",
       limit_in_the_eds(),
       {"pdo.cob-id-limits"}},
      {"NeverMakesItsLastTpdoValid",
       "It refuses to make TPDO 4 valid.",
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
       "It takes reserved transmission types for RPDOs.",
       {.policy = [](canopen::Policy& policy) { policy.rpdo_types = kEveryType; }},
       {"pdo.transmission-types"}},
      {"TakesReservedTypesOfTpdos",
       "It takes reserved transmission types for TPDOs.",
       {.policy = [](canopen::Policy& policy) { policy.tpdo_types = kEveryType; }},
       {"pdo.transmission-types"}},
      {"RefusesATypeWithAnotherCode",
       "It refuses transmission type 240 of TPDO 3 with 08000022h.",
       refuses_to_write(
           [](Slave&, const Write& write) {
             return write.index == kTpdo && write.sub_index == 2 && write.value == 240;
           },
           kDeviceState),
       {"pdo.transmission-types"}},
      {"ChangesTheInhibitTimeWhileValid",
       "It confirms another inhibit time while TPDO 3 is valid, and forgets it.",
       pretends_to_write([](Slave& slave, const Write& write) {
         return write.index == kTpdo && write.sub_index == 3 && valid(slave, kTpdo) &&
                write.value != held(slave, kTpdo, 3);
       }),
       {"pdo.inhibit-time-lock"}},
      {"KeepsItsInhibitTimeForEver",
       "It refuses an inhibit time of 64 for TPDO 3 even while that is invalid.",
       refuses_to_write(
           [](Slave&, const Write& write) {
             return write.index == kTpdo && write.sub_index == 3 && write.value == 0x40;
           },
           kDeviceState),
       {"pdo.inhibit-time-change"}},
      {"LocksItsPdosInOperational",
       "It refuses changes of PDO parameters and mappings in Operational.",
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

}  // namespace zoo
