// What the plan makes of units that have no place, and how places are written.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "farm/agent/plan/plan.hpp"

namespace farm::agent {
namespace {

using canopen::TimePoint;

/// @p unit as one that may go to those of @p agents that take it.
OpenUnit open_unit(const UnitName& unit, const Wish& wish, const std::vector<AgentBeat>& agents) {
  OpenUnit open{.name = unit, .order = wish.revision, .hosts = {}};
  for (const AgentBeat& agent : agents) {
    const bool takes_bus = agent.buses.empty() || std::ranges::find(agent.buses, unit.bus) != agent.buses.end();
    if (takes_bus && !agent.draining && wish.content.allows(agent.host)) open.hosts.insert(agent.host);
  }
  return open;
}

std::vector<Candidate> candidates_of(const std::vector<AgentBeat>& agents) {
  std::vector<Candidate> candidates;
  for (const AgentBeat& agent : agents) candidates.push_back({agent.host, agent.capacity, 0});
  return candidates;
}

}  // namespace

/// That of a host which is lost is open too; that of this one is not, whoever had it.
bool Plan::is_open(const UnitName& unit, const UnitRecord& record, TimePoint now) const {
  if (!record.known || record.known->place.host.empty()) return true;
  return !record.is_at(self_.host) && presence_.is_lost(record.known->place.host, unit, now);
}

void Plan::place_open_units(const Situation& at) {
  const std::vector<AgentBeat> agents = presence_.agents(at.now);
  std::vector<Candidate> candidates = candidates_of(agents);
  std::vector<OpenUnit> open;
  std::vector<UnitName> unplaced;
  for (const auto& [unit, record] : ledger_.units()) {
    if (!is_open(unit, record, at.now)) {
      const auto host = std::ranges::find(candidates, record.known->place.host, &Candidate::host);
      if (host != candidates.end()) ++host->load;
      continue;
    }
    unplaced.push_back(unit);
    if (!record.wish || record.there_since != canopen::kNever || record.process.is_wanted()) continue;
    if (OpenUnit one = open_unit(unit, *record.wish, agents); !one.hosts.empty()) open.push_back(std::move(one));
  }
  placement_.plan(std::move(open), std::move(candidates), at.now);
  for (const UnitName& unit : unplaced) take_open_unit(unit, ledger_.units().at(unit), at);
}

void Plan::take_open_unit(const UnitName& unit, UnitRecord& record, const Situation& at) {
  if (record.process.is_wanted()) return claim(unit, record, at);
  const std::string& turn = placement_.host_for(unit);
  if (turn == self_.host) {
    if (record.process.is_off()) claim(unit, record, at);
    return;
  }
  const std::string problem = turn.empty() ? problem_of_open(unit, record, at.now) : std::string{};
  const Place& last = record.known ? record.known->place : Place{};
  if (!turn.empty() || !last.host.empty() || last.problem == problem || !is_speaker(unit, at.now)) return;
  tell_problem(unit, record, problem);
  release(unit, record, at, problem);
}

/// One line for all agents about a unit that nobody has: from that where it is, else from the first by its name.
bool Plan::is_speaker(const UnitName& unit, TimePoint now) const {
  const auto host = presence_.host_with(unit, now);
  if (host && presence_.has_agent(*host, now)) return *host == self_.host;
  const auto agents = presence_.agents(now);
  return !agents.empty() && agents.front().host == self_.host;
}

std::string Plan::problem_of_open(const UnitName& unit, const UnitRecord& record, TimePoint now) const {
  if (!record.wish) return {};
  if (record.there_since == canopen::kNever) return "no host that it may be on is there";
  return problem_of_foreign(unit, record, now);
}

void Plan::claim(const UnitName& unit, UnitRecord& record, const Situation& at) {
  write(unit, record, at,
        Place{.host = self_.host,
              .instance = self_.instance,
              .term = std::max(record.last_term(), record.term) + 1,
              .restarts = record.process.restarts(),
              .problem = {}});
}

/// The key stays, so that terms go on.
void Plan::release(const UnitName& unit, UnitRecord& record, const Situation& at, std::string problem) {
  write(
      unit, record, at,
      Place{.host = {}, .instance = 0, .term = record.last_term(), .restarts = 0, .problem = std::move(problem)});
}

void Plan::write(const UnitName& unit, UnitRecord& record, const Situation& at, Place place) {
  wake_at(record.write_again, at.now);
  if (record.is_being_written || at.now < record.write_again) return;
  record.is_being_written = true;
  orders_.places.push_back({unit, std::move(place), record.known ? record.known->revision : 0});
}

}  // namespace farm::agent
