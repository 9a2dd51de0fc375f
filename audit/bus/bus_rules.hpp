#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::bus_rules {

inline constexpr Rule kIdentifierTwice{.id = "bus.identifier-twice",
                                       .text = "a service gets an identifier on which another node sends already",
                                       .clause = "CiA 301 7.3.5",
                                       .why =
                                           "Two nodes send at once with one identifier: frames are destroyed, "
                                           "both run into bus-off, and a receiver takes "
                                           "one for the other.",
                                       .mend = "Give each TPDO, EMCY and SDO server an identifier of its own.",
                                       .example = R"((0.0000) can0 605#2300180185010000
(0.0010) can0 585#6000180100000000
(0.0020) can0 606#2300180185010000
(0.0030) can0 586#6000180100000000)"};

inline constexpr Rule kRestricted{.id = "bus.restricted",
                                  .text = "a service gets an identifier that is restricted",
                                  .clause = "CiA 301 7.3.5",
                                  .why =
                                      "The identifier belongs to NMT, SDO or error control; the device aborts "
                                      "with 06090030h, or two services meet.",
                                  .mend = "Take one that the list of restricted identifiers does not have.",
                                  .example = R"((0.0000) can0 605#2314100085050000
(0.0010) can0 585#8014100000000008)"};

inline constexpr Rule kAnsweredTwice{
    .id = "bus.answered-twice",
    .text = "a request is answered twice",
    .clause = "CiA 301 7.3.5",
    .why =
        "Two nodes have the same node-ID: a master configures both at once, and reads now one and now the other.",
    .mend = "Give each node a node-ID of its own; LSS or a look at the switches finds the other one.",
    .example = R"((0.0000) can0 605#4000100000000000
(0.0010) can0 585#4300100092010200
(0.0011) can0 585#4300100092010000)"};

inline constexpr Rule kUnknown{
    .id = "bus.unknown",
    .text = "a frame has an identifier that no service has",
    .clause = "CiA 301 7.3.5",
    .severity = Severity::Warning,
    .why = "Nobody takes it: often a PDO that was moved in one place only, or bytes in the wrong order.",
    .mend = "Send with the COB-ID that the node has (1400h); leave 002h to 070h and 077h to 07Fh alone.",
    .example = R"((0.0000) can0 050#01)"};

inline constexpr Rule kExtended{
    .id = "bus.extended",
    .text = "a frame has 29 bits of identifier",
    .clause = "CiA 301 7.1.3",
    .severity = Severity::Warning,
    .why = "CANopen devices hardly ever take it; that it is from another protocol is as likely.",
    .mend = "Use identifiers of 11 bits, and no other protocol on the same line.",
    .example = R"((0.0000) can0 00000205#0600)"};

inline constexpr Rule kTimeLength{.id = "bus.time-length",
                                  .text = "TIME has not six bytes",
                                  .clause = "CiA 301 7.2.6.3",
                                  .why = "Nodes ignore it.",
                                  .mend = "Milliseconds since midnight in 28 bits, then days since 1984 in 16.",
                                  .example = R"((0.0000) can0 100#00000000)"};

inline constexpr Rule kLoad{
    .id = "bus.load",
    .text = "the bus is busy for more than four fifths of a second",
    .clause = "CiA 301 7.1",
    .severity = Severity::Warning,
    .why =
        "What has a high identifier (SDO, heartbeat) comes late, supervision fires, and an error more stops it "
        "all.",
    .mend = "Send less: longer periods, inhibit times, several objects in a PDO, a higher bit rate.",
    .example = ""};

inline constexpr Rule kBurst{
    .id = "bus.burst",
    .text = "frames that SDO has to give way to follow each other without a gap for 50 ms",
    .clause = "CiA 301 7.1",
    .severity = Severity::Warning,
    .why =
        "What has a higher identifier waits that long: heartbeats come late, and receivers lose what they have "
        "no room for.",
    .mend = "Spread set-points and commands over the cycle, and give PDOs an inhibit time.",
    .example = ""};

inline constexpr Rule kErrors{
    .id = "bus.errors",
    .text = "the controller reports errors",
    .clause = "ISO 11898-1",
    .severity = Severity::Warning,
    .why = "A wrong bit rate, a missing resistor or two senders of one identifier: frames are repeated or lost.",
    .mend = "Look at termination, bit rate and the identifiers of all nodes.",
    .example = R"((0.0000) can0 20000004#0020000000000000)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kIdentifierTwice, &kRestricted, &kAnsweredTwice, &kUnknown, &kExtended,
                                 &kTimeLength,      &kLoad,       &kBurst,         &kErrors};

}  // namespace audit::bus_rules
