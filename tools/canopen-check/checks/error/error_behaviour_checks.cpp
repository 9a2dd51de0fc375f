#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/provocation.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::NmtState;

constexpr std::uint64_t kToPreOperational = 0, kNoChange = 1, kToStopped = 2;

/// What a communication error leads to.
struct Case {
  std::uint64_t behaviour;
  NmtState from, to;
};
constexpr std::array kCases{
    Case{kNoChange, NmtState::Operational, NmtState::Operational},
    Case{kToPreOperational, NmtState::Operational, NmtState::PreOperational},
    Case{kToStopped, NmtState::Operational, NmtState::Stopped},
    Case{kNoChange, NmtState::PreOperational, NmtState::PreOperational},
    Case{kToPreOperational, NmtState::PreOperational, NmtState::PreOperational},
    Case{kToStopped, NmtState::PreOperational, NmtState::Stopped},
};

/// Brings the error about as @p row says: the state of the node @p reaction later. That of the row, and a finding,
/// where 1029h:01 does not take the value.
std::optional<NmtState> state_after(Context& context, const Provocation& how, const Case& row,
                                    canopen::Duration reaction) {
  context.enter(NmtState::PreOperational);
  // What ends the former event also begins the next.
  how.raise();
  if (!context.set(object::kErrorBehaviour, 1, row.behaviour)) return row.to;
  context.enter(row.from);
  context.step();
  how.raise();
  context.session().pass(how.delay + reaction);
  return context.state();
}

void leads_to(Context& context, const Provoked& provoked, const Case& row) {
  constexpr canopen::Duration kReaction = std::chrono::milliseconds{100};
  // A state that stays may be left late, and a look at the state can be a guarding request.
  const bool is_seen_early = row.from != row.to && provoked.way == heartbeat_loss;
  if (is_seen_early && state_after(context, provoked.how, row, context.quiet(kReaction)) == row.to) return;
  const std::optional<NmtState> now = state_after(context, provoked.how, row, kReaction);
  if (now == row.to) return;
  context.fail(object::kErrorBehaviour, 1,
               fmt::format("{} with value {} in {}: {}", provoked.how.name, row.behaviour, name_of(row.from),
                           name_of(row.to)),
               now ? std::string{name_of(*now)} : "no answer");
}

void follows_error_behaviour(Context& context) {
  if (!context.need(object::kErrorBehaviour, 1) || !context.observe_state()) return;
  constexpr std::array<Way, 2> kLosses{heartbeat_loss, guarding_loss};
  const std::optional<Provoked> provoked = provoke(context, kLosses);
  if (!provoked) return;
  for (const Case& row : kCases) leads_to(context, *provoked, row);
}

void has_default_0(Context& context) {
  const EntryFacts* const facts = context.eds().find(object::kErrorBehaviour, 1);
  if (facts == nullptr || !facts->initial) return context.skip("the EDS states no default of 1029h:01");
  const std::optional<eds::Integer> value = facts->initial->at(context.eds().node_id());
  if (value && value->magnitude != kToPreOperational)
    context.fail(object::kErrorBehaviour, 1, "default 0: an error of the communication leads to Pre-operational",
                 fmt::format("default {}", value->magnitude));
}

constexpr std::array kChecks{
    Check{.id = "error-control.error-behaviour",
          .name = "An error of the communication leads to the NMT state that 1029h:01 says",
          .clause = "CiA 301 7.5.2.32",
          .group = Group::ErrorControl,
          .run = follows_error_behaviour},
    Check{.id = "error-control.error-behaviour-default",
          .name = "An error of the communication leads to Pre-operational by default",
          .clause = "CiA 301 7.5.2.32",
          .group = Group::ErrorControl,
          .mode = Mode::ReadOnly,
          .run = has_default_0},
};

}  // namespace

std::span<const Check> error_behaviour_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
