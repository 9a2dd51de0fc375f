#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::object_rules {

inline constexpr Rule kReadOnly{
    .id = "object.read-only",
    .text = "an object is written that can only be read",
    .clause = "CiA 301 7.4.2",
    .why =
        "The server aborts with 06010002h and nothing changes; the project of the master was made for another "
        "device or "
        "revision.",
    .mend = "Take the object out of the configuration, or make the project anew with the EDS of the device.",
    .example = R"((0.0000) can0 605#2300100092010200
(0.0010) can0 585#8000100002000106)"};

inline constexpr Rule kWriteOnly{
    .id = "object.write-only",
    .text = "an object is read that can only be written",
    .clause = "CiA 301 7.4.2",
    .why = "The server aborts with 06010001h; the value is kept nowhere but in the master.",
    .mend = "Do not read it back; look at what the write leads to.",
    .example = R"((0.0000) can0 605#40231F0100000000
(0.0010) can0 585#80231F0101000106)"};

inline constexpr Rule kMissing{.id = "object.missing",
                               .text = "an object is asked for that the device does not have",
                               .clause = "CiA 301 7.2.4.3.17",
                               .severity = Severity::Warning,
                               .why =
                                   "A master that looks what there is may do that; one that goes on as if it had "
                                   "been written leaves the device "
                                   "as it was.",
                               .mend = "Use the EDS of the device, and report aborts 06020000h and 06090011h.",
                               .example = R"((0.0000) can0 605#4004100000000000
(0.0010) can0 585#8004100000000206)"};

inline constexpr Rule kLength{.id = "object.length",
                              .text = "a value is written with the length of another type",
                              .clause = "CiA 301 7.2.4.3.3",
                              .why = "The server aborts with 06070010h, 06070012h or 06070013h.",
                              .mend = "Write as many bytes as the data type of the EDS has.",
                              .example = R"((0.0000) can0 605#23171000E8030000
(0.0010) can0 585#8017100010000706)"};

inline constexpr Rule kLimits{
    .id = "object.limits",
    .text = "a value is written that is beyond the limits of the object",
    .clause = "CiA 301 7.2.4.3.17",
    .why = "The server aborts with 06090030h, 06090031h or 06090032h, and the old value stays.",
    .mend = "Look at the limits in the EDS and at what the value depends on; scale in the master.",
    .example = R"((0.0000) can0 605#2F19100001000000
(0.0010) can0 585#8019100030000906)"};

inline constexpr Rule kState{
    .id = "object.state",
    .text = "an object is written while the device does not let it be changed",
    .clause = "CiA 301 7.2.4.3.17",
    .severity = Severity::Warning,
    .why = "The server aborts with 08000021h or 08000022h; that it works at another time hides the mistake.",
    .mend = "Configure in Pre-operational with the drive disabled, and look at each answer.",
    .example = R"((0.0000) can0 605#2F60600008000000
(0.0010) can0 585#8060600022000008)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kReadOnly, &kWriteOnly, &kMissing, &kLength, &kLimits, &kState};

}  // namespace audit::object_rules
