#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::error_control_rules {

inline constexpr Rule kConsumerShorter{
    .id = "error-control.consumer-shorter",
    .text = "a heartbeat consumer time is not longer than the producer time",
    .clause = "CiA 301 7.2.8.2.2",
    .why = "The consumer reports a loss while the producer is right, at once or when the bus is busy.",
    .mend =
        "Give the consumer (1016h) at least one and a half times the producer time (1017h), better three times.",
    .example = R"((0.0000) can0 606#2B171000E8030000
(0.0010) can0 586#6017100000000000
(0.0020) can0 605#23161001F4010600
(0.0030) can0 585#6016100100000000)"};

inline constexpr Rule kBoth{
    .id = "error-control.both",
    .text = "a node gets heartbeat and node guarding",
    .clause = "CiA 301 7.2.8.2.2",
    .severity = Severity::Warning,
    .why = "It does only the heartbeat; the guarding that the master counts on never fires.",
    .mend = "Write 0 to 100Ch or to 1017h.",
    .example = R"((0.0000) can0 605#2B0C100064000000
(0.0010) can0 585#600C100000000000
(0.0020) can0 605#2F0D100003000000
(0.0030) can0 585#600D100000000000
(0.0040) can0 605#2B171000E8030000
(0.0050) can0 585#6017100000000000)"};

inline constexpr Rule kGuardsHeartbeat{
    .id = "error-control.guards-heartbeat",
    .text = "a node that sends heartbeats is guarded by remote frames",
    .clause = "CiA 301 7.2.8.2.2",
    .severity = Severity::Warning,
    .why = "It does not answer: the master believes it to be lost.",
    .mend = "Use the heartbeat; write 0 to 1017h where node guarding has to be.",
    .example = R"((0.0000) can0 605#2B171000E8030000
(0.0010) can0 585#6017100000000000
(0.0100) can0 705#7F
(0.5000) can0 705#R)"};

inline constexpr Rule kLifeTime{.id = "error-control.life-time",
                                .text = "node guarding comes later than the life time of the node",
                                .clause = "CiA 301 7.2.8.3.2.1",
                                .why = "The node takes the master for lost: EMCY 8130h, and a drive stops.",
                                .mend = "Ask within the guard time (100Ch); the life time is that times 100Dh.",
                                .example = R"((0.0000) can0 605#2B0C100064000000
(0.0010) can0 585#600C100000000000
(0.0020) can0 605#2F0D100003000000
(0.0030) can0 585#600D100000000000
(0.1000) can0 705#R
(0.1010) can0 705#7F
(0.2000) can0 705#R
(0.2010) can0 705#FF
(0.6000) can0 705#R
(0.6010) can0 705#7F)"};

inline constexpr Rule kHeartbeatLate{
    .id = "error-control.heartbeat-late",
    .text = "a heartbeat comes later than a node waits for it",
    .clause = "CiA 301 7.2.8.2.2",
    .why = "The consumer takes the producer for lost: EMCY 8130h, and a drive stops.",
    .mend = "Send it by a timer that nothing holds up, several times in the consumer time.",
    .example = R"((0.0000) can0 605#2316100164000100
(0.0010) can0 585#6016100100000000
(0.0500) can0 701#05
(0.1000) can0 701#05
(0.1500) can0 701#05
(0.2600) can0 701#05)"};

inline constexpr Rule kNobody{
    .id = "error-control.nobody",
    .text = "a node is told to wait for the heartbeat of a node that sends none",
    .clause = "CiA 301 7.5.2.19",
    .severity = Severity::Warning,
    .why = "Supervision begins with the first heartbeat: it never does, and a loss is never noticed.",
    .mend = "Write the node-ID of the master to 1016h, and have the master send heartbeats.",
    .example = R"((0.0000) can0 605#23161001E8032A00
(0.0010) can0 585#6016100100000000
(9.0000) can0 080#)"};

inline constexpr Rule kLost{.id = "error-control.lost",
                            .text = "a node has fallen silent, and the master goes on as if it were there",
                            .clause = "CiA 301 7.2.8.2.2",
                            .severity = Severity::Warning,
                            .why = "Its heartbeat tells the master that it is there; nobody looks.",
                            .mend = "Consume the heartbeats of all nodes, and stop or bring back what is lost.",
                            .example = R"((0.0000) can0 705#05
(0.1000) can0 705#05
(0.2000) can0 705#05
(0.3000) can0 705#05
(0.4000) can0 205#0600
(1.4000) can0 205#0600
(2.4000) can0 205#0600
(3.4000) can0 205#0600
(4.4000) can0 205#0600)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{&kConsumerShorter, &kBoth, &kGuardsHeartbeat, &kLifeTime, &kHeartbeatLate,
                                 &kNobody,          &kLost};

}  // namespace audit::error_control_rules
