#pragma once

#include <array>

#include "audit/base/rule.hpp"

namespace audit::sdo_rules {

inline constexpr Rule kOverlap{
    .id = "sdo.overlap",
    .text = "a request is sent before the answer to the last one",
    .clause = "CiA 301 7.2.4.2",
    .why =
        "A server serves one request at a time. It may drop the second, or answer the first only, and the master "
        "takes "
        "one answer for the other.",
    .mend = "Send the next request of a channel when the answer, an abort, or the own time-out has come.",
    .example = R"((0.0000) can0 605#4000100000000000
(0.0002) can0 605#4001100000000000)"};

inline constexpr Rule kUnaborted{
    .id = "sdo.unaborted",
    .text = "a transfer is given up without an abort",
    .clause = "CiA 301 7.2.4.3.17",
    .severity = Severity::Warning,
    .why = "The server still holds the transfer; its late answer is taken for that of the next request.",
    .mend = "Send an abort with 05040000h when the time-out has come, then begin the next transfer.",
    .example = R"((0.0000) can0 605#4000100000000000
(1.0000) can0 605#4001100000000000
(1.0010) can0 585#4F01100000000000)"};

inline constexpr Rule kTimeOutShort{
    .id = "sdo.time-out-short",
    .text = "the answer comes after the master has given up",
    .clause = "CiA 301 7.2.4.3.17",
    .severity = Severity::Warning,
    .why =
        "The server was right and in time for itself; the master loses what it has asked for, and may take the "
        "late "
        "answer for another one.",
    .mend = "Wait as long as the manual of the unit says, at least 500 ms; stores take seconds.",
    .example = R"((0.0000) can0 605#4000100000000000
(0.0300) can0 605#8000100000000405
(0.0310) can0 585#4300100092010200)"};

inline constexpr Rule kLength{.id = "sdo.length",
                              .text = "a request has not eight bytes",
                              .clause = "CiA 301 7.2.4.3",
                              .why = "Servers ignore it, and nothing is answered.",
                              .mend = "Send eight bytes, those that are not used with zero.",
                              .example = R"((0.0000) can0 605#40001000)"};

inline constexpr Rule kCommand{
    .id = "sdo.command",
    .text = "a request has an unknown command or bits that must be zero",
    .clause = "CiA 301 7.2.4.3",
    .why = "The server aborts with 05040001h, or ignores the bits today and not with the next firmware.",
    .mend = "Build the command byte as the standard has it.",
    .example = R"((0.0000) can0 605#4001100000000000
(0.0010) can0 585#4F01100000000000
(0.0020) can0 605#E000100000000000
(0.0030) can0 585#8000100001000405)"};

inline constexpr Rule kSegmentAlone{
    .id = "sdo.segment-alone",
    .text = "a segment is sent or asked for outside of a transfer in segments",
    .clause = "CiA 301 7.2.4.3.3",
    .why = "There is nothing that it belongs to: the server aborts with 05040001h.",
    .mend = "Begin with an initiate request, and look at its answer: a short value comes with it.",
    .example = R"((0.0000) can0 605#4001100000000000
(0.0010) can0 585#4F01100000000000
(0.0020) can0 605#6000000000000000
(0.0030) can0 585#8000000001000405)"};

inline constexpr Rule kToggle{.id = "sdo.toggle",
                              .text = "the toggle bit of a segment does not alternate",
                              .clause = "CiA 301 7.2.4.3.4",
                              .why = "The server aborts with 05030000h, and the transfer is lost.",
                              .mend = "Begin with 0 in each transfer, and change it with each segment.",
                              .example = R"((0.0000) can0 605#4008100000000000
(0.0010) can0 585#410810000A000000
(0.0020) can0 605#6000000000000000
(0.0030) can0 585#0053696D756C6174
(0.0040) can0 605#6000000000000000
(0.0050) can0 585#8008100000000305)"};

inline constexpr Rule kLeftOpen{
    .id = "sdo.left-open",
    .text = "a transfer in segments or blocks is left open",
    .clause = "CiA 301 7.2.4.2",
    .why = "The server keeps the transfer, waits for the next segment, and may refuse others or abort late.",
    .mend = "Read or write to the last segment, or send an abort.",
    .example = R"((0.0000) can0 605#4008100000000000
(0.0010) can0 585#410810000A000000
(0.0020) can0 605#6000000000000000
(0.0030) can0 585#0053696D756C6174
(0.0040) can0 605#4001100000000000
(0.0050) can0 585#4F01100000000000)"};

inline constexpr Rule kAfterAbort{.id = "sdo.after-abort",
                                  .text = "a transfer goes on after the server has aborted it",
                                  .clause = "CiA 301 7.2.4.3.17",
                                  .why =
                                      "The abort has told that the value was not taken. What follows belongs to "
                                      "nothing, and the master thinks it "
                                      "was written.",
                                  .mend = "Look at each answer for an abort, and report its code.",
                                  .example = R"((0.0000) can0 605#2108100008000000
(0.0010) can0 585#8008100000000008
(0.0020) can0 605#0041424344454647
(0.0030) can0 585#8000000001000405)"};

inline constexpr Rule kRepeated{
    .id = "sdo.repeated",
    .text = "the same request is repeated though it is aborted each time",
    .clause = "CiA 301 7.2.4.3.17",
    .severity = Severity::Warning,
    .why = "The code says what would have to change first; repeating it loads the bus and hides the cause.",
    .mend = "Stop after the first abort, and say which object was refused and why.",
    .example = R"((0.0000) can0 605#2B40600080000000
(0.0010) can0 585#8040600000000008
(0.0100) can0 605#2B40600080000000
(0.0110) can0 585#8040600000000008
(0.0200) can0 605#2B40600080000000
(0.0210) can0 585#8040600000000008)"};

inline constexpr Rule kAbortCode{
    .id = "sdo.abort-code",
    .text = "an abort of the master has a code that CiA 301 does not have",
    .clause = "CiA 301 7.2.4.3.17",
    .severity = Severity::Warning,
    .why = "Who reads the log, and servers that count reasons, cannot tell why the transfer has ended.",
    .mend =
        "Use 05040000h for a time-out, 08000000h if nothing else fits; the number is sent with its low byte "
        "first.",
    .example = R"((0.0000) can0 605#4000100000000000
(0.5000) can0 605#8000100005040000)"};

inline constexpr Rule kAbortAlone{
    .id = "sdo.abort-alone",
    .text = "an abort is sent while there is no transfer",
    .clause = "CiA 301 7.2.4.3.17",
    .severity = Severity::Warning,
    .why = "The master believes to be in a transfer that has ended: it counts answers wrongly.",
    .mend = "Abort only what is open; an abort of the server needs no answer.",
    .example = R"((0.0000) can0 605#2B17100064000000
(0.0010) can0 585#6017100000000000
(0.0020) can0 605#8017100000000405)"};

inline constexpr Rule kSize{
    .id = "sdo.size",
    .text = "a download has more or fewer bytes than it has told",
    .clause = "CiA 301 7.2.4.3.3",
    .why = "The server aborts with 06070010h, 06070012h or 06070013h.",
    .mend = "Tell the number of bytes of the value; the last segment says how many of its seven count.",
    .example = R"((0.0000) can0 605#2108100009000000
(0.0010) can0 585#6008100000000000
(0.0020) can0 605#0141424344454647
(0.0030) can0 585#8008100010000706)"};

inline constexpr Rule kSizeUntold{
    .id = "sdo.size-untold",
    .text = "an expedited download does not tell its size",
    .clause = "CiA 301 7.2.4.3.3",
    .severity = Severity::Warning,
    .why = "The server has to take the size of the object: a value of wrong type is not noticed.",
    .mend = "Set the bits e, s and n: 2Fh, 2Bh, 27h or 23h for 1, 2, 3 or 4 bytes.",
    .example = R"((0.0000) can0 605#22171000E8030000
(0.0010) can0 585#6017100000000000)"};

inline constexpr Rule kBlockSequence{
    .id = "sdo.block-sequence",
    .text = "the segments of a block download are not numbered from 1 on",
    .clause = "CiA 301 7.2.4.3.10",
    .why = "The server confirms those before the gap only; a master that does not look at that loses data.",
    .mend = "Number the segments of each block from 1, and repeat from behind the last one that was confirmed.",
    .example = R"((0.0000) can0 605#C208100010000000
(0.0010) can0 585#A008100004000000
(0.0020) can0 605#0141424344454647
(0.0030) can0 605#0341424344454647
(0.0040) can0 605#8441420000000000
(0.0050) can0 585#A201040000000000)"};

inline constexpr Rule kBlockSize{
    .id = "sdo.block-size",
    .text = "a block has more segments than were agreed, or 0 or more than 127 are asked for",
    .clause = "CiA 301 7.2.4.3.9",
    .why = "The server has room for what it has told; it aborts with 05040002h or loses segments.",
    .mend = "Take the number of segments from each confirmation of the server.",
    .example = R"((0.0000) can0 605#A008100000000000
(0.0010) can0 585#8008100002000405)"};

inline constexpr Rule kBlockConfirmation{
    .id = "sdo.block-confirmation",
    .text = "more segments of a block upload are confirmed than the server has sent",
    .clause = "CiA 301 7.2.4.3.14",
    .why = "The server aborts with 05040003h; the number is that of the last segment which came in order.",
    .mend = "Confirm the number of the last segment that followed the one before it.",
    .example = R"((0.0000) can0 605#A008100004000000
(0.0010) can0 585#C20810000A000000
(0.0020) can0 605#A300000000000000
(0.0030) can0 585#0153696D756C6174
(0.0040) can0 585#82656420000000
(0.0050) can0 605#A205040000000000
(0.0060) can0 585#8008100003000405)"};

inline constexpr Rule kBlockCrc{
    .id = "sdo.block-crc",
    .text = "the CRC of a block download is not that of its data",
    .clause = "CiA 301 7.2.4.3.16",
    .why = "The server aborts with 05040004h after all the data has been sent.",
    .mend = "CRC-16 with the polynomial 1021h and the initial value 0, over the data without filling bytes.",
    .example = R"((0.0000) can0 605#C608100002000000
(0.0010) can0 585#A408100004000000
(0.0020) can0 605#8141420000000000
(0.0030) can0 585#A201040000000000
(0.0040) can0 605#D534120000000000
(0.0050) can0 585#8008100004000405)"};

/// All of them, in the order of the docs.
inline constexpr std::array kAll{
    &kOverlap, &kUnaborted,  &kTimeOutShort,  &kLength,    &kCommand,           &kSegmentAlone,
    &kToggle,  &kLeftOpen,   &kAfterAbort,    &kRepeated,  &kAbortCode,         &kAbortAlone,
    &kSize,    &kSizeUntold, &kBlockSequence, &kBlockSize, &kBlockConfirmation, &kBlockCrc};

}  // namespace audit::sdo_rules
