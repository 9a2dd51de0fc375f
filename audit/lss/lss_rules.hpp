#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::lss_rules {

inline constexpr Rule kOrder{.id = "lss.order",
                             .text = "LSS configures or stores while no node was switched to configuration",
                             .clause = "CiA 305 3.8",
                             .why = "Nodes in the waiting state do not answer; the node-ID stays as it was.",
                             .mend = "Switch one node to configuration by its LSS address first.",
                             .example = R"((0.0000) can0 7E5#1105000000000000)"};

inline constexpr Rule kNodeId{.id = "lss.node-id",
                              .text = "LSS configures a node-ID that there is not",
                              .clause = "CiA 305 3.8.2.1",
                              .why = "The node refuses it, 1 in the second byte of its answer.",
                              .mend = "1 to 127, or 255 to take the node-ID away.",
                              .example = R"((0.0000) can0 7E5#0401000000000000
(0.0100) can0 7E5#1180000000000000
(0.0110) can0 7E4#1101000000000000)"};

inline constexpr Rule kGlobal{
    .id = "lss.global",
    .text = "LSS configures all nodes at once",
    .clause = "CiA 305 3.8.1.1",
    .severity = Severity::Warning,
    .why = "All nodes on the bus that know LSS get the same node-ID.",
    .mend = "Switch one node by its LSS address (vendor, product, revision, serial number).",
    .example = R"((0.0000) can0 705#7F
(0.0010) can0 706#7F
(0.0100) can0 7E5#0401000000000000
(0.0200) can0 7E5#1107000000000000
(0.0210) can0 7E4#1100000000000000
(0.0300) can0 7E5#0400000000000000)"};

inline constexpr Rule kLeftOpen{.id = "lss.left-open",
                                .text = "LSS leaves nodes in the configuration state",
                                .clause = "CiA 305 3.8.1",
                                .severity = Severity::Warning,
                                .why = "They answer what is meant for the next one.",
                                .mend = "Switch all to waiting (04h 00h) when it is done.",
                                .example = R"((0.0000) can0 7E5#0401000000000000
(0.0100) can0 7E5#1105000000000000
(0.0110) can0 7E4#1100000000000000
(9.0000) can0 705#00)"};

inline constexpr Rule kLength{.id = "lss.length",
                              .text = "an LSS command has not eight bytes",
                              .clause = "CiA 305 3.8",
                              .why = "Nodes ignore it.",
                              .mend = "Eight bytes, those that are not used with zero.",
                              .example = R"((0.0000) can0 7E5#0401)"};

inline constexpr Rule kOverlap{
    .id = "lss.overlap",
    .text = "an LSS command is sent before the answer to the last one",
    .clause = "CiA 305 3.8",
    .why = "There is one answer at a time on one identifier: the master takes one for the other.",
    .mend = "Wait for the answer, or for the time-out.",
    .example = R"((0.0000) can0 7E5#0401000000000000
(0.0100) can0 7E5#5E00000000000000
(0.0102) can0 7E5#5A00000000000000
(0.0110) can0 7E4#5E05000000000000
(0.0120) can0 7E4#5ABD000000000000
(0.0200) can0 7E5#0400000000000000)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kOrder, &kNodeId, &kGlobal, &kLeftOpen, &kLength, &kOverlap};

}  // namespace audit::lss_rules
