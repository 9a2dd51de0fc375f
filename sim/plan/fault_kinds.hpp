#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace sim {

/// What a fault of a world does. See world/fault_actions.cpp.
enum class FaultAction : std::uint8_t {
  BusFault,
  UnitFault,
  PowerCut,
  PowerCutAtWrite,
  SwitchOff,
  Stall,
  MasterStall,
  LinkDown,
  BusOff,
  ErrorPassive,
  DiskFull,
  DiskError,
  ShortWrite,
  DiskUnreadable,
  Message,
  Encoder,
  Load,
  LineVoltage,
};

/// A kind of fault of a world.
struct FaultKind {
  /// Whose words it has, if it is one on the wire.
  enum class Source : std::uint8_t { None, Bus, Unit };

  FaultAction action;
  std::string_view name;
  std::string_view summary;
  Source source = Source::None;
  std::int64_t low = 0, high = 0;  ///< what its number may be
};

/// All of them.
std::span<const FaultKind> fault_kinds() noexcept;
/// That called @p name; nullptr if there is none.
const FaultKind* find_fault_kind(std::string_view name) noexcept;

}  // namespace sim
