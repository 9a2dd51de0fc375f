#include "sim/program/report.hpp"

#include <chrono>

#include <fmt/format.h>

#include "sim/judges/table.hpp"
#include "sim/plan/fault_kinds.hpp"

namespace sim {
namespace {

double seconds_since_begin(canopen::TimePoint time) {
  return std::chrono::duration<double>(time - ToldTime::kBegin).count();
}

}  // namespace

Outcome run_world(const WorldPlan& plan, const axisd::Log& log, std::ostream* frames) {
  World world{plan, log};
  if (frames != nullptr) world.wire().write_to(*frames);
  Outcome outcome;
  outcome.breach = world.run();
  if (outcome.breach) outcome.node_id = world.unit(outcome.breach->unit).node_id();
  outcome.counts = world.counts();
  outcome.digest = world.wire().digest();
  outcome.seconds = world.seconds();
  for (const WireRecorder::Heard& heard : world.wire().last())
    outcome.last_frames += "  " + log_line(seconds_since_begin(heard.time), heard.frame) + "\n";
  return outcome;
}

std::string list_text() {
  std::string text;
  for (const Invariant& each : invariants()) text += fmt::format("{:<22}{}\n", each.name, each.text);
  text += "\n";
  for (const FaultKind& each : fault_kinds()) text += fmt::format("{:<22}{}\n", each.name, each.summary);
  return text;
}

std::string breach_text(const WorldPlan& plan, const Outcome& outcome, std::string_view again) {
  const Breach& breach = *outcome.breach;
  return fmt::format("{}seed {}: {}\n  broken: {} at {:.6f} s, node {}: {}\n  again:  axisd-sim {}\n",
                     outcome.last_frames, plan.seed, summary_of(plan), breach.rule,
                     seconds_since_begin(breach.time), outcome.node_id, breach.text, again);
}

void Sums::add(const WorldPlan& plan, const Outcome& outcome) noexcept {
  ++worlds;
  if (outcome.breach) ++broken;
  units += plan.units.size();
  faults += plan.faults.size();
  frames += outcome.counts.frames;
  turns += outcome.counts.turns;
  power_ons += outcome.counts.power_ons;
  disk_operations += outcome.counts.disk_operations;
  seconds += outcome.seconds;
  full_bus_seconds += outcome.counts.full_bus;
}

std::string text_of(const Sums& sums) {
  return fmt::format(
      "{} worlds of {:.0f} s in all: {} units, {} faults, {} power-ons, {} frames, {} turns, {} operations of "
      "disks; bus full for {:.0f} s; broken {}\n",
      sums.worlds, sums.seconds, sums.units, sums.faults, sums.power_ons, sums.frames, sums.turns,
      sums.disk_operations, sums.full_bus_seconds, sums.broken);
}

nlohmann::json json_of(const Sums& sums) {
  return {{"worlds", sums.worlds},
          {"broken", sums.broken},
          {"seconds", sums.seconds},
          {"units", sums.units},
          {"faults", sums.faults},
          {"power_ons", sums.power_ons},
          {"frames", sums.frames},
          {"turns", sums.turns},
          {"disk_operations", sums.disk_operations},
          {"full_bus_seconds", sums.full_bus_seconds}};
}

}  // namespace sim
