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

constexpr canopen::Duration kReaction = std::chrono::milliseconds{100};

/// Brings the error about as @p row says. False, and a finding, where 1029h:01 does not take the value.
bool bring_about(Context& context, const Provocation& how, const Case& row) {
  context.enter(NmtState::PreOperational);
  // What ends the former event also begins the next.
  how.raise();
  if (!context.set(object::kErrorBehaviour, 1, row.behaviour)) return false;
  context.enter(row.from);
  context.step();
  context.session().drain();
  how.raise();
  return true;
}

/// True if a node that is quick is seen to change its state as @p row says. Where it tells its state by guarding
/// this look begins the life time anew, so that there is one only.
bool is_seen_to_change(Context& context, const Provoked& provoked, const Case& row) {
  if (!bring_about(context, provoked.how, row)) return false;
  const canopen::Duration quick = context.quiet(kReaction);
  // An error that lasts need not be told once more.
  if (wait_for_error(context, provoked.identifier, provoked.how.delay + quick)) context.session().pass(quick);
  return context.state() == row.to;
}

void leads_to(Context& context, const Provoked& provoked, const Case& row) {
  const std::size_t findings = context.findings().size();
  if (row.from != row.to && is_seen_to_change(context, provoked, row)) return;
  // What is wrong then may be slow, and a state that stays may be left late: the whole row in full.
  if (context.findings().size() != findings || !bring_about(context, provoked.how, row)) return;
  context.session().pass(provoked.how.delay + kReaction);
  const std::optional<NmtState> now = context.state();
  if (now == row.to) return;
  context.fail(object::kErrorBehaviour, 1,
               fmt::format("{} with value {} in {}: {}", provoked.how.name, row.behaviour, name_of(row.from),
                           name_of(row.to)),
               now ? std::string{name_of(*now)} : "no answer");
}

/// Half the life time for a node that takes no noticeable part of it for an answer: each row waits for its end.
/// One that looks at it seldom is seen in the full look, which takes twice as long.
void shorten_life_time(Context& context, Provocation& how) {
  constexpr int kUnnoticed = 8;
  if (context.quiet(kLifeTime) > kLifeTime / kUnnoticed) return;
  if (context.write_number(object::kLifeTimeFactor, 0, kLifeTimeFactor / 2).done()) how.delay = kLifeTime / 2;
}

/// The loss of a heartbeat or of the guarding master, whichever the node tells. What a check before has seen it
/// tell is not brought about once more for that; an error that may last is ended by a reset.
std::optional<Provoked> told_loss(Context& context) {
  constexpr std::array<Way, 2> kLosses{heartbeat_loss, guarding_loss};
  const SeenAtWork& seen = context.manners().at_work;
  const auto emcy = emcy_identifier(context);
  const Way known = seen.tells_heartbeat_loss  ? heartbeat_loss
                    : seen.tells_guarding_loss ? guarding_loss
                                               : nullptr;
  const bool resets = context.manners().errors_last && context.settings().allow_reset;
  if (!emcy || known == nullptr) return provoke(context, kLosses);
  if (resets && !context.restart(canopen::NmtCommand::ResetNode)) return std::nullopt;
  if (resets) context.enter(NmtState::PreOperational);
  std::optional<Provocation> how = known(context);
  if (how && known == guarding_loss) shorten_life_time(context, *how);
  return how ? std::optional{Provoked{known, *how, *emcy, {}}} : provoke(context, kLosses);
}

void follows_error_behaviour(Context& context) {
  if (!context.need(object::kErrorBehaviour, 1) || !context.observe_state()) return;
  const std::optional<Provoked> provoked = told_loss(context);
  if (!provoked) return;
  for (const Case& row : kCases) leads_to(context, *provoked, row);
}

void has_default_0(Context& context) {
  const eds::EntryFacts* const facts = context.eds().find(object::kErrorBehaviour, 1);
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
