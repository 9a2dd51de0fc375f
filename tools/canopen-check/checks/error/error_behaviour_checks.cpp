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

void leads_to(Context& context, const Provocation& how, const Case& row) {
  context.enter(NmtState::PreOperational);
  // What ends the former event also begins the next.
  how.raise();
  if (!context.set(object::kErrorBehaviour, 1, row.behaviour)) return;
  context.enter(row.from);
  constexpr canopen::Duration kReaction = std::chrono::milliseconds{100};
  context.step();
  how.raise();
  const canopen::Duration quick = context.quiet(kReaction);
  context.session().pass(how.delay + quick);
  std::optional<NmtState> now = context.state();
  if (now == row.to) return;
  if (quick < kReaction) {  // it may be slow
    context.session().pass(kReaction - quick);
    now = context.state();
  }
  if (now == row.to) return;
  context.fail(
      object::kErrorBehaviour, 1,
      fmt::format("{} with value {} in {}: {}", how.name, row.behaviour, name_of(row.from), name_of(row.to)),
      now ? std::string{name_of(*now)} : "no answer");
}

void follows_error_behaviour(Context& context) {
  if (!context.need(object::kErrorBehaviour, 1) || !context.observe_state()) return;
  constexpr std::array<Way, 2> kWays{heartbeat_loss, guarding_loss};
  const std::optional<Provoked> provoked = provoke(context, kWays);
  if (!provoked) return;
  for (const Case& row : kCases) leads_to(context, provoked->how, row);
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
