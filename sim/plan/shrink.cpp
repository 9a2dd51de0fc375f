#include "sim/plan/shrink.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace sim {
namespace {

using Fails = std::function<bool(const WorldPlan&)>;

std::optional<WorldPlan> without_fault(const WorldPlan& plan, std::size_t number) {
  WorldPlan less = plan;
  less.faults.erase(less.faults.begin() + static_cast<std::ptrdiff_t>(number));
  return less;
}

/// Its faults go with it; one unit stays.
std::optional<WorldPlan> without_unit(const WorldPlan& plan, std::size_t number) {
  if (plan.units.size() == 1) return std::nullopt;
  WorldPlan less = plan;
  less.units.erase(less.units.begin() + static_cast<std::ptrdiff_t>(number));
  std::erase_if(less.faults, [&](const FaultPlan& fault) { return fault.unit == number; });
  for (FaultPlan& fault : less.faults)
    if (fault.unit > number) --fault.unit;
  return less;
}

std::optional<WorldPlan> with_less_axes(const WorldPlan& plan, std::size_t number) {
  WorldPlan less = plan;
  auto& axes = less.units[number].configuration["axes"];
  if (axes.size() < 2) return std::nullopt;
  axes.erase(axes.size() - 1);
  return less;
}

/// Of a master.
constexpr std::array kHabits{&UnitPlan::is_intruded, &UnitPlan::is_guarded, &UnitPlan::restarts, &UnitPlan::stores,
                             &UnitPlan::by_rpdo};

std::optional<WorldPlan> with_calmer_master(const WorldPlan& plan, std::size_t number, std::size_t habit) {
  if (!(plan.units[number].*kHabits[habit])) return std::nullopt;
  WorldPlan less = plan;
  less.units[number].*kHabits[habit] = false;
  return less;
}

std::optional<WorldPlan> without_sync(const WorldPlan& plan) {
  if (plan.sync == canopen::Duration{0}) return std::nullopt;
  WorldPlan less = plan;
  less.sync = canopen::Duration{0};
  return less;
}

/// True if @p smaller is there and fails too: then it takes the place of @p plan.
bool take(WorldPlan& plan, std::optional<WorldPlan> smaller, const Fails& fails) {
  if (!smaller || !fails(*smaller)) return false;
  plan = *std::move(smaller);
  return true;
}

/// One round over all that can be left out.
bool shrink_once(WorldPlan& plan, const Fails& fails) {
  bool is_smaller = take(plan, without_sync(plan), fails);
  for (std::size_t i = plan.units.size(); i-- > 0;)
    if (i < plan.units.size()) is_smaller |= take(plan, without_unit(plan, i), fails);
  for (std::size_t i = plan.faults.size(); i-- > 0;) is_smaller |= take(plan, without_fault(plan, i), fails);
  for (std::size_t i = 0; i < plan.units.size(); ++i) {
    while (take(plan, with_less_axes(plan, i), fails)) is_smaller = true;
    for (std::size_t habit = 0; habit < kHabits.size(); ++habit)
      is_smaller |= take(plan, with_calmer_master(plan, i, habit), fails);
  }
  return is_smaller;
}

}  // namespace

WorldPlan shrink(WorldPlan plan, const Fails& fails) {
  while (shrink_once(plan, fails)) {
  }
  return plan;
}

}  // namespace sim
