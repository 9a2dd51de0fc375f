#include "sim/world/fault_actions.hpp"

#include <algorithm>
#include <array>

#include "injection/json/fault_json.hpp"
#include "injection/kinds/unit_kinds.hpp"
#include "sim/plan/fault_kinds.hpp"
#include "sim/world/world.hpp"

namespace sim {
namespace {

constexpr std::array<std::uint16_t, 6> kMessages{7011, 7900, 30002, 30003, 30005, 31100};
constexpr double kLineVoltage = 400.0;

/// What a disk does that fails at an operation.
struct DiskAction {
  FaultAction action;
  DiskFailure failure;
};
constexpr std::array kDiskActions{
    DiskAction{FaultAction::PowerCutAtWrite, DiskFailure::PowerCut},
    DiskAction{FaultAction::DiskFull, DiskFailure::NoSpace},
    DiskAction{FaultAction::DiskError, DiskFailure::InputError},
    DiskAction{FaultAction::ShortWrite, DiskFailure::ShortWrite},
};

/// On axis 1, if the unit is on.
template <class Act>
void at_drive(World& world, const FaultPlan& fault, Act act) {
  SimulatedUnit& unit = world.unit(fault.unit);
  if (!unit.is_on()) return;
  act(unit.instance(), world.now());
  unit.refresh();
}

void begin_unit_fault(World& world, const FaultPlan& fault) {
  SimulatedUnit& unit = world.unit(fault.unit);
  const auto said = injection::read_fault_words(fault.words, injection::unit_kinds());
  if (!said || !unit.is_on()) return;
  static_cast<void>(unit.instance().faults().add(*said));  // it may have no such PDO
  unit.refresh();
}

void begin_at_drive(World& world, const FaultPlan& fault, FaultAction action) {
  at_drive(world, fault, [&](axisd::Instance& instance, canopen::TimePoint now) {
    device::Device& device = instance.device();
    if (action == FaultAction::Message) {
      const auto number = kMessages[static_cast<std::size_t>(fault.number) % kMessages.size()];
      static_cast<void>(device.raise(1, number, 0, now));  // not every kind of drive has each
    } else if (action == FaultAction::Encoder) {
      device.fail_encoder(1, static_cast<motor::EncoderDefect>(fault.number), now);
    } else if (action == FaultAction::Load) {
      instance.set_load_torque(1, static_cast<double>(fault.number), motor::LoadTorqueType::Constant, now);
    } else {
      device.set_line_voltage(static_cast<double>(fault.number), now);
    }
  });
}

void end_at_drive(World& world, const FaultPlan& fault, FaultAction action) {
  at_drive(world, fault, [&](axisd::Instance& instance, canopen::TimePoint now) {
    if (action == FaultAction::Encoder) instance.device().fail_encoder(1, motor::EncoderDefect::None, now);
    if (action == FaultAction::Load) instance.set_load_torque(1, 0.0, motor::LoadTorqueType::Constant, now);
    if (action == FaultAction::LineVoltage) instance.device().set_line_voltage(kLineVoltage, now);
  });
}

}  // namespace

void begin_fault(World& world, const FaultPlan& fault) {
  const FaultAction action = find_fault_kind(fault.kind)->action;
  SimulatedUnit& unit = world.unit(fault.unit);
  const auto nth = static_cast<std::uint64_t>(fault.number);
  const canopen::TimePoint end = world.now() + fault.lasting;
  const auto* const at_disk = std::ranges::find(kDiskActions, action, &DiskAction::action);
  if (at_disk != kDiskActions.end()) return unit.disk().fail(at_disk->failure, nth);
  switch (action) {
    case FaultAction::BusFault:
      static_cast<void>(world.bus_faults().inject(fault.words, world.now()));
      return;
    case FaultAction::UnitFault:
      return begin_unit_fault(world, fault);
    case FaultAction::PowerCut:
      return unit.cut_power();
    case FaultAction::SwitchOff:
      return unit.switch_off();
    case FaultAction::Stall:
      return unit.stall(end);
    case FaultAction::MasterStall:
      return world.leader(fault.unit).stall(end);
    case FaultAction::LinkDown:
      return unit.set_link(false);
    case FaultAction::BusOff:
      return unit.set_error_state(bus::ErrorState::BusOff);
    case FaultAction::ErrorPassive:
      return unit.set_error_state(bus::ErrorState::Passive);
    case FaultAction::DiskUnreadable:
      unit.cut_power();
      return unit.disk().fail_reads(static_cast<unsigned>(nth));
    default:
      return begin_at_drive(world, fault, action);
  }
}

void end_fault(World& world, const FaultPlan& fault) {
  const FaultAction action = find_fault_kind(fault.kind)->action;
  SimulatedUnit& unit = world.unit(fault.unit);
  switch (action) {
    case FaultAction::PowerCut:
    case FaultAction::SwitchOff:
    case FaultAction::DiskUnreadable:
      return world.switch_on(fault.unit);
    case FaultAction::PowerCutAtWrite:
      unit.disk().mend();
      return world.switch_on(fault.unit);
    case FaultAction::DiskFull:
    case FaultAction::DiskError:
    case FaultAction::ShortWrite:
      return unit.disk().mend();
    case FaultAction::LinkDown:
      return unit.set_link(true);
    case FaultAction::BusOff:
    case FaultAction::ErrorPassive:
      return unit.set_error_state(bus::ErrorState::Active);
    default:
      return end_at_drive(world, fault, action);
  }
}

}  // namespace sim
