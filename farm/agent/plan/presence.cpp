#include "farm/agent/plan/presence.hpp"

#include <algorithm>

namespace farm::agent {
namespace {

using canopen::TimePoint;

/// What nobody asks for any more.
constexpr std::chrono::seconds kKept{60};

bool is_recent(TimePoint heard, TimePoint now) noexcept {
  return now - heard < kPatience;
}

template <class Map>
void forget_old(Map& told, TimePoint now) {
  std::erase_if(told, [now](const auto& each) { return now - each.second.heard > kKept; });
}

}  // namespace

void Presence::on_agent(const AgentBeat& beat, TimePoint now) {
  ByInstance<Agent>& known = agents_[beat.host];
  forget_old(known, now);
  known[beat.instance] = {beat, now};
}

void Presence::on_door(const DoorBeat& beat, TimePoint now) {
  ByInstance<Door>& known = doors_[beat.host];
  forget_old(known, now);
  Door& door = known[beat.instance];
  door.heard = now;
  door.parts.resize(beat.parts);
  std::set<UnitName>& part = door.parts[beat.part - 1];
  part.clear();
  std::erase_if(door.said, [now](const auto& each) { return now - each.second > kKept; });
  for (const DoorUnit& unit : beat.units) {
    part.insert(unit.name);
    door.said[unit.name] = now;
  }
}

const Presence::Agent* Presence::agent_of(const std::string& host, TimePoint now) const {
  const auto known = agents_.find(host);
  if (known == agents_.end()) return nullptr;
  for (const auto& [instance, agent] : known->second)
    if (is_recent(agent.heard, now)) return &agent;
  return nullptr;
}

std::vector<AgentBeat> Presence::agents(TimePoint now) const {
  std::vector<AgentBeat> found;
  for (const auto& [host, known] : agents_)
    if (const Agent* const agent = agent_of(host, now)) found.push_back(agent->beat);
  return found;
}

bool Presence::has_agent(const std::string& host, TimePoint now) const {
  return agent_of(host, now) != nullptr;
}

std::optional<std::uint64_t> Presence::rival(const std::string& host, std::uint64_t instance,
                                             TimePoint now) const {
  const Agent* const agent = agent_of(host, now);
  if (agent == nullptr || agent->beat.instance >= instance) return std::nullopt;
  return agent->beat.instance;
}

bool Presence::is_silent(TimePoint heard, TimePoint now) const {
  return !is_recent(std::max(heard, listening_since_), now);
}

bool Presence::is_lost(const std::string& host, const UnitName& unit, TimePoint now) const {
  TimePoint sign{};
  if (const auto agents = agents_.find(host); agents != agents_.end())
    for (const auto& [instance, agent] : agents->second) sign = std::max(sign, agent.heard);
  if (const auto doors = doors_.find(host); doors != doors_.end())
    for (const auto& [instance, door] : doors->second)
      if (const auto said = door.said.find(unit); said != door.said.end()) sign = std::max(sign, said->second);
  return is_silent(sign, now);
}

std::optional<std::string> Presence::host_with(const UnitName& unit, TimePoint now) const {
  for (const auto& [host, known] : doors_)
    for (const auto& [instance, door] : known)
      if (is_recent(door.heard, now) &&
          std::ranges::any_of(door.parts, [&unit](const auto& part) { return part.contains(unit); }))
        return host;
  return std::nullopt;
}

TimePoint Presence::next_silence(TimePoint now) const {
  TimePoint next = canopen::kNever;
  const auto count = [&](TimePoint heard) {
    if (heard + kPatience > now) next = std::min(next, heard + kPatience);
  };
  count(listening_since_);
  for (const auto& [host, known] : agents_)
    for (const auto& [instance, agent] : known) count(agent.heard);
  for (const auto& [host, known] : doors_)
    for (const auto& [instance, door] : known) count(door.heard);
  return next;
}

}  // namespace farm::agent
