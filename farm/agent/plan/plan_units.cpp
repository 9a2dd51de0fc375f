// What the plan makes of each unit for itself.
#include <utility>

#include <fmt/format.h>

#include "farm/agent/plan/plan.hpp"

namespace farm::agent {
namespace {

using canopen::TimePoint;

/// How long a door may say that a unit is there which no agent has, as it does for a moment when one has ended.
constexpr std::chrono::seconds kMoment{1};

}  // namespace

bool Plan::may_be_here(const UnitName& unit, const UnitRecord& record) const {
  if (!record.wish || is_draining_ || ledger_.is_draining(self_.host)) return false;
  if (!self_.buses.empty() && !self_.buses.contains(unit.bus)) return false;
  return record.wish->content.allows(self_.host);
}

void Plan::decide(const UnitName& unit, UnitRecord& record, const Situation& at) {
  if (record.process.is_wanted() && must_stop(unit, record, at)) {
    record.process.stop();
    orders_.stops.push_back(unit);
  }
  const bool is_foreign = !record.process.is_wanted() && presence_.host_with(unit, at.now).has_value();
  record.there_since = is_foreign ? std::min(record.there_since, at.now) : canopen::kNever;
  if (!at.is_in_charge || !record.known) return;
  if (self_.has(record.known->place))
    keep(unit, record, at);
  else if (record.is_at(self_.host) && at.is_hearing_over)
    take_again(unit, record, at);
}

/// A configuration that cannot be used keeps the unit going with the one that it has. That nobody wants it counts
/// when others had time to put back what a new server does not have.
bool Plan::must_stop(const UnitName& unit, const UnitRecord& record, const Situation& at) const {
  if (!at.may_run) return true;
  if (!ledger_.is_complete()) return false;  // who has it is not known yet
  if (!record.wish && !at.is_hearing_over) return false;
  if (!may_be_here(unit, record)) return true;
  const bool is_others = record.known && !record.known->place.host.empty() && !record.is_at(self_.host);
  const bool is_old = record.known && !self_.has(record.known->place) && record.term != record.last_term();
  const bool is_changed = record.is_good() && record.running != record.wish->configuration;
  return is_others || is_old || is_changed;
}

/// Its place is ours.
void Plan::keep(const UnitName& unit, UnitRecord& record, const Situation& at) {
  if (!may_be_here(unit, record)) {
    if (record.process.is_off() && record.is_saved && at.is_hearing_over) release(unit, record, at);
    return;
  }
  const bool is_judged = record.judgement && record.judgement->configuration == record.wish->configuration &&
                         at.now < record.judgement->again;
  if (is_judged) wake_at(record.judgement->again, at.now);
  if (record.wish->problem.empty() && !is_judged && !record.is_being_judged) {
    record.is_being_judged = true;
    orders_.checks.push_back({unit, record.wish->configuration});
  }
  if (record.process.is_off() && record.is_good()) start(unit, record, at);
  if (record.process.state() == Process::State::On) note_term(unit, record);
  const std::string problem = problem_of(unit, record, at.now);
  tell_problem(unit, record, problem);
  Place place = record.known->place;
  place.problem = problem;
  place.restarts = record.process.restarts();
  if (place != record.known->place || record.known->revision == 0) write(unit, record, at, std::move(place));
}

void Plan::start(const UnitName& unit, UnitRecord& record, const Situation& at) {
  if (record.running != record.wish->configuration) record.process.forgive();
  wake_at(record.process.next_start(), at.now);
  if (record.there_since != canopen::kNever) wake_at(record.there_since + kMoment, at.now);
  const bool is_ours = record.known->revision != 0 && !record.is_being_written;
  if (!record.process.may_start(at.now) || !hubs_.is_on(unit.bus) || record.there_since != canopen::kNever ||
      !is_ours)
    return;
  record.running = record.wish->configuration;
  record.term = record.last_term();
  record.generation = ledger_.generation();
  record.process.start();
  orders_.starts.push_back({unit, record.running, record.term, record.generation});
}

/// One that was taken over while it ran, or whose place was put back.
void Plan::note_term(const UnitName& unit, UnitRecord& record) {
  const bool is_noted = record.term == record.last_term() && record.generation == ledger_.generation();
  if (is_noted || ledger_.generation().empty()) return;
  record.term = record.last_term();
  record.generation = ledger_.generation();
  orders_.notes.push_back({unit, record.running, record.term, record.generation});
}

/// An agent of this host that is no more had it, or one that has given up the name.
void Plan::take_again(const UnitName& unit, UnitRecord& record, const Situation& at) {
  if (record.process.is_wanted()) return claim(unit, record, at);
  wake_at(up_since_ + kPatience, at.now);
  if (!record.process.is_off() || !at.has_listened || record.there_since != canopen::kNever) return;
  may_be_here(unit, record) ? claim(unit, record, at) : release(unit, record, at);
}

std::string Plan::problem_of(const UnitName& unit, const UnitRecord& record, TimePoint now) const {
  const Wish& wish = *record.wish;
  if (!wish.problem.empty()) return wish.problem;
  if (record.judgement && record.judgement->configuration == wish.configuration &&
      !record.judgement->problem.empty())
    return record.judgement->problem;
  if (!record.process.is_off()) return {};
  if (!record.process.problem().empty()) return record.process.problem();
  if (std::string foreign = problem_of_foreign(unit, record, now); !foreign.empty()) return foreign;
  const std::string of_hub = hubs_.problem(unit.bus);
  return of_hub.empty() ? std::string{} : fmt::format("bus {}: {}", unit.bus, of_hub);
}

std::string Plan::problem_of_foreign(const UnitName& unit, const UnitRecord& record, TimePoint now) const {
  if (record.there_since == canopen::kNever || now - record.there_since < kMoment) return {};
  return fmt::format("it is there already, at host {}, from a daemon that no agent has started",
                     presence_.host_with(unit, now).value_or(""));
}

void Plan::tell_problem(const UnitName& unit, UnitRecord& record, const std::string& problem) {
  if (std::exchange(record.told_problem, problem) == problem || problem.empty()) return;
  orders_.notices.push_back({true, fmt::format("{}: {}", unit.text(), problem)});
}

}  // namespace farm::agent
