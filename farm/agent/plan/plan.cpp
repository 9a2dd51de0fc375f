#include "farm/agent/plan/plan.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace farm::agent {
namespace {

using canopen::TimePoint;

std::uint64_t milliseconds_of(TimePoint time) noexcept {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count());
}

}  // namespace

Plan::Plan(Self self, TimePoint now) : self_{std::move(self)}, contact_{now} {}

void Plan::on_up(TimePoint now) {
  is_up_ = true;
  up_since_ = now;
  presence_.listen(now);
  ledger_.on_up();
}

/// That an own beat has come back shows that others have got it too, not earlier than it was sent.
void Plan::hear(const AgentBeat& beat, TimePoint now) {
  presence_.on_agent(beat, now);
  if (beat.host != self_.host || beat.instance != self_.instance) return;
  const TimePoint sent{std::chrono::milliseconds{beat.sent_ms}};
  if (sent <= now) contact_ = std::max(contact_, sent);
}

void Plan::on_written(const PlaceWrite& write,
                      const tl::expected<std::optional<std::uint64_t>, std::string>& outcome, TimePoint now) {
  UnitRecord& record = ledger_.units()[write.unit];
  record.is_being_written = false;
  if (outcome && *outcome) {
    const bool is_newest = !record.known || record.known->revision <= **outcome;
    if (is_newest) record.known = KnownPlace{write.place, **outcome};
    return;
  }
  record.write_again = now + kWritePause;
  if (!outcome) orders_.notices.push_back({true, fmt::format("places: {}", outcome.error())});
}

void Plan::on_judged(const Check& check, const std::string& problem) {
  UnitRecord& record = ledger_.units()[check.unit];
  record.is_being_judged = false;
  record.judgement = Judgement{check.configuration, problem};
}

void Plan::on_not_judged(const Check& check, const std::string& why, TimePoint now) {
  UnitRecord& record = ledger_.units()[check.unit];
  record.is_being_judged = false;
  record.judgement = Judgement{check.configuration, why, now + kFirstPause};
}

void Plan::on_found(const UnitStart& unit, TimePoint now) {
  UnitRecord& record = ledger_.units()[unit.unit];
  record.process.on_started(now);
  record.running = unit.configuration;
  record.term = unit.term;
  record.generation = unit.generation;
}

void Plan::on_started(const UnitName& unit, TimePoint now) {
  Process& process = ledger_.units()[unit].process;
  if (process.state() == Process::State::Starting) process.on_started(now);
}

void Plan::on_ended(const UnitName& unit, const std::string& why, TimePoint now) {
  ledger_.units()[unit].process.on_ended(why, now);
}

bool Plan::is_empty() const {
  const auto is_nothing = [this](const auto& each) {
    return each.second.process.is_off() && !each.second.is_at(self_.host);
  };
  return hubs_.are_off() && std::ranges::all_of(ledger_.units(), is_nothing);
}

AgentBeat Plan::beat(TimePoint now) const {
  AgentBeat beat{.host = self_.host, .instance = self_.instance, .version = self_.version, .since = self_.since};
  beat.buses.assign(self_.buses.begin(), self_.buses.end());
  beat.capacity = self_.capacity;
  beat.units = static_cast<std::uint32_t>(std::ranges::count_if(
      ledger_.units(), [](const auto& each) { return each.second.process.state() == Process::State::On; }));
  beat.draining = is_draining_ || ledger_.is_draining(self_.host);
  beat.sent_ms = milliseconds_of(now);
  return beat;
}

Orders Plan::advance(TimePoint now) {
  due_ = canopen::kNever;
  const Situation at = judge(now);
  ledger_.on_time(now, orders_);
  for (auto& [unit, record] : ledger_.units()) decide(unit, record, at);
  if (at.is_in_charge && at.is_hearing_over) place_open_units(at);
  advance_hubs(now);
  for (const TimePoint time : {ledger_.due(), presence_.next_silence(now), placement_.next_turn(), hubs_.due(),
                               contact_ + kPatience, up_since_ + kHearing})
    wake_at(time, now);
  return std::exchange(orders_, {});
}

Plan::Situation Plan::judge(TimePoint now) {
  const auto rival = presence_.rival(self_.host, self_.instance, now);
  Situation at{.now = now};
  at.may_run = now - contact_ < kPatience && !rival;
  at.is_in_charge = at.may_run && is_up_ && ledger_.is_complete();
  at.is_hearing_over = is_up_ && now - up_since_ >= kHearing;
  at.has_listened = is_up_ && now - up_since_ >= kPatience;
  tell_condition(at, rival);
  return at;
}

void Plan::tell_condition(const Situation& at, std::optional<std::uint64_t> rival) {
  const bool has_contact = at.now - contact_ < kPatience;
  if (std::exchange(had_contact_, has_contact) != has_contact)
    orders_.notices.push_back(
        {!has_contact, has_contact
                           ? "the server is reached again: what is placed here goes on"
                           : fmt::format("no sign of the server for {} s: others may take the units of this "
                                         "host, they are stopped",
                                         kPatience.count())});
  if (rival && rival != told_rival_)
    orders_.notices.push_back(
        {true, fmt::format("another agent, instance {}, calls itself host {}: this one, instance "
                           "{}, does nothing until the name is free",
                           *rival, self_.host, self_.instance)});
  if (!rival && told_rival_)
    orders_.notices.push_back(
        {false, fmt::format("no other agent calls itself host {} any more: this one goes on", self_.host)});
  told_rival_ = rival;
}

/// Which bit rates buses have is known when all has been told.
void Plan::advance_hubs(TimePoint now) {
  if (!ledger_.is_complete()) return;
  std::map<std::string, std::uint32_t> wanted;
  std::set<std::string> in_use;
  for (const auto& [unit, record] : ledger_.units()) {
    if (!record.process.is_off()) in_use.insert(unit.bus);
    const bool is_kept = record.known && self_.has(record.known->place) && may_be_here(unit, record);
    if (record.process.is_wanted() || (is_kept && record.is_good()))
      wanted[unit.bus] = ledger_.bit_rate_of(unit.bus);
  }
  hubs_.advance(wanted, in_use, now, orders_);
}

void Plan::wake_at(TimePoint time, TimePoint now) noexcept {
  if (time > now) due_ = std::min(due_, time);
}

}  // namespace farm::agent
