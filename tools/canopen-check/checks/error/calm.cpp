#include "tools/canopen-check/checks/error/calm.hpp"

#include <algorithm>

#include "tools/canopen-check/checks/shared/provocation.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

bool is_ahead(Context& context, std::string_view check) {
  return context.manners().ahead.contains(check);
}

}  // namespace

Calm::Calm(Context& context) : context_{&context} {
  const bool guards = context.eds().has(object::kGuardTime) && context.eds().has(object::kLifeTimeFactor) &&
                      context.session().carries_remote_frames() && context.settings().allow_reset;
  if (!guards || !is_ahead(context, kLifeGuardingBegins)) return;
  fresh_ = context.restart(canopen::NmtCommand::ResetCommunication);
  context.enter(canopen::NmtState::PreOperational);
}

bool Calm::set_life_time() {
  return context_->write_number(object::kGuardTime, 0, kGuardTime).done() &&
         context_->write_number(object::kLifeTimeFactor, 0, kLifeTimeFactor).done();
}

std::vector<TimedFrame> Calm::listen(const Condition& condition, canopen::Duration span) {
  Session& session = context_->session();
  const std::size_t mark = session.mark();
  const canopen::TimePoint until = session.now() + span;
  const std::optional<std::uint32_t> emcy = emcy_identifier(*context_);
  const bool watches = emcy && is_ahead(*context_, kConsumerBegins) && heartbeat_loss(*context_).has_value();
  const bool guards = emcy && fresh_ && set_life_time();
  canopen::TimePoint end = until;
  if (watches) end = std::max(end, session.now() + kLossTime + kEmergencyPatience);
  if (guards) end = std::max(end, session.now() + kLifeTime + kEmergencyPatience);
  session.pass(end - session.now());
  const auto traffic = session.since(mark);
  const bool told = emcy && std::ranges::any_of(traffic, [&](const TimedFrame& each) {
                      return !each.sent && under(*emcy)(each.frame) && code_of(each.frame) != 0;
                    });
  SeenRight& right = context_->manners().right;
  right.consumer_begins = watches && !told;
  right.life_guarding_begins = guards && !told;
  std::vector<TimedFrame> frames;
  for (const TimedFrame& each : traffic)
    if (!each.sent && each.time <= until && condition(each.frame)) frames.push_back(each);
  return frames;
}

}  // namespace conformance
