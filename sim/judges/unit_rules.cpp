#include "sim/judges/unit_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "sim/unit/simulated_unit.hpp"

namespace sim {
namespace {

double stored_in(const SimulatedUnit& unit) noexcept {
  const drive::DriveUnit& drives = unit.instance().device().unit();
  double sum = drives.dc_link().stored();
  for (const drive::Axis& axis : drives.axes()) sum += axis.drive_train().stored().sum();
  return sum;
}

/// The faults that are active in @p device: ", F08701 of drive object 2".
std::string faults_text(const device::Device& device) {
  std::string text;
  device.unit().for_each_object([&](const drive::DriveObject& object) {
    for (const drive::FaultEntry& fault : object.messages().faults())
      text += fmt::format(", F{:05} of drive object {}", fault.row->number, object.number());
  });
  return text;
}

/// Above the speed at which its drive switches off, whatever turns it.
bool is_too_fast(const drive::Axis& axis) noexcept {
  return axis.block<drive::SpeedMessages>().has_overspeed();
}

/// What the supply has brought less what it has taken (J).
double supplied_to(const SimulatedUnit& unit) noexcept {
  const motor::SupplyEnergies& supply = unit.instance().device().unit().dc_link().energies();
  return supply.from_line + supply.missing - supply.to_line - supply.infeed_losses - supply.chopper;
}

}  // namespace

void StoredSets::on_power(const SimulatedUnit& unit, bool on) {
  SeenSets& sets = seen(unit);
  const auto& given = unit.disk().contents_given(unit.parameter_file());
  if (!on) return;
  const auto found = unit.disk().fingerprint(unit.parameter_file());
  const auto newer = std::span{given}.subspan(sets.begun);
  const bool is_new = found && std::ranges::find(newer, *found) != newer.end();
  if (found != sets.kept && !is_new)
    break_rule(unit.number(), canopen::TimePoint{},
               found ? "a set that was never saved as a whole" : "the set that was saved is lost");
  sets = {found, given.size()};
}

void StoredSets::on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) {
  if (event.kind != record::EventKind::Store || !event.active) return;
  seen(unit) = {unit.disk().fingerprint(unit.parameter_file()),
                unit.disk().contents_given(unit.parameter_file()).size()};
}

void EnabledAgain::on_calm(canopen::TimePoint now) {
  for (AwaitedAxes& awaited : awaited_) awaited.since = now;
}

void EnabledAgain::on_full_bus(canopen::Duration lasting) {
  for (AwaitedAxes& awaited : awaited_)
    if (awaited.since != canopen::kNever) awaited.since += lasting;
}

void EnabledAgain::on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t) {
  auto& [since, missing] = awaited_[unit.number()];
  if (now < since) return;
  const device::Device& device = unit.instance().device();
  const auto axes = device.unit().axes();
  if (!missing) missing = (1U << axes.size()) - 1;
  if (*missing == 0) return;
  for (unsigned axis = 1; axis <= axes.size(); ++axis) {
    const std::uint32_t bit = 1U << (axis - 1);
    if (device.view(axis).state == drive::State::OperationEnabled) *missing &= ~bit;
    if ((*missing & bit) != 0 && is_too_fast(axes[axis - 1])) since = now;
  }
  if (*missing == 0 || now - since <= kLongest) return;
  const auto first = static_cast<unsigned>(std::countr_zero(*missing)) + 1;
  break_rule(unit.number(), now,
             fmt::format("axis {} is in {}{}", first, name_of(device.view(first).state), faults_text(device)));
}

/// A unit that has no turn any more is missed too.
void EnabledAgain::on_end(canopen::TimePoint now) {
  for (std::size_t unit = 0; unit < awaited_.size(); ++unit) {
    const auto& [since, missing] = awaited_[unit];
    if (since != canopen::kNever && now - since > kLongest && (!missing || *missing != 0))
      break_rule(unit, now, "not all axes have come to Operation enabled");
  }
}

void NoAllocation::on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) {
  if (allocated != 0) break_rule(unit.number(), now, fmt::format("{} allocations in one turn", allocated));
}

void EnergyBalance::on_step(const SimulatedUnit& unit) {
  SeenEnergy& sums = seen(unit);
  if (!sums.has_begun) return;
  const auto axes = unit.instance().device().unit().axes();
  sums.steps.resize(axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const motor::DriveTrain& train = axes[i].drive_train();
    const long steps = std::lround(train.sums().steps);
    if (std::exchange(sums.steps[i], steps) == steps)
      continue;  // it rests, and its energies are those of its last step
    const motor::PlantEnergies& went = train.energies();
    const double spent = went.copper + went.iron + went.friction + went.load + train.inverter_losses();
    sums.spent += spent;
    sums.turned_over += std::abs(spent);
  }
}

void EnergyBalance::on_cycle(const SimulatedUnit& unit, canopen::TimePoint now) {
  SeenEnergy& sums = seen(unit);
  if (!sums.has_begun) {
    sums = {.has_begun = true, .start = stored_in(unit), .before = supplied_to(unit)};
    return;
  }
  constexpr double kShare = 2e-3, kLeast = 0.5;  // of all that passed; J
  const double missing = supplied_to(unit) - sums.before - sums.spent - (stored_in(unit) - sums.start);
  const double passed = sums.turned_over + unit.instance().device().unit().dc_link().energies().from_line;
  if (std::abs(missing) <= kLeast + kShare * passed) return;
  break_rule(unit.number(), now, fmt::format("{:.3f} J of {:.3f} J are nowhere", missing, passed));
}

}  // namespace sim
