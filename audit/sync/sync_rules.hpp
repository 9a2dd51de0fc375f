#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::sync_rules {

inline constexpr Rule kJitter{
    .id = "sync.jitter",
    .text = "SYNC comes early or late by more than a fifth of its period",
    .clause = "CiA 301 7.2.5",
    .severity = Severity::Warning,
    .why =
        "Drives that interpolate between set-points run by the mean period: the shaft moves unevenly, or the "
        "drive reports "
        "a missing set-point.",
    .mend = "Send SYNC by a timer of the kernel or the controller, not after the work of the cycle.",
    .example = R"((0.0000) can0 080#
(0.0100) can0 080#
(0.0200) can0 080#
(0.0300) can0 080#
(0.0400) can0 080#
(0.0500) can0 080#
(0.0600) can0 080#
(0.0700) can0 080#
(0.0800) can0 080#
(0.0950) can0 080#)"};

inline constexpr Rule kCounter{
    .id = "sync.counter",
    .text = "the counter of SYNC does not go on by one, or goes beyond 1019h",
    .clause = "CiA 301 7.2.5.3",
    .why = "Nodes that begin with a certain count, or send with each n-th SYNC, get out of step with the others.",
    .mend = "Count from 1 to the value of 1019h, then from 1 again.",
    .example = R"((0.0000) can0 080#01
(0.0100) can0 080#02
(0.0200) can0 080#04)"};

inline constexpr Rule kLength{
    .id = "sync.length",
    .text = "SYNC has another length than before, or more than one byte",
    .clause = "CiA 301 7.2.5.3",
    .why = "With 1019h = 0 it has no byte, else one: nodes ignore the others and may send EMCY 8240h.",
    .mend = "Set 1019h alike in all nodes and in the producer.",
    .example = R"((0.0000) can0 080#
(0.0100) can0 080#01)"};

inline constexpr Rule kWindow{
    .id = "sync.window",
    .text = "a synchronous RPDO is sent behind the window after SYNC",
    .clause = "CiA 301 7.5.2.7",
    .severity = Severity::Warning,
    .why = "Behind the time of 1007h the node may drop it; the set-point then acts a cycle later.",
    .mend = "Send the set-points within the window behind SYNC, or write 0 to 1007h.",
    .example = R"((0.0000) can0 605#23071000E8030000
(0.0010) can0 585#6007100000000000
(0.0020) can0 605#2F00140201000000
(0.0030) can0 585#6000140200000000
(0.1000) can0 080#
(0.1050) can0 205#0600)"};

inline constexpr Rule kPeriod{.id = "sync.period",
                              .text = "SYNC has not the period that a node was told",
                              .clause = "CiA 301 7.5.2.6",
                              .severity = Severity::Warning,
                              .why =
                                  "A node that supervises SYNC by 1006h reports its loss; a drive that "
                                  "interpolates moves with another speed.",
                              .mend = "Write the period of the producer to 1006h of the nodes, in microseconds.",
                              .example = R"((0.0000) can0 605#23061000204E0000
(0.0010) can0 585#6006100000000000
(0.1000) can0 080#
(0.1100) can0 080#
(0.1200) can0 080#
(0.1300) can0 080#
(0.1400) can0 080#
(0.1500) can0 080#
(0.1600) can0 080#
(0.1700) can0 080#
(0.1800) can0 080#)"};

inline constexpr Rule kTwoProducers{
    .id = "sync.two-producers",
    .text = "a node is told to produce SYNC while there is a producer already",
    .clause = "CiA 301 7.2.5.1",
    .why = "Two SYNC in a period: PDOs go out twice, and the drives interpolate by neither.",
    .mend = "Set bit 30 of 1005h in one node at most, and in none if the master sends SYNC.",
    .example = R"((0.0000) can0 080#
(0.1000) can0 080#
(0.1010) can0 605#4005100000000000
(0.1020) can0 585#4305100080000000
(0.2000) can0 080#
(0.2010) can0 605#2305100080000040
(0.2020) can0 585#6005100000000000)"};

inline constexpr Rule kMissing{.id = "sync.missing",
                               .text = "a node with synchronous PDOs is Operational, and there is no SYNC",
                               .clause = "CiA 301 7.2.2.2",
                               .severity = Severity::Warning,
                               .why = "Its synchronous TPDOs are never sent, and its RPDOs never act.",
                               .mend = "Send SYNC, or give the PDOs the transmission type 254 or 255.",
                               .example = R"((0.0000) can0 605#2F00180201000000
(0.0010) can0 585#6000180200000000
(0.0020) can0 605#2300180185010000
(0.0030) can0 585#6000180100000000
(0.0100) can0 000#0105
(0.0200) can0 705#05
(9.0000) can0 705#05)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kJitter, &kCounter, &kLength, &kWindow, &kPeriod, &kTwoProducers, &kMissing};

}  // namespace audit::sync_rules
