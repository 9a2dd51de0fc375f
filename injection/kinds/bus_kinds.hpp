#pragma once

#include <array>
#include <span>

#include "injection/language/fault.hpp"

namespace injection {
namespace bus_kind {

inline constexpr ArgumentUse kId{Argument::Id, "every frame"};
inline constexpr ArgumentUse kMask{Argument::Mask, "all bits"};

inline constexpr std::array kOfFrames{kId, kMask};
inline constexpr std::array kOfDelay{kId, kMask, ArgumentUse{Argument::DelayMs, ""}};
inline constexpr std::array kOfCorrupt{kId, kMask, ArgumentUse{Argument::Byte, "0"},
                                       ArgumentUse{Argument::Bits, "0x1"}};
inline constexpr std::array kOfCut{ArgumentUse{Argument::Members, ""}, kId, kMask};
inline constexpr std::array kOfBabble{ArgumentUse{Argument::Id, ""}, ArgumentUse{Argument::Length, "8"},
                                      ArgumentUse{Argument::PeriodUs, "as fast as the bus takes them"}};
inline constexpr std::array kOfErrorFrames{ArgumentUse{Argument::ErrorClass, ""},
                                           ArgumentUse{Argument::PeriodMs, "100"}};
inline constexpr std::array kOfBitRate{ArgumentUse{Argument::BitRate, ""}};
inline constexpr std::array kOfLoad{ArgumentUse{Argument::Percent, ""}};

inline constexpr auto kRows = std::to_array<Kind>({
    {"bus.drop", "a frame is on the wire and nobody hears it but its sender", Nature::Each, EventKind::Frame,
     kOfFrames},
    {"bus.delay", "a frame is heard later", Nature::Each, EventKind::Frame, kOfDelay},
    {"bus.duplicate", "a frame is heard twice, one right behind the other", Nature::Each, EventKind::Frame,
     kOfFrames},
    {"bus.corrupt", "a frame is heard with other data, which no check sum has found", Nature::Each,
     EventKind::Frame, kOfCorrupt},
    {"bus.cut", "the line is cut: some members on one side, everything else on the other", Nature::Lasting,
     EventKind::Frame, kOfCut},
    {"bus.babble", "a node that nobody asked sends without end", Nature::Each, EventKind::Frame, kOfBabble},
    {"bus.error-frames", "the controllers tell an error, to those who asked for error frames", Nature::Each,
     EventKind::Frame, kOfErrorFrames},
    {"bus.bit-rate", "the bus runs at another bit rate", Nature::Lasting, EventKind::Frame, kOfBitRate},
    {"bus.load", "frames of identifier 7FFh fill the bus up to a share of its time", Nature::Each,
     EventKind::Frame, kOfLoad},
});

}  // namespace bus_kind

/// The kinds of faults of a user-space bus, a row a kind. What they do is can/hub/faults/effects.cpp.
constexpr std::span<const Kind> bus_kinds() noexcept {
  return bus_kind::kRows;
}

}  // namespace injection
