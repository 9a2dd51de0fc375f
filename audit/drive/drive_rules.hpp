#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::drive_rules {

// Examples begin with what makes the mapping known: RPDO 1 is the controlword (6040h), TPDO 1 the statusword
// (6041h).

inline constexpr Rule kStepSkipped{
    .id = "drive.step-skipped",
    .text = "a drive is to be switched on while it is in Switch on disabled",
    .clause = "CiA 402-2 8.2",
    .why = "Only 06h leads out of that state: the command has no effect, and the drive never runs.",
    .mend = "06h, wait for Ready to switch on, 07h, wait for Switched on, 0Fh.",
    .example = R"((0.0000) can0 605#4041600000000000
(0.0010) can0 585#4B41600050020000
(0.0020) can0 605#2B4060000F000000
(0.0030) can0 585#6040600000000000)"};

inline constexpr Rule kTooFast{
    .id = "drive.too-fast",
    .text = "a controlword follows the last one before any statusword has come",
    .clause = "CiA 402-2 8.2",
    .severity = Severity::Warning,
    .why =
        "The drive takes the last controlword of its cycle: a step between is never seen, and the sequence hangs.",
    .mend = "Send the next command when the statusword shows the state that the last one leads to.",
    .example = R"((0.0000) can0 605#4041600000000000
(0.0010) can0 585#4B41600050020000
(0.0020) can0 605#2B40600006000000
(0.0030) can0 585#6040600000000000
(0.0040) can0 605#2B40600007000000
(0.0050) can0 585#6040600000000000)"};

inline constexpr Rule kResetWithoutEdge{
    .id = "drive.reset-without-edge",
    .text = "a fault is to be reset by a bit that is set all the time",
    .clause = "CiA 402-2 8.2",
    .why = "Only the change of bit 7 from 0 to 1 resets a fault: the drive stays in Fault.",
    .mend = "Clear bit 7, then set it, and clear it again when the fault is gone.",
    .example = R"((0.0000) can0 605#2B40600080000000
(0.0010) can0 585#6040600000000000
(0.0020) can0 605#4041600000000000
(0.0030) can0 585#4B41600008020000
(0.0040) can0 605#2B40600080000000
(0.0050) can0 585#6040600000000000)"};

inline constexpr Rule kResetRepeated{
    .id = "drive.reset-repeated",
    .text = "a fault is reset again and again without a look at its cause",
    .clause = "CiA 402-2 8.2",
    .severity = Severity::Warning,
    .why = "The cause is still there; some faults, reset while hot, damage the drive.",
    .mend = "Read 603Fh or 1003h, say what it is, and let a person decide.",
    .example = R"((0.0000) can0 605#4041600000000000
(0.0010) can0 585#4B41600008020000
(0.1000) can0 605#2B40600080000000
(0.1010) can0 585#6040600000000000
(0.1500) can0 605#4041600000000000
(0.1510) can0 585#4B41600008020000
(0.2000) can0 605#2B40600000000000
(0.2010) can0 585#6040600000000000
(0.2500) can0 605#4041600000000000
(0.2510) can0 585#4B41600008020000
(0.3000) can0 605#2B40600080000000
(0.3010) can0 585#6040600000000000
(0.3500) can0 605#4041600000000000
(0.3510) can0 585#4B41600008020000
(0.4000) can0 605#2B40600000000000
(0.4010) can0 585#6040600000000000
(0.4500) can0 605#4041600000000000
(0.4510) can0 585#4B41600008020000
(0.5000) can0 605#2B40600080000000
(0.5010) can0 585#6040600000000000)"};

inline constexpr Rule kHandshake{.id = "drive.set-point-handshake",
                                 .text = "a new set-point is given before the last one was let go",
                                 .clause = "CiA 402-2 10.2",
                                 .why =
                                     "While bit 12 of the statusword is 1 the drive takes none: the position is "
                                     "lost, and the move ends elsewhere.",
                                 .mend = "Set bit 4, wait for bit 12, clear bit 4, wait until bit 12 is 0.",
                                 .example = R"((0.0000) can0 605#2F60600001000000
(0.0010) can0 585#6060600000000000
(0.0020) can0 605#4061600000000000
(0.0030) can0 585#4F61600001000000
(0.0040) can0 605#2B4060000F000000
(0.0050) can0 585#6040600000000000
(0.0060) can0 605#4041600000000000
(0.0070) can0 585#4B41600037120000
(0.0080) can0 605#2B4060001F000000
(0.0090) can0 585#6040600000000000)"};

inline constexpr Rule kNoNewSetPoint{.id = "drive.no-new-set-point",
                                     .text = "a position is written, and bit 4 of the controlword does not change",
                                     .clause = "CiA 402-2 10.2",
                                     .severity = Severity::Warning,
                                     .why =
                                         "In profile position mode the drive takes a position with the change of "
                                         "bit 4 from 0 to 1 alone: it does not move.",
                                     .mend = "Clear bit 4 and set it for each position, or use csp.",
                                     .example = R"((0.0000) can0 605#2F60600001000000
(0.0010) can0 585#6060600000000000
(0.0020) can0 605#4061600000000000
(0.0030) can0 585#4F61600001000000
(0.0040) can0 605#2B4060001F000000
(0.0050) can0 585#6040600000000000
(0.0060) can0 605#4041600000000000
(0.0070) can0 585#4B41600037020000
(0.1000) can0 605#237A600010270000
(0.1010) can0 585#607A600000000000
(3.0000) can0 605#237A600020270000
(3.0010) can0 585#607A600000000000)"};

inline constexpr Rule kModeUnread{.id = "drive.mode-unread",
                                  .text = "a drive is enabled after a change of mode without a look at 6061h",
                                  .clause = "CiA 402-2 8.4",
                                  .severity = Severity::Warning,
                                  .why =
                                      "6060h is a wish: a mode that the drive does not take leaves the last one, "
                                      "and the set-point means another thing.",
                                  .mend = "Read 6061h, or map it into a TPDO, and enable when it shows the mode.",
                                  .example = R"((0.0000) can0 605#2F60600003000000
(0.0010) can0 585#6060600000000000
(0.0020) can0 605#4041600000000000
(0.0030) can0 585#4B41600033020000
(0.0040) can0 605#2B4060000F000000
(0.0050) can0 585#6040600000000000)"};

inline constexpr Rule kModeMoving{.id = "drive.mode-moving",
                                  .text = "the mode is changed while the drive moves",
                                  .clause = "CiA 402-2 8.4",
                                  .severity = Severity::Warning,
                                  .why = "The set-points of the new mode act at once, whatever they are.",
                                  .mend = "Stop, write the set-points of the new mode, then change it.",
                                  .example = R"((0.0000) can0 605#2F60600003000000
(0.0010) can0 585#6060600000000000
(0.0020) can0 605#4061600000000000
(0.0030) can0 585#4F61600003000000
(0.0040) can0 605#4041600000000000
(0.0050) can0 585#4B41600037020000
(0.0060) can0 605#2F60600004000000
(0.0070) can0 585#6060600000000000)"};

inline constexpr Rule kModeUnsupported{
    .id = "drive.mode-unsupported",
    .text = "a mode is chosen that the drive does not have",
    .clause = "CiA 402-2 8.4",
    .why = "6502h says which modes there are: the drive refuses it, or stays in the last one.",
    .mend = "Read 6502h first.",
    .example = R"((0.0000) can0 605#4002650000000000
(0.0010) can0 585#4302650004000000
(0.0020) can0 605#2F60600008000000
(0.0030) can0 585#6060600000000000)"};

inline constexpr Rule kStartJump{
    .id = "drive.start-jump",
    .text = "a drive is enabled in csp with a set-point far from where it is",
    .clause = "CiA 402-2 13.2",
    .why = "The drive jumps there as quick as it can, or trips on its following error.",
    .mend = "Read the actual position and begin with it.",
    .example = R"((0.0000) can0 605#4065600000000000
(0.0010) can0 585#43656000E8030000
(0.0020) can0 605#4064600000000000
(0.0030) can0 585#4364600000000000
(0.0040) can0 605#2F60600008000000
(0.0050) can0 585#6060600000000000
(0.0060) can0 605#4061600000000000
(0.0070) can0 585#4F61600008000000
(0.0080) can0 605#237A600000000100
(0.0090) can0 585#607A600000000000
(0.0100) can0 605#4041600000000000
(0.0110) can0 585#4B41600033020000
(0.0120) can0 605#2B4060000F000000
(0.0130) can0 585#6040600000000000)"};

inline constexpr Rule kJump{
    .id = "drive.jump",
    .text = "a set-point of csp jumps",
    .clause = "CiA 402-2 13.2",
    .severity = Severity::Warning,
    .why =
        "It is farther from where the last ones lead to than the following error that the drive allows: it jerks, "
        "or trips.",
    .mend = "Send what an interpolator gives, cycle by cycle; ramp down and up where the path is changed.",
    .example = R"((0.0000) can0 605#4065600000000000
(0.0010) can0 585#43656000E8030000
(0.0020) can0 605#2F60600008000000
(0.0030) can0 585#6060600000000000
(0.0040) can0 605#4061600000000000
(0.0050) can0 585#4F61600008000000
(0.0060) can0 605#4000160000000000
(0.0070) can0 585#4F00160001000000
(0.0080) can0 605#4000160100000000
(0.0090) can0 585#4300160120007A60
(0.0100) can0 605#4041600000000000
(0.0110) can0 585#4B41600037020000
(0.0120) can0 705#05
(0.0200) can0 205#0A000000
(0.0300) can0 080#
(0.0350) can0 205#14000000
(0.0400) can0 080#
(0.0450) can0 205#00100000
(0.0500) can0 080#)"};

inline constexpr Rule kTwoSources{.id = "drive.two-sources",
                                  .text = "the controlword is written over SDO while an RPDO has it",
                                  .clause = "CiA 402-2 8.2",
                                  .severity = Severity::Warning,
                                  .why = "The next RPDO undoes it, some milliseconds later.",
                                  .mend = "Use one way at a time.",
                                  .example = R"((0.0000) can0 605#4000160000000000
(0.0010) can0 585#4F00160001000000
(0.0020) can0 605#4000160100000000
(0.0030) can0 585#4300160110004060
(0.0040) can0 705#05
(0.0100) can0 205#0600
(0.0200) can0 605#2B40600006000000
(0.0210) can0 585#6040600000000000)"};

inline constexpr Rule kHalt{.id = "drive.halt",
                            .text = "set-points change while halt is set",
                            .clause = "CiA 402-2 8.2",
                            .severity = Severity::Warning,
                            .why = "The drive stands, whatever they are.",
                            .mend = "Clear bit 8 of the controlword.",
                            .example = R"((0.0000) can0 605#2B4060000F010000
(0.0010) can0 585#6040600000000000
(0.0020) can0 605#4041600000000000
(0.0030) can0 585#4B41600037020000
(0.1000) can0 605#23FF600001000000
(0.1010) can0 585#60FF600000000000
(0.2000) can0 605#23FF600002000000
(0.2010) can0 585#60FF600000000000
(0.3000) can0 605#23FF600003000000
(0.3010) can0 585#60FF600000000000
(0.4000) can0 605#23FF600004000000
(0.4010) can0 585#60FF600000000000
(0.5000) can0 605#23FF600005000000
(0.5010) can0 585#60FF600000000000)"};

inline constexpr Rule kSetPointMissing{
    .id = "drive.set-point-missing",
    .text = "a SYNC comes without a new set-point in the middle of a movement",
    .clause = "CiA 402-2 13.2",
    .severity = Severity::Warning,
    .why = "The drive interpolates to where it is already: it stops for a cycle, or trips.",
    .mend = "Send the set-point of each cycle, before its SYNC.",
    .example = R"((0.0000) can0 605#2F60600008000000
(0.0010) can0 585#6060600000000000
(0.0020) can0 605#4061600000000000
(0.0030) can0 585#4F61600008000000
(0.0040) can0 605#4000160000000000
(0.0050) can0 585#4F00160002000000
(0.0060) can0 605#4000160100000000
(0.0070) can0 585#4300160110004060
(0.0080) can0 605#4000160200000000
(0.0090) can0 585#4300160220007A60
(0.0100) can0 605#4041600000000000
(0.0110) can0 585#4B41600037020000
(0.0120) can0 705#05
(0.0200) can0 205#0F0001000000
(0.0300) can0 080#
(0.0350) can0 205#0F0002000000
(0.0400) can0 080#
(0.0450) can0 205#0F0003000000
(0.0500) can0 080#
(0.0600) can0 080#
(0.0650) can0 205#0F0005000000)"};

inline constexpr Rule kBeyondLimits{.id = "drive.beyond-limits",
                                    .text = "a position is beyond the software limits",
                                    .clause = "CiA 402-2 8.4",
                                    .why = "The drive refuses it, stops at the limit, or trips.",
                                    .mend = "Keep to 607Dh, which counts from the reference point.",
                                    .example = R"((0.0000) can0 605#407D600200000000
(0.0010) can0 585#437D6002E8030000
(0.0020) can0 605#237A6000E9030000
(0.0030) can0 585#607A600000000000)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{
    &kStepSkipped, &kTooFast,         &kResetWithoutEdge, &kResetRepeated, &kHandshake, &kNoNewSetPoint,
    &kModeUnread,  &kModeMoving,      &kModeUnsupported,  &kStartJump,     &kJump,      &kTwoSources,
    &kHalt,        &kSetPointMissing, &kBeyondLimits};

}  // namespace audit::drive_rules
