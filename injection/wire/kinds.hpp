#pragma once

#include <cstdint>

#include "injection/language/fault.hpp"
#include "injection/wire/passing.hpp"

namespace injection {

/// What a lasting or momentary fault does to the unit.
enum class Doing : std::uint8_t { None, Gone, Reset, NodeId, Passive, BusOff, Storm };

/// What a kind of fault of a unit acts on, and how. The row of its table (kinds.cpp).
struct WireKind {
  /// Which of the frames that are its own (Kind::own) it can act on; nullptr: it acts on no frame.
  bool (*fits)(const Passing& passing, const Fault& fault) noexcept = nullptr;
  /// What it makes of one that is hit.
  void (*act)(Passing& passing, Loaded& loaded, const device::Device& device) noexcept = nullptr;
  Doing doing = Doing::None;
};

/// What @p kind, one of unit_kinds(), does.
const WireKind& wire_kind(const Kind& kind) noexcept;

/// Bits of the controlword that keep a drive from a state (CiA 402, table of the commands).
struct Hindrance {
  std::uint16_t cleared = 0;
  std::uint16_t set = 0;
};
/// That of @p state, a value of Argument::DriveState.
Hindrance hindrance_of(std::uint32_t state) noexcept;

}  // namespace injection
