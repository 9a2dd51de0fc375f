#include "tools/canopen-zoo/slave/sdo_tricks.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

using canopen::Frame;

constexpr std::uint16_t kTpdo = 0x1A02;  ///< mapping of the TPDO that checks reconfigure
constexpr std::uint32_t kFrames = 0x380;

bool mapping(std::uint16_t index) {
  return (index >= 0x1600 && index < 0x1800) || (index >= 0x1A00 && index < 0x1C00);
}

/// True for a download of a mapping entry.
bool maps(const Write& write) {
  return mapping(write.index) && write.sub_index != 0;
}

Defect forgets_entries_of(std::uint16_t first, std::uint16_t last) {
  return pretends_to_write([=](Slave&, const Write& write) {
    return maps(write) && write.value >> 16U >= first && write.value >> 16U <= last;
  });
}

Defect takes_any_length() {
  return writes_otherwise([](Slave& slave, const Write& write) -> std::optional<std::uint32_t> {
    if (!maps(write) || write.value >> 16U < 0x2000) return std::nullopt;
    const auto entry = slave.dictionary().find(static_cast<std::uint16_t>(write.value >> 16U), 0);
    if (!entry) return std::nullopt;
    return (write.value & 0xFFFFFF00U) | 8U * (*entry)->size;
  });
}

/// Counts one entry behind a refused one, until the count is written again.
Defect counts_refused_entries() {
  return {.incoming =
              [](Slave& slave, Frame& frame) {
                if (const auto write = write_in(slave, frame);
                    write && write->index == kTpdo && write->sub_index == 0)
                  slave.memory["refused"] = 0;
                return true;
              },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                if (frame.id != slave.cob_id(kSdoResponse) || frame.data[1] != 0x02 || frame.data[2] != 0x1A)
                  return true;
                if (frame.data[0] == 0x80) slave.memory["refused"] = 1;
                if (frame.data[0] == 0x4F && frame.data[3] == 0 && slave.memory["refused"] != 0) frame.data[4] = 1;
                return true;
              },
          .after_reset = [](Slave& slave) { slave.memory["refused"] = 0; }};
}

Defect sends_other_values() {
  return {.outgoing = [](Slave& slave, Frame& frame) {
    if (frame.id == slave.cob_id(kFrames) && held(slave, 0x1802, 2) == 1) frame.data[0] ^= 1U;
    return true;
  }};
}

Defect keeps_its_length() {
  return {.outgoing = [](Slave& slave, Frame& frame) {
    if (frame.id == slave.cob_id(kFrames) && held(slave, 0x1802, 2) == 1 && held(slave, kTpdo, 1) != 0x20000020)
      --frame.length;
    return true;
  }};
}

std::vector<WrongSlave> wrong_refusals() {
  return {
      {"MapsObjectsThatDoNotExist",
       "It confirms a mapping of 1004h, which does not exist.",
       forgets_entries_of(0x1004, 0x1004),
       {"pdo.mapping-missing-object"}},
      {"MapsObjectsThatAreNotMappable",
       "It confirms a mapping of 1003h, which is not mappable.",
       forgets_entries_of(0x1003, 0x1003),
       {"pdo.mapping-unmappable"}},
      {"HasAnotherCodeForWhatIsNotMappable",
       "It refuses a mapping of 1003h with 06090030h.",
       refuses_to_write([](Slave&, const Write& write) { return maps(write) && write.value >> 16U == 0x1003; },
                        0x06090030),
       {"pdo.mapping-unmappable"}},
      {"MapsWhatGoesTheOtherWay",
       "It confirms 1001h in an RPDO and 2001h in a TPDO, which go the other way only.",
       pretends_to_write([](Slave&, const Write& write) {
         return (write.index == 0x1602 && maps(write) && write.value >> 16U == 0x1001) ||
                (write.index == kTpdo && maps(write) && write.value >> 16U == kStep);
       }),
       {"pdo.mapping-direction"}},
      {"MapsAnyLength",
       "It takes any length for a mapped object, and maps its whole.",
       takes_any_length(),
       {"pdo.mapping-bits"}},
      {"MapsMoreThan64Bits",
       "It confirms three mapped objects for TPDO 3 though they have more than 64 bits.",
       forgets(kTpdo, 0, 3),
       {"pdo.mapping-length"}},
      {"CountsMoreEntriesThanItHas",
       "It confirms nine mapped objects for TPDO 3, which has room for eight.",
       forgets(kTpdo, 0, 9),
       {"pdo.mapping-count"}},
      {"CountsRefusedEntries",
       "1A02h:00 says 1 behind a mapping that was refused.",
       counts_refused_entries(),
       {"pdo.mapping-refused"}},
      {"ChangesTheMappingOfAValidPdo",
       "It confirms another number of mapped objects while TPDO 3 is valid, and forgets it.",
       pretends_to_write([](Slave& slave, const Write& write) {
         return write.index == kTpdo && write.sub_index == 0 && (held(slave, 0x1802, 1) & 0x80000000U) == 0;
       }),
       {"pdo.mapping-valid-lock"}},
      {"MapsBehindAnyCount",
       "It takes mappings without the number of mapped objects being 0 before.",
       {.policy = [](canopen::Policy& policy) { policy.count_follows_entries = true; }},
       {"pdo.mapping-entry-lock"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_pdo_mapping_slaves() {
  std::vector<WrongSlave> slaves = wrong_refusals();
  slaves.insert(slaves.end(),
                {{"HasNoDummies",
                  "It refuses to map data types as dummies, which its EDS allows.",
                  {.policy = [](canopen::Policy& policy) { policy.dummy_types = 0; }},
                  {"pdo.mapping-dummy"}},
                 {"HasDummiesThatItsEdsForbids",
                  "It maps dummies of type 0006h, which its EDS forbids.",
                  {.eds = [](std::string& eds) { eds.replace(eds.find("Dummy0006=1"), 11, "Dummy0006=0"); }},
                  {"pdo.mapping-dummy"}},
                 {"MapsWhatItsEdsDoesNotAllow",
                  "It maps 2007h, which its EDS calls not mappable.",
                  {.eds =
                       [](std::string& eds) {
                         eds.replace(eds.find("PDOMapping=1", eds.find("[2007]")), 12, "PDOMapping=0");
                       }},
                  {"pdo.mapping-objects"}},
                 {"SendsOtherValues",
                  "A bit of TPDO 3 differs from the object that it maps.",
                  sends_other_values(),
                  {"pdo.content", "pdo.new-mapping"}},
                 {"CutsANewMapping",
                  "TPDO 3 is one byte short after its mapping was changed.",
                  keeps_its_length(),
                  {"pdo.new-mapping"}}});
  return slaves;
}

}  // namespace zoo
