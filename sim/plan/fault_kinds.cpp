#include "sim/plan/fault_kinds.hpp"

#include <algorithm>
#include <array>

namespace sim {
namespace {

constexpr auto kKinds = std::to_array<FaultKind>({
    {FaultAction::BusFault, "bus", "a fault of the bus, see docs/reference/bus-faults.md", FaultKind::Source::Bus},
    {FaultAction::UnitFault, "unit", "a fault of a unit on the wire, see docs/reference/faults.md",
     FaultKind::Source::Unit},
    {FaultAction::PowerCut, "power.cut", "the power of a unit fails"},
    {FaultAction::PowerCutAtWrite, "power.cut-at-write",
     "the power fails at the n-th operation of the disk from now on", FaultKind::Source::None, 1, 12},
    {FaultAction::SwitchOff, "power.off", "a unit is switched off as a service is"},
    {FaultAction::Stall, "program.stall", "the program of a unit does not run"},
    {FaultAction::MasterStall, "master.stall", "the master of a unit does not run"},
    {FaultAction::LinkDown, "link.down", "the interface of a unit is down"},
    {FaultAction::BusOff, "controller.off", "the controller of a unit is off the bus"},
    {FaultAction::ErrorPassive, "controller.passive", "the controller of a unit is error passive"},
    {FaultAction::DiskFull, "disk.full", "the n-th operation of the disk finds no space", FaultKind::Source::None,
     1, 10},
    {FaultAction::DiskError, "disk.error", "the n-th operation of the disk fails", FaultKind::Source::None, 1, 10},
    {FaultAction::ShortWrite, "disk.short", "the n-th operation of the disk, if it is a write, writes half",
     FaultKind::Source::None, 1, 10},
    {FaultAction::DiskUnreadable, "disk.unreadable",
     "the power of a unit fails, and at its next start its first n files cannot be read", FaultKind::Source::None,
     1, 2},
    {FaultAction::Message, "drive.message", "a message n of faults.csv comes on axis 1", FaultKind::Source::None,
     0, 5},
    {FaultAction::Encoder, "drive.encoder", "the encoder of axis 1 has defect n", FaultKind::Source::None, 1, 3},
    {FaultAction::Load, "drive.load", "a torque of n N·m is at the load of axis 1", FaultKind::Source::None, -12,
     12},
    {FaultAction::LineVoltage, "supply.line", "the line has n V", FaultKind::Source::None, 0, 380},
});

}  // namespace

std::span<const FaultKind> fault_kinds() noexcept {
  return kKinds;
}

const FaultKind* find_fault_kind(std::string_view name) noexcept {
  const auto* const found = std::ranges::find(kKinds, name, &FaultKind::name);
  return found != kKinds.end() ? found : nullptr;
}

}  // namespace sim
