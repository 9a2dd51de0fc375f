#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "farm/agent/plan/hubs.hpp"
#include "farm/agent/plan/ledger.hpp"
#include "farm/agent/plan/placement.hpp"
#include "farm/agent/plan/presence.hpp"
#include "farm/agent/plan/self.hpp"

namespace farm::agent {

/// What the agent of a host does, without doing it: it is told the time, what lies in the buckets, who is there
/// and what became of its orders, and says what to take, to release, to start and to stop.
///
/// Of two hosts never both run a unit, as far as one can know: who takes a unit of another host has heard nothing
/// of that for kPatience, and whoever has not heard his own beats for so long, counted from when they were sent,
/// stops his units. Who takes it is decided by the revision of its place.
class Plan {
 public:
  /// An agent that is started at @p now.
  Plan(Self self, canopen::TimePoint now);
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  /// The connection to the server is there; all keys of all buckets will be told.
  void on_up(canopen::TimePoint now);
  void on_down() noexcept { is_up_ = false; }
  void on_entry(Bucket bucket, const Entry& entry) { ledger_.on_entry(bucket, entry, orders_); }
  void on_all(Bucket bucket, canopen::TimePoint now) { ledger_.on_all(bucket, now, orders_); }
  void hear(const AgentBeat& beat, canopen::TimePoint now);
  void hear(const DoorBeat& beat, canopen::TimePoint now) { presence_.on_door(beat, now); }

  /// What became of a write: the new revision, or nothing if somebody was faster.
  void on_written(const PlaceWrite& write, const tl::expected<std::optional<std::uint64_t>, std::string>& outcome,
                  canopen::TimePoint now);
  /// What became of a check: @p problem is empty if the configuration can be used.
  void on_judged(const Check& check, const std::string& problem);
  void on_not_judged(const Check& check, const std::string& why, canopen::TimePoint now);
  /// A unit runs here since before this agent.
  void on_found(const UnitStart& unit, canopen::TimePoint now);
  void on_started(const UnitName& unit, canopen::TimePoint now);
  /// It has ended, or could not be started, for the reason @p why; what it has saved is on the server if @p
  /// is_saved.
  void on_ended(const UnitName& unit, const std::string& why, canopen::TimePoint now);
  /// Whether what @p unit has saved is on the server.
  void on_saved(const UnitName& unit, bool is_saved) { ledger_.units()[unit].is_saved = is_saved; }
  [[nodiscard]] Hubs& hubs() noexcept { return hubs_; }

  /// All units are given away from now on, and none taken.
  void drain() noexcept { is_draining_ = true; }
  /// Nothing runs here and nothing is placed here.
  [[nodiscard]] bool is_empty() const;

  /// What is to be done at @p now.
  [[nodiscard]] Orders advance(canopen::TimePoint now);
  /// When advance() is wanted, if nothing is told before.
  [[nodiscard]] canopen::TimePoint due() const noexcept { return due_; }
  /// What is to be told to all every kBeatPeriod.
  [[nodiscard]] AgentBeat beat(canopen::TimePoint now) const;

 private:
  /// How things stand in a call of advance().
  struct Situation {
    canopen::TimePoint now;
    bool may_run = false;       ///< what is placed here may run here
    bool is_in_charge = false;  ///< and places may be written
    bool is_hearing_over = false;
    bool has_listened = false;  ///< long enough to know who is silent
  };

  [[nodiscard]] Situation judge(canopen::TimePoint now);
  void tell_condition(const Situation& at, std::optional<std::uint64_t> rival);
  [[nodiscard]] bool may_be_here(const UnitName& unit, const UnitRecord& record) const;
  [[nodiscard]] bool is_open(const UnitName& unit, const UnitRecord& record, canopen::TimePoint now) const;

  void decide(const UnitName& unit, UnitRecord& record, const Situation& at);
  [[nodiscard]] bool must_stop(const UnitName& unit, const UnitRecord& record, const Situation& at) const;
  void keep(const UnitName& unit, UnitRecord& record, const Situation& at);
  void start(const UnitName& unit, UnitRecord& record, const Situation& at);
  void note_term(const UnitName& unit, UnitRecord& record);
  void take_again(const UnitName& unit, UnitRecord& record, const Situation& at);
  [[nodiscard]] std::string problem_of(const UnitName& unit, const UnitRecord& record,
                                       canopen::TimePoint now) const;
  [[nodiscard]] std::string problem_of_foreign(const UnitName& unit, const UnitRecord& record,
                                               canopen::TimePoint now) const;

  void place_open_units(const Situation& at);
  void take_open_unit(const UnitName& unit, UnitRecord& record, const Situation& at);
  [[nodiscard]] bool is_speaker(const UnitName& unit, canopen::TimePoint now) const;
  [[nodiscard]] std::string problem_of_open(const UnitName& unit, const UnitRecord& record,
                                            canopen::TimePoint now) const;
  void claim(const UnitName& unit, UnitRecord& record, const Situation& at);
  void release(const UnitName& unit, UnitRecord& record, const Situation& at, std::string problem = {});
  void write(const UnitName& unit, UnitRecord& record, const Situation& at, Place place);
  void advance_hubs(canopen::TimePoint now);
  void tell_problem(const UnitName& unit, UnitRecord& record, const std::string& problem);
  void wake_at(canopen::TimePoint time, canopen::TimePoint now) noexcept;

  const Self self_;
  Presence presence_;
  Ledger ledger_{self_};
  Placement placement_;
  Hubs hubs_;
  Orders orders_;  ///< of the next advance()
  bool is_up_ = false;
  bool is_draining_ = false;
  bool had_contact_ = true;
  std::optional<std::uint64_t> told_rival_;
  canopen::TimePoint up_since_{};
  canopen::TimePoint contact_;  ///< when the last own beat was sent that has come back
  canopen::TimePoint due_{};
};

}  // namespace farm::agent
