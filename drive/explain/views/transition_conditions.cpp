// What the transitions of the sequence control need, in the words of explain().
#include "drive/explain/views/transition_conditions.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace drive::explanation {
namespace {

using enum State;
using E = Event;
using P = const Picture&;

constexpr States kAll = (1U << kStateCount) - 1U;
constexpr States kWithoutPulses = in(NotReadyToSwitchOn, SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn, Fault);

const SequenceControl::Inputs& inputs_of(P p) noexcept {
  return p.sequence().effective();
}

bool halts_without_pulses(P p) noexcept {
  return p.sequence().halts() && p.sequence().settings.halt_option == 0;
}

/// The reactions of faults, and their names.
struct ReactionName {
  Reaction reaction;
  std::string_view name;
};
constexpr std::array kReactions{
    ReactionName{Reaction::Off1, "OFF1"},       ReactionName{Reaction::Off2, "OFF2"},
    ReactionName{Reaction::Off3, "OFF3"},       ReactionName{Reaction::Stop2, "STOP2"},
    ReactionName{Reaction::Encoder, "encoder"}, ReactionName{Reaction::ShortCircuit, "armature short-circuit"},
};

bool is_one_of(Reaction reaction, Events events) noexcept {
  const std::optional<Event> event = event_of(reaction);
  return event && (events & on(*event)) != 0;
}

std::string fault_text_of(P, Events events) {
  std::string names;
  for (const ReactionName& row : kReactions)
    if (is_one_of(row.reaction, events)) names.append(names.empty() ? "" : ", ").append(row.name);
  return fmt::format("A fault with one of these reactions is active: {}", names);
}

bool has_fault_of(P p, Events events) noexcept {
  const Reactions active = p.axis.active_reactions();
  return std::ranges::any_of(kReactions, [=](const ReactionName& row) {
    return is_one_of(row.reaction, events) && (active & bit_of(row.reaction)) != 0;
  });
}

bool any_fault(P p, bool (*holds)(const FaultEntry&)) {
  return std::ranges::any_of(p.axis.messages().faults(), holds);
}

// Commands.
constexpr Condition kNotInhibited{
    kAll, "p0010",
    [](P, Events) -> std::string { return "Commissioning is over (p0010 = 0, on the control unit p0009 = 0)"; },
    [](P p, Events) { return !p.sequence().is_inhibited(); }};
constexpr Condition kOff1{kAll, "p0840",
                          [](P p, Events) { return fmt::format("OFF1 is given ({})", commanded_by(p.axis, 840)); },
                          [](P p, Events) { return !p.sequence().is_on() && !p.axis.jogs(); }};
constexpr Condition kOn{kAll, "p0840",
                        [](P p, Events) {
                          const bool withheld = inputs_of(p).on && !p.sequence().is_on();
                          return fmt::format("ON is given{} ({})", withheld ? " anew, with an edge" : "",
                                             commanded_by(p.axis, 840));
                        },
                        [](P p, Events) { return p.sequence().is_on() || p.axis.jogs(); }};
constexpr Condition kNoOff2{
    kAll, "p0844", [](P p, Events) { return fmt::format("OFF2 is not given ({})", commanded_by(p.axis, 844)); },
    [](P p, Events) { return inputs_of(p).no_off2; }};
constexpr Condition kNoSecondOff2{
    kAll, "p0845", [](P p, Events) { return fmt::format("OFF2 is not given ({})", commanded_by(p.axis, 845)); },
    [](P p, Events) { return inputs_of(p).no_off2_second; }};
constexpr Condition kNoOff3{
    kAll, "p0848", [](P p, Events) { return fmt::format("OFF3 is not given ({})", commanded_by(p.axis, 848)); },
    [](P p, Events) { return inputs_of(p).no_off3; }};
constexpr Condition kNoSecondOff3{
    kAll, "p0849", [](P p, Events) { return fmt::format("OFF3 is not given ({})", commanded_by(p.axis, 849)); },
    [](P p, Events) { return inputs_of(p).no_off3_second; }};
constexpr Condition kOff2{kAll, "p0844",
                          [](P p, Events) {
                            return fmt::format(
                                "OFF2 is given ({} or {}), or commissioning inhibits (p0010, p0009)",
                                commanded_by(p.axis, 844), commanded_by(p.axis, 845));
                          },
                          [](P p, Events) { return inputs_of(p).has_off2() || p.sequence().is_inhibited(); }};
constexpr Condition kOff3{kAll, "p0848",
                          [](P p, Events) {
                            return fmt::format("OFF3 is given ({} or {})", commanded_by(p.axis, 848),
                                               commanded_by(p.axis, 849));
                          },
                          [](P p, Events) { return inputs_of(p).has_off3(); }};
constexpr Condition kEnable{
    kAll, "p0852", [](P p, Events) { return fmt::format("Operation is enabled ({})", commanded_by(p.axis, 852)); },
    [](P p, Events) { return inputs_of(p).enable_operation; }};
constexpr Condition kNoEnable{
    kAll, "p0852",
    [](P p, Events) {
      return fmt::format("Operation is not enabled ({}), or a halt takes the pulses off (p8791 = 0)",
                         commanded_by(p.axis, 852));
    },
    [](P p, Events) { return !inputs_of(p).enable_operation || halts_without_pulses(p); }};
constexpr Condition kNoHalt{kAll, "p8791",
                            [](P, Events) -> std::string {
                              return "No halt keeps the pulses off (bit 8 of the controlword with p8791 = 0)";
                            },
                            [](P p, Events) { return !halts_without_pulses(p); }};
constexpr Condition kInfeed{
    kWithoutPulses, "p0864",
    [](P p, Events) { return fmt::format("The infeed operates ({})", wiring_of(p.axis, 864)); },
    [](P p, Events) { return inputs_of(p).infeed_operates; }};
constexpr Condition kLink{kWithoutPulses, "r0026",
                          [](P, Events) -> std::string { return "The DC link has its voltage (r0026)"; },
                          [](P p, Events) { return p.axis.block<PowerUnit>().has_link(); }};

// What happens.
constexpr Condition kRunUp{kAll, "", [](P, Events) -> std::string { return "The run-up is over"; },
                           [](P p, Events) { return p.state() != NotReadyToSwitchOn; }};
constexpr Condition kStands{
    kAll, "p1226",
    [](P p, Events) {
      return fmt::format(
          "Speed and setpoint are below the threshold (p1226 = {:g} rpm) for p1228, or the "
          "setpoint for p1227",
          p.axis.read(1226).value_or(0.0));
    },
    [](P p, Events) { return p.sequence().is_standstill(p.axis.actual().speed, p.channel().output()); }};
constexpr Condition kFault{kAll, "r0945", &fault_text_of, &has_fault_of};
constexpr Condition kMeasured{
    kAll, "r0047",
    [](P, Events) -> std::string { return "The measurement of the motor has ended (p1910, p1960)"; },
    [](P, Events) { return false; }};
constexpr Condition kNoPowerOn{
    kAll, "r0945",
    [](P, Events) -> std::string { return "No fault is there that leaves by switching off and on only"; },
    [](P p, Events) {
      return !any_fault(p, [](const FaultEntry& fault) { return fault.acknowledge() == Acknowledge::PowerOn; });
    }};
constexpr Condition kNoCause{
    kAll, "r0945", [](P, Events) -> std::string { return "The cause of every fault is gone"; },
    [](P p, Events) { return !any_fault(p, [](const FaultEntry& fault) { return fault.cause != Cause::Gone; }); }};
constexpr Condition kStandsStill{in(Stop2Active), "p1226",
                                 [](P, Events) -> std::string { return "The shaft stands (p1226)"; }, kStands.met};
constexpr Condition kAcknowledged{kAll, "p2103",
                                  [](P p, Events) {
                                    return fmt::format(
                                        "The faults are acknowledged, with an edge from 0 to 1 ({}, {}, {})",
                                        wiring_of(p.axis, 2103), wiring_of(p.axis, 2104), wiring_of(p.axis, 2105));
                                  },
                                  [](P p, Events) { return p.axis.messages().faults().empty(); }};

constexpr std::array kForOff1{&kNotInhibited, &kNoOff2, &kNoSecondOff2, &kNoOff3, &kNoSecondOff3, &kOff1};
constexpr std::array kForOn{&kNotInhibited, &kNoOff2, &kNoSecondOff2, &kNoOff3, &kNoSecondOff3, &kOn};
constexpr std::array kForSwitchingOn{&kNotInhibited, &kNoOff2, &kNoSecondOff2, &kNoOff3,
                                     &kNoSecondOff3, &kOn,     &kNoEnable};
constexpr std::array kForOperation{&kNotInhibited, &kNoOff2, &kNoSecondOff2, &kNoOff3, &kNoSecondOff3,
                                   &kOn,           &kEnable, &kNoHalt,       &kInfeed, &kLink};
constexpr std::array kForOff2{&kOff2};
constexpr std::array kForOff3{&kNotInhibited, &kNoOff2, &kNoSecondOff2, &kOff3};
constexpr std::array kForRunUp{&kRunUp};
constexpr std::array kForStandstill{&kStands};
constexpr std::array kForFault{&kFault};
constexpr std::array kForAcknowledging{&kNoPowerOn, &kNoCause, &kStandsStill, &kAcknowledged};
constexpr std::array kForMeasurement{&kMeasured};

constexpr std::array kTriggers{
    Trigger{on(E::SwitchOn, E::EnableOperation), true, false, kForOn},
    Trigger{on(E::Shutdown), false, false, kForOff1},
    Trigger{on(E::SwitchOn), false, false, kForSwitchingOn},
    Trigger{on(E::EnableOperation), false, false, kForOperation},
    Trigger{on(E::DisableVoltage), false, false, kForOff2},
    Trigger{on(E::QuickStop), false, false, kForOff3},
    Trigger{on(E::Initialised), false, true, kForRunUp},
    Trigger{on(E::Standstill), false, true, kForStandstill},
    Trigger{on(E::FaultOff1, E::FaultOff2, E::FaultOff3, E::FaultStop2), false, true, kForFault},
    Trigger{on(E::Acknowledged), false, false, kForAcknowledging},
    Trigger{on(E::MeasurementEnded), false, true, kForMeasurement},
};
static_assert(
    [] {
      Events all = 0;
      for (const Trigger& row : kTriggers) all |= row.events;
      return all == (1U << kEventCount) - 1U;
    }(),
    "every event has its conditions");

}  // namespace

std::span<const Trigger> triggers() noexcept {
  return kTriggers;
}

}  // namespace drive::explanation
