#pragma once

#include <array>
#include <span>

#include "injection/language/fault.hpp"

namespace injection {
namespace unit_kind {

inline constexpr ArgumentUse kObject{Argument::Object, "every object"};
inline constexpr ArgumentUse kSubIndex{Argument::SubIndex, "every sub-index"};
inline constexpr ArgumentUse kServer{Argument::Server, "every server"};
inline constexpr ArgumentUse kStep{Argument::Step, "every frame"};
inline constexpr ArgumentUse kPdo{Argument::Pdo, "every PDO"};
inline constexpr ArgumentUse kAxis{Argument::Axis, "every axis"};

inline constexpr std::array kTransfer{kObject, kSubIndex, kServer, kStep};
inline constexpr std::array kLateTransfer{ArgumentUse{Argument::DelayMs, ""}, kObject, kSubIndex, kServer, kStep};
inline constexpr std::array kAbort{ArgumentUse{Argument::Code, ""}, kObject, kSubIndex, kServer, kStep};
inline constexpr std::array kOnPdo{kPdo};
inline constexpr std::array kLatePdo{ArgumentUse{Argument::DelayMs, ""}, kPdo};
inline constexpr std::array kShortPdo{ArgumentUse{Argument::Length, "one less"}, kPdo};
inline constexpr std::array kSwappedPdo{ArgumentUse{Argument::First, "1"}, ArgumentUse{Argument::Second, "2"},
                                        kPdo};
inline constexpr std::array kLate{ArgumentUse{Argument::DelayMs, ""}};
inline constexpr std::array kNmtState{ArgumentUse{Argument::NmtState, ""}};
inline constexpr std::array kStorm{ArgumentUse{Argument::Code, "0xFF00"}, ArgumentUse{Argument::PeriodMs, "10"}};
inline constexpr std::array kOnAxis{kAxis};
inline constexpr std::array kStatusBit{ArgumentUse{Argument::Bit, ""}, ArgumentUse{Argument::Value, ""}, kAxis};
inline constexpr std::array kNever{ArgumentUse{Argument::DriveState, ""}, kAxis};
inline constexpr std::array kReset{ArgumentUse{Argument::DelayMs, "at once"}};
inline constexpr std::array kNodeId{ArgumentUse{Argument::NodeId, ""}};
inline constexpr std::span<const ArgumentUse> kNothing{};

inline constexpr auto kEach = Nature::Each;
inline constexpr auto kMoment = Nature::Moment;
inline constexpr auto kLasting = Nature::Lasting;
inline constexpr auto kRequest = EventKind::SdoRequest;
inline constexpr auto kResponse = EventKind::SdoResponse;
inline constexpr auto kCycle = EventKind::Cycle;

inline constexpr std::array kRows{
    Kind{"sdo.deaf", "a request is not heard", kEach, kRequest, kTransfer},
    Kind{"sdo.silent", "a request is carried out and not answered", kEach, kResponse, kTransfer},
    Kind{"sdo.late", "the answer comes late", kEach, kResponse, kLateTransfer},
    Kind{"sdo.twice", "the answer comes twice", kEach, kResponse, kTransfer},
    Kind{"sdo.abort", "a request is answered with an abort and not carried out", kEach, kRequest, kAbort},
    Kind{"sdo.toggle", "the toggle bit of a segment, or of its answer, is wrong", kEach, kResponse, kTransfer},
    Kind{"sdo.multiplexor", "the answer names the index above that of the transfer", kEach, kResponse, kTransfer},
    Kind{"sdo.length", "an upload announces one byte too many, or of four bytes one too few", kEach, kResponse,
         kTransfer},
    Kind{"sdo.crc",
         "the CRC of a block transfer is wrong: that of an upload as it is sent, that of a download as it "
         "is heard",
         kEach, EventKind::Frame, kTransfer},
    Kind{"sdo.sequence",
         "a segment of a block upload has the number of another; the confirmation of a block "
         "download names another",
         kEach, kResponse, kTransfer},
    Kind{"tpdo.swallow", "a TPDO is not sent", kEach, EventKind::Tpdo, kOnPdo},
    Kind{"tpdo.late", "a TPDO is sent late", kEach, EventKind::Tpdo, kLatePdo},
    Kind{"tpdo.twice", "a TPDO is sent twice", kEach, EventKind::Tpdo, kOnPdo},
    Kind{"tpdo.short", "a TPDO has too few bytes", kEach, EventKind::Tpdo, kShortPdo},
    Kind{"tpdo.frozen", "a TPDO repeats the values of the first one that was hit", kEach, EventKind::Tpdo, kOnPdo},
    Kind{"tpdo.swap", "two mapped values of a TPDO have changed places", kEach, EventKind::Tpdo, kSwappedPdo},
    Kind{"rpdo.deaf", "an RPDO is not heard", kEach, EventKind::Rpdo, kOnPdo},
    Kind{"sync.deaf", "SYNC is not heard", kEach, EventKind::Sync, kNothing},
    Kind{"nmt.deaf", "an NMT command is not heard", kEach, EventKind::Nmt, kNothing},
    Kind{"heartbeat.gap", "a heartbeat is not sent", kEach, EventKind::Heartbeat, kNothing},
    Kind{"heartbeat.late", "a heartbeat is sent late", kEach, EventKind::Heartbeat, kLate},
    Kind{"heartbeat.state", "a heartbeat tells another NMT state", kEach, EventKind::Heartbeat, kNmtState},
    Kind{"guard.silent", "node guarding is not answered", kEach, EventKind::Guard, kNothing},
    Kind{"guard.toggle", "the toggle bit of the answer to node guarding is wrong", kEach, EventKind::Guard,
         kNothing},
    Kind{"boot-up.missing", "the boot-up message is not sent", kEach, EventKind::BootUp, kNothing},
    Kind{"boot-up.late", "the boot-up message is sent late", kEach, EventKind::BootUp, kLate},
    Kind{"boot-up.twice", "the boot-up message is sent twice", kEach, EventKind::BootUp, kNothing},
    Kind{"emcy.missing", "an emergency message is not sent", kEach, EventKind::Emcy, kNothing},
    Kind{"emcy.never-cleared", "an emergency message that tells the end of errors is not sent", kEach,
         EventKind::Emcy, kNothing},
    Kind{"emcy.storm", "emergency messages without end", kLasting, kCycle, kStorm},
    Kind{"drive.frozen", "the objects of actual values keep the values of the first cycle that was hit", kEach,
         kCycle, kOnAxis},
    Kind{"drive.ignores-controlword", "the controlword of the first cycle that was hit stays in force", kEach,
         kCycle, kOnAxis},
    Kind{"drive.status-bit", "a bit of the statusword is stuck", kEach, kCycle, kStatusBit},
    Kind{"drive.never", "the drive never reaches a state: the command to it is not heard", kEach, kCycle, kNever},
    Kind{"node.reset", "brown-out: the unit is switched off, and on again after the delay", kMoment, kCycle,
         kReset},
    Kind{"node.id", "the unit uses the identifiers of another node in the pre-defined connection set", kLasting,
         kCycle, kNodeId},
    Kind{"node.gone", "the unit neither sends nor hears anything", kLasting, kCycle, kNothing},
    Kind{"controller.passive", "the CAN controller is error passive", kLasting, kCycle, kNothing},
    Kind{"controller.off", "the CAN controller is off the bus", kLasting, kCycle, kNothing},
};

}  // namespace unit_kind

/// The kinds of faults of a unit, a row a kind. What they do is injection/wire/kinds.cpp.
constexpr std::span<const Kind> unit_kinds() noexcept {
  return unit_kind::kRows;
}

}  // namespace injection
