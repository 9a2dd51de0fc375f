#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::nmt_rules {

inline constexpr Rule kBeforeBootUp{
    .id = "nmt.before-boot-up",
    .text = "an NMT command is sent to a node that has not booted yet",
    .clause = "CiA 301 7.3.2.2.1",
    .why =
        "A node that initialises hears nothing: the command is lost, and the master believes the node to be in "
        "another "
        "state.",
    .mend = "Wait for the boot-up message (700h + node-ID, one byte 0) after each reset.",
    .example = R"((0.0000) can0 000#8105
(0.0100) can0 000#0105)"};

inline constexpr Rule kSdoBeforeBootUp{
    .id = "nmt.sdo-before-boot-up",
    .text = "an SDO request is sent to a node that has not booted yet",
    .clause = "CiA 301 7.3.2.2.1",
    .severity = Severity::Warning,
    .why = "Nobody answers; the master runs into its time-out, or takes a late answer for another one.",
    .mend = "Wait for the boot-up message after each reset, or ask again and again with a time-out.",
    .example = R"((0.0000) can0 000#8105
(0.0100) can0 605#4000100000000000)"};

inline constexpr Rule kSdoWhenStopped{.id = "nmt.sdo-when-stopped",
                                      .text = "an SDO request is sent to a node that is stopped",
                                      .clause = "CiA 301 7.3.2.2.4",
                                      .why = "A stopped node has NMT and error control only.",
                                      .mend = "Bring it to Pre-operational first.",
                                      .example = R"((0.0000) can0 705#7F
(0.0010) can0 000#0205
(0.0100) can0 605#4000100000000000)"};

inline constexpr Rule kRepeated{
    .id = "nmt.repeated",
    .text = "an NMT command is repeated though the node is in the state that it leads to",
    .clause = "CiA 301 7.3.2.2.1",
    .severity = Severity::Warning,
    .why = "It is of no use, and hides a node that falls back: nobody sees that it had to be started again.",
    .mend = "Look at the state in the heartbeat, and send a command when it is another one.",
    .example = R"((0.0000) can0 705#05
(0.1000) can0 000#0105
(0.2000) can0 000#0105
(0.3000) can0 000#0105)"};

inline constexpr Rule kCommand{.id = "nmt.command",
                               .text = "an NMT command is unknown",
                               .clause = "CiA 301 7.2.8.3.1",
                               .why = "No node does anything.",
                               .mend = "1, 2, 128, 129 or 130.",
                               .example = R"((0.0000) can0 000#0305)"};

inline constexpr Rule kLength{.id = "nmt.length",
                              .text = "an NMT command has not two bytes",
                              .clause = "CiA 301 7.2.8.3.1",
                              .why = "Nodes ignore it.",
                              .mend = "The command and the node-ID, 0 for all nodes.",
                              .example = R"((0.0000) can0 000#01)"};

inline constexpr Rule kNodeId{.id = "nmt.node-id",
                              .text = "an NMT command is for a node-ID beyond 127",
                              .clause = "CiA 301 7.2.8.3.1",
                              .why = "There is no such node.",
                              .mend = "0 for all nodes, 1 to 127 for one.",
                              .example = R"((0.0000) can0 000#0185)"};

inline constexpr Rule kForgotten{
    .id = "nmt.forgotten",
    .text = "a node is left in Pre-operational while others are started",
    .clause = "CiA 301 7.3.2.2.2",
    .severity = Severity::Warning,
    .why = "Its PDOs do not work; often it has booted later than the others.",
    .mend = "Start nodes as their boot-up messages come, or when all that are expected are there.",
    .example = R"((0.0000) can0 705#00
(0.0100) can0 706#00
(0.0200) can0 000#0105
(0.0300) can0 705#05
(1.0100) can0 706#7F
(9.0000) can0 705#05)"};

inline constexpr Rule kResetInTransfer{
    .id = "nmt.reset-in-transfer",
    .text = "a node is reset before it has answered an SDO request",
    .clause = "CiA 301 7.3.2.2.1",
    .severity = Severity::Warning,
    .why = "Whether the value was written nobody knows; a store that is cut may be lost.",
    .mend = "Wait for the answer, a store takes seconds.",
    .example = R"((0.0000) can0 605#2310100173617665
(0.0010) can0 000#8105)"};

inline constexpr Rule kRebootUnnoticed{
    .id = "nmt.reboot-unnoticed",
    .text = "a node that has booted again is not taken care of",
    .clause = "CiA 301 7.3.2.2.1",
    .why =
        "It was off or has been reset: it is in Pre-operational with its default values, and the master goes on "
        "as if "
        "nothing had happened.",
    .mend = "Take each boot-up message for the loss of the node: configure and start it again.",
    .example = R"((0.0000) can0 000#0105
(0.0100) can0 705#05
(0.5000) can0 080#
(1.0000) can0 705#00
(1.5000) can0 080#
(4.5000) can0 080#)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kBeforeBootUp,    &kSdoBeforeBootUp, &kSdoWhenStopped, &kRepeated,
                                 &kCommand,         &kLength,          &kNodeId,         &kForgotten,
                                 &kResetInTransfer, &kRebootUnnoticed};

}  // namespace audit::nmt_rules
