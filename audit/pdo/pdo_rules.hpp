#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::pdo_rules {

// Examples begin with what makes the state of the PDO known: its COB-ID, its mapping.

inline constexpr Rule kMappingWhileValid{
    .id = "pdo.mapping-while-valid",
    .text = "the mapping of a PDO is written while the PDO is in use",
    .clause = "CiA 301 7.5.2.36",
    .why = "The device refuses it, or sends and takes frames of a mapping that is half the old one.",
    .mend =
        "Set bit 31 of the COB-ID, write 0 to the count of the mapping, then the entries, the count, and the "
        "COB-ID.",
    .example = R"((0.0000) can0 605#4000140100000000
(0.0010) can0 585#4300140105020000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#8000160022000008)"};

inline constexpr Rule kMappingCounted{
    .id = "pdo.mapping-counted",
    .text = "an entry of a mapping is written while the count is not 0",
    .clause = "CiA 301 7.5.2.36",
    .why = "The entry takes part in the mapping already: the device refuses it.",
    .mend = "Write 0 to sub-index 0 first, and the number of entries when they are all written.",
    .example = R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#4000160000000000
(0.0030) can0 585#4F00160001000000
(0.0040) can0 605#2300160110004060
(0.0050) can0 585#8000160100000106)"};

inline constexpr Rule kMappingBeyond{.id = "pdo.mapping-beyond",
                                     .text = "the count of a mapping is beyond the entries that were written",
                                     .clause = "CiA 301 7.5.2.36",
                                     .why =
                                         "The last entries are empty or old ones: the device refuses the count, "
                                         "or the PDO has other objects than meant.",
                                     .mend = "Write as many entries as the count says, from sub-index 1 on.",
                                     .example = R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#2300160110004060
(0.0050) can0 585#6000160100000000
(0.0060) can0 605#2300160200000000
(0.0070) can0 585#6000160200000000
(0.0080) can0 605#2F00160002000000
(0.0090) can0 585#8000160042000406)"};

inline constexpr Rule kMappingLong{
    .id = "pdo.mapping-long",
    .text = "more than 64 bits are mapped into a PDO",
    .clause = "CiA 301 7.5.2.36",
    .why = "A frame has eight bytes: the device aborts the count with 06040042h, and the mapping is empty.",
    .mend = "Spread the objects over several PDOs.",
    .example = R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#230016012000FF60
(0.0050) can0 585#6000160100000000
(0.0060) can0 605#2300160220007A60
(0.0070) can0 585#6000160200000000
(0.0080) can0 605#2300160310004060
(0.0090) can0 585#6000160300000000
(0.0100) can0 605#2F00160003000000
(0.0110) can0 585#8000160042000406)"};

inline constexpr Rule kNotMappable{
    .id = "pdo.not-mappable",
    .text = "an object is mapped that cannot be",
    .clause = "CiA 301 7.5.2.36",
    .why = "The device aborts with 06040041h; the entry is not written, and the count refused later.",
    .mend = "Map objects whose EDS entry has PDOMapping=1 and the right direction, with their own length.",
    .example = R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#2300160120000010
(0.0050) can0 585#8000160141000406)"};

inline constexpr Rule kCobIdWhileValid{
    .id = "pdo.cob-id-while-valid",
    .text = "the identifier of a PDO is changed while the PDO is in use",
    .clause = "CiA 301 7.5.2.35",
    .why =
        "Bits 0 to 29 are not to be changed while bit 31 is clear: the device refuses it or takes frames of both.",
    .mend = "Write the COB-ID with bit 31 set first, then the new one.",
    .example = R"((0.0000) can0 605#4000140100000000
(0.0010) can0 585#4300140105020000
(0.0020) can0 605#2300140106030000
(0.0030) can0 585#8000140130000906)"};

inline constexpr Rule kRestricted{.id = "pdo.restricted",
                                  .text = "a PDO gets an identifier that is restricted",
                                  .clause = "CiA 301 7.3.5",
                                  .why =
                                      "The identifier belongs to NMT, SDO or error control; the device aborts "
                                      "with 06090030h, or two services meet.",
                                  .mend = "Take one that the list of restricted identifiers does not have.",
                                  .example = R"((0.0000) can0 605#2300180105070040
(0.0010) can0 585#8000180130000906)"};

inline constexpr Rule kReservedType{
    .id = "pdo.reserved-type",
    .text = "a PDO gets a transmission type that is reserved",
    .clause = "CiA 301 7.5.2.35",
    .why = "241 to 251 mean nothing, 252 and 253 nothing for RPDOs: the device aborts with 06090030h.",
    .mend = "0 to 240 for PDOs that go with SYNC, 254 or 255 for those that go with events.",
    .example = R"((0.0000) can0 605#2F001802F5000000
(0.0010) can0 585#8000180230000906)"};

inline constexpr Rule kInhibitWhileValid{.id = "pdo.inhibit-while-valid",
                                         .text = "the inhibit time of a PDO is changed while the PDO is in use",
                                         .clause = "CiA 301 7.5.2.37",
                                         .why = "The device refuses it.",
                                         .mend = "Set bit 31 of the COB-ID before, and clear it after.",
                                         .example = R"((0.0000) can0 605#4000180100000000
(0.0010) can0 585#4300180185010040
(0.0020) can0 605#2B00180364000000
(0.0030) can0 585#8000180322000008)"};

inline constexpr Rule kInOperational{
    .id = "pdo.set-in-operational",
    .text = "a PDO is configured while the node is Operational",
    .clause = "CiA 301 7.3.2.2.2",
    .severity = Severity::Warning,
    .why = "Process data goes on meanwhile: for some milliseconds a drive has the set-points of before, or none.",
    .mend = "Configure in Pre-operational, then start the node.",
    .example = R"((0.0000) can0 705#05
(0.0010) can0 605#2300140105020080
(0.0020) can0 585#6000140100000000)"};

inline constexpr Rule kLeftInvalid{
    .id = "pdo.left-invalid",
    .text = "a node is started with a PDO that was configured and not put into use",
    .clause = "CiA 301 7.5.2.35",
    .severity = Severity::Warning,
    .why = "Bit 31 of its COB-ID is still set: nothing of what was mapped is sent or received.",
    .mend = "Write the COB-ID without bit 31 as the last step.",
    .example = R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#2300160110004060
(0.0050) can0 585#6000160100000000
(0.0060) can0 605#2F00160001000000
(0.0070) can0 585#6000160000000000
(0.0080) can0 000#0105)"};

inline constexpr Rule kRefused{
    .id = "pdo.refused-in-use",
    .text = "a PDO is put into use though a step of its mapping was refused",
    .clause = "CiA 301 7.2.4.3.17",
    .why =
        "Its mapping is empty, the old one, or a part: process data stands where the master does not look for it.",
    .mend = "Look at each answer; after an abort leave the PDO invalid, and say which object was refused.",
    .example = R"((0.0000) can0 605#2300140105020080
(0.0010) can0 585#6000140100000000
(0.0020) can0 605#2F00160000000000
(0.0030) can0 585#6000160000000000
(0.0040) can0 605#2300160110004060
(0.0050) can0 585#8000160120000008
(0.0060) can0 605#2300140105020000
(0.0070) can0 585#6000140100000000)"};

inline constexpr Rule kShort{.id = "pdo.short",
                             .text = "an RPDO is shorter than its mapping",
                             .clause = "CiA 301 7.2.2.5.2",
                             .why = "The node takes nothing of it, and sends EMCY 8210h.",
                             .mend = "Send as many bytes as are mapped.",
                             .example = R"((0.0000) can0 705#05
(0.0010) can0 605#4000160000000000
(0.0020) can0 585#4F00160001000000
(0.0030) can0 605#4000160100000000
(0.0040) can0 585#4300160110004060
(0.0050) can0 205#06)"};

inline constexpr Rule kLong{.id = "pdo.long",
                            .text = "an RPDO is longer than its mapping",
                            .clause = "CiA 301 7.2.2.5.2",
                            .severity = Severity::Warning,
                            .why = "What is beyond the mapping goes nowhere; some devices send EMCY 8220h.",
                            .mend = "Send as many bytes as are mapped, or map what the others are for.",
                            .example = R"((0.0000) can0 705#05
(0.0010) can0 605#4000160000000000
(0.0020) can0 585#4F00160001000000
(0.0030) can0 605#4000160100000000
(0.0040) can0 585#4300160110004060
(0.0050) can0 205#0600000000000000)"};

inline constexpr Rule kBeforeOperational{
    .id = "pdo.before-operational",
    .text = "an RPDO is sent to a node that is not Operational",
    .clause = "CiA 301 7.3.2.2.2",
    .why = "The node does not take it: the set-points of the master are not those of the drive.",
    .mend = "Start the node, and see it Operational, before the first RPDO.",
    .example = R"((0.0000) can0 705#7F
(0.0010) can0 205#0600)"};

inline constexpr Rule kRemote{.id = "pdo.remote",
                              .text = "a TPDO is asked for by a remote frame, which it does not allow",
                              .clause = "CiA 301 7.5.2.37",
                              .why = "Bit 30 of its COB-ID says that nothing is answered.",
                              .mend = "Use SYNC or an event time; CiA recommends no remote frames.",
                              .example = R"((0.0000) can0 605#4000180100000000
(0.0010) can0 585#4300180185010040
(0.0020) can0 185#R)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kMappingWhileValid,
                                 &kMappingCounted,
                                 &kMappingBeyond,
                                 &kMappingLong,
                                 &kNotMappable,
                                 &kCobIdWhileValid,
                                 &kRestricted,
                                 &kReservedType,
                                 &kInhibitWhileValid,
                                 &kInOperational,
                                 &kLeftInvalid,
                                 &kRefused,
                                 &kShort,
                                 &kLong,
                                 &kBeforeOperational,
                                 &kRemote};

}  // namespace audit::pdo_rules
