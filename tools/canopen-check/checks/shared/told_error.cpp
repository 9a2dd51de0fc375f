#include "tools/canopen-check/checks/shared/told_error.hpp"

#include <algorithm>

#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// What 1003h says: its count, and all entries that it counts until twenty cannot be read, the first one in any
/// case.
std::vector<SdoAnswer> history(Context& context) {
  constexpr std::uint64_t kHighest = 254;
  constexpr int kMostMissing = 20;
  std::vector<SdoAnswer> answers{context.read(object::kErrorField), context.read(object::kErrorField, 1)};
  int missing = answers.back().done() ? 0 : 1;
  for (std::uint64_t sub = 2; sub <= std::min(answers.front().number(), kHighest) && missing < kMostMissing;
       ++sub) {
    answers.push_back(context.read(object::kErrorField, static_cast<std::uint8_t>(sub)));
    missing += answers.back().done() ? 0 : 1;
  }
  return answers;
}

/// Brings the error about and looks at it; nothing, and the check is skipped, if none is told.
std::optional<ToldError> tell(Context& context) {
  const std::optional<Provoked> provoked = provoke(context, kWays);
  if (!provoked) return std::nullopt;
  const Provocation& how = provoked->how;
  ToldError told{.way = static_cast<std::size_t>(std::ranges::find(kWays, provoked->way) - kWays.begin()),
                 .name = how.name,
                 .code = how.code,
                 .ends = how.end != nullptr,
                 .identifier = provoked->identifier,
                 .message = provoked->emergency.frame.frame,
                 .error_register = context.read(object::kErrorRegister)};
  if (context.eds().empty() || context.eds().has(object::kErrorField)) told.history = history(context);
  told.traffic.assign(context.traffic().begin(), context.traffic().end());
  end(context, *provoked);
  return told;
}

}  // namespace

const ToldError* told_error(Context& context) {
  std::optional<ToldError>& told = context.manners().told_error;
  if (told)
    context.step(told->traffic);
  else
    told = tell(context);
  return told ? &*told : nullptr;
}

std::optional<Provoked> prepare_again(Context& context, const ToldError& error) {
  if (!context.restart(canopen::NmtCommand::ResetNode)) return std::nullopt;
  context.enter(canopen::NmtState::PreOperational);
  const Way way = kWays.at(error.way);
  if (const std::optional<Provocation> how = way(context)) return Provoked{way, *how, error.identifier, {}};
  context.skip("the error cannot be brought about once more");
  return std::nullopt;
}

}  // namespace conformance
