#include "tools/canopen-check/checks/shared/silence.hpp"

#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// Begins an upload in segments; why not, where the server does not.
std::string begin_transfer(Context& context, Multiplexor& transfer) {
  const std::optional<Target> target = long_entry(context, 4);
  if (!target) return "no entry that can be read has more than four bytes";
  transfer = {target->index, target->sub_index};
  context.step();
  const SdoAnswer answer = ask(context, context.sdo().request(kInitiateUpload, target->index, target->sub_index));
  if (begins_with(answer, 0x40) || begins_with(answer, 0x41)) return {};
  return "no upload in segments: " + to_text(answer);
}

/// Keeps silence for @p least in any case.
Silence keep_silence(Context& context, canopen::Duration least) {
  Session& session = context.session();
  Silence silence;
  silence.without_transfer = begin_transfer(context, silence.transfer);
  const canopen::TimePoint until = session.now() + least;
  if (silence.without_transfer.empty()) silence.answer = context.sdo().listen(kSilence);
  if (session.now() < until) session.pass(until - session.now());
  silence.traffic.assign(context.traffic().begin(), context.traffic().end());
  silence.service = context.read(object::kDeviceType);
  return silence;
}

}  // namespace

const Silence& silence_of_client(Context& context) {
  std::optional<Silence>& silence = context.manners().silence;
  if (silence)
    context.step(silence->traffic);
  else
    silence = keep_silence(context, {});
  return *silence;
}

std::vector<TimedFrame> listen_alone(Context& context, const Condition& condition, canopen::Duration span) {
  Session& session = context.session();
  const bool at_once = context.manners().ahead.contains("sdo.silent-client") && context.settings().allow_reset;
  if (!at_once) return session.collect(condition, span);
  const std::size_t mark = session.mark();
  const canopen::TimePoint until = session.now() + span;
  Silence silence = keep_silence(context, span);
  std::vector<TimedFrame> frames;
  for (const TimedFrame& each : session.since(mark))
    if (!each.sent && each.time <= until && condition(each.frame)) frames.push_back(each);
  if (session.ended()) return frames;
  if (silence.service.kind != SdoAnswer::Kind::Silent) {
    context.manners().silence = std::move(silence);
  } else {  // a matter of sdo.silent-client, for which it has to be there once more
    (void)context.restart(canopen::NmtCommand::ResetNode);
  }
  return frames;
}

}  // namespace conformance
