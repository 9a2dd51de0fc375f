#include "tools/canopen-check/checks/shared/provocation.hpp"

#include <algorithm>
#include <concepts>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/process_data.hpp"
#include "tools/canopen-check/checks/shared/stations.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint32_t kEmcy = 0x80, kStandardBits = 0x7FF;
constexpr canopen::Duration kGuardAnswer = std::chrono::milliseconds{100};

bool has(Context& context, std::uint16_t index, std::uint8_t sub_index = 0) {
  return context.eds().empty() ? context.read(index, sub_index).done()
                               : context.eds().find(index, sub_index) != nullptr;
}

bool answers_guarding(Context& context) {
  Session& session = context.session();
  if (!session.carries_remote_frames()) return false;
  session.drain();
  session.send({.id = session.identifier(function_code::kErrorControl), .length = 1, .remote = true});
  return session.wait_for(under(session.identifier(function_code::kErrorControl)), kGuardAnswer).has_value();
}

}  // namespace

std::uint16_t code_of(const canopen::Frame& frame) noexcept {
  return static_cast<std::uint16_t>(frame.data[0] | frame.data[1] << 8U);
}

std::optional<std::uint32_t> emcy_identifier(Context& context) {
  const SdoAnswer cob_id = context.read(object::kCobIdEmcy);
  // Who sends emergency messages has 1014h (CiA 301, 7.5.2.17).
  const bool absent = cob_id.aborted() && cob_id.abort_code == number_of(canopen::AbortCode::NoObject);
  if (absent && !context.eds().has(object::kCobIdEmcy)) return std::nullopt;
  if (!cob_id.done()) return context.session().identifier(kEmcy);
  const auto word = static_cast<std::uint32_t>(cob_id.number());
  if ((word & kInvalid) != 0) return std::nullopt;
  return word & kStandardBits;
}

namespace {

std::optional<Emergency> wait_for_any(Context& context, std::uint32_t identifier, canopen::Duration patience,
                                      std::predicate<std::uint16_t> auto is_wanted) {
  const auto frame = context.session().wait_for(
      [&, is_emcy = under(identifier)](const canopen::Frame& each) {
        return is_emcy(each) && is_wanted(code_of(each));
      },
      patience);
  if (!frame) return std::nullopt;
  return Emergency{.frame = *frame, .code = code_of(frame->frame), .error_register = frame->frame.data[2]};
}

}  // namespace

std::optional<Emergency> wait_for_emergency(Context& context, std::uint32_t identifier,
                                            canopen::Duration patience) {
  return wait_for_any(context, identifier, patience, [](std::uint16_t) { return true; });
}

std::optional<Emergency> wait_for_error(Context& context, std::uint32_t identifier, canopen::Duration patience) {
  return wait_for_any(context, identifier, patience, [](std::uint16_t code) { return code != 0; });
}

std::optional<Emergency> wait_for_code(Context& context, std::uint32_t identifier, std::uint16_t code,
                                       canopen::Duration patience) {
  return wait_for_any(context, identifier, patience, [code](std::uint16_t each) { return each == code; });
}

std::string to_text(const Emergency& emergency) {
  return fmt::format("{:04X}h, register {:02X}h", emergency.code, emergency.error_register);
}

std::optional<Provocation> heartbeat_loss(Context& context) {
  if (!has(context, object::kConsumerHeartbeatTime, 1)) return std::nullopt;
  const std::optional<std::uint8_t> node = unused_node_id(context);
  if (!node ||
      !context.write_number(object::kConsumerHeartbeatTime, 1, std::uint64_t{*node} << 16U | kLossMilliseconds)
           .done())
    return std::nullopt;
  const auto beat = [session = &context.session(), id = function_code::kErrorControl + *node] {
    session->send({.id = id, .length = 1, .data = {static_cast<std::uint8_t>(canopen::NmtState::Operational)}});
  };
  return Provocation{.name = fmt::format("the heartbeat of node {} is lost", *node),
                     .code = 0x8130,
                     .delay = kLossTime,
                     .raise = beat,
                     .end = beat};
}

std::optional<Provocation> guarding_loss(Context& context) {
  if (!has(context, object::kGuardTime) || !has(context, object::kLifeTimeFactor)) return std::nullopt;
  if (has(context, object::kHeartbeatTime) && context.read(object::kHeartbeatTime).number() != 0 &&
      !context.write_number(object::kHeartbeatTime, 0, 0).done())
    return std::nullopt;
  if (!answers_guarding(context) || !context.write_number(object::kGuardTime, 0, kGuardTime).done() ||
      !context.write_number(object::kLifeTimeFactor, 0, kLifeTimeFactor).done())
    return std::nullopt;
  const auto request = [session = &context.session()] {
    session->send({.id = session->identifier(function_code::kErrorControl), .length = 1, .remote = true});
  };
  return Provocation{
      .name = "the guarding master is lost", .code = 0x8130, .delay = kLifeTime, .raise = request, .end = request};
}

std::optional<Provocation> sync_length(Context& context) {
  if (!has(context, object::kSyncOverflow)) return std::nullopt;
  const std::uint32_t sync = sync_identifier(context);
  const bool counted = context.read(object::kSyncOverflow).number() != 0;
  const auto say = [session = &context.session(), sync](bool counter) {
    session->send({.id = sync, .length = static_cast<std::uint8_t>(counter ? 1 : 0), .data = {1}});
  };
  return Provocation{.name = "a SYNC has an unexpected length",
                     .code = 0x8240,
                     .raise = [say, counted] { say(!counted); },
                     .end = [say, counted] { say(counted); }};
}

std::optional<Provocation> short_rpdo(Context& context) {
  if (!context.manners().refuses_operational.empty()) return std::nullopt;
  const auto made_of = [&context](const canopen::Frame& good, bool ends) {
    // Without data it has no values to process, whatever it is mapped to.
    Provocation how{.name = fmt::format("RPDO {:03X}h has no data", good.id), .code = 0x8210};
    how.raise = [&context, id = good.id] {
      context.session().command(canopen::NmtCommand::Start);
      context.session().send({.id = id});
    };
    if (ends) how.end = [&context, good] { context.session().send(good); };
    return how;
  };
  for (const ValidPdo& rpdo : valid_pdos(context, object::kRpdoParameter)) {
    if (const auto good = unchanged(context, rpdo)) return made_of(*good, true);
    if (context.read(static_cast<std::uint16_t>(rpdo.parameters + 0x200)).number() != 0)
      return made_of({.id = rpdo.identifier}, false);
  }
  return std::nullopt;
}

std::optional<Emergency> bring_about(Context& context, const Provoked& provoked, canopen::Duration patience) {
  context.session().drain();
  context.step();
  const canopen::TimePoint error = context.session().now() + provoked.how.delay;
  provoked.how.raise();
  auto emergency = wait_for_error(context, provoked.identifier, provoked.how.delay + patience);
  if (emergency) note_latency(context, emergency->frame.time - error);
  return emergency;
}

void note_latency(Context& context, canopen::Duration latency) {
  std::optional<canopen::Duration>& longest = context.manners().at_work.emergency_latency;
  longest = std::max(longest.value_or(canopen::Duration::zero()), latency);
}

canopen::Duration emergency_silence(const Context& context) {
  constexpr int kTimesAsLong = 10;
  constexpr canopen::Duration kLeast = kEmergencyPatience / 4;
  const std::optional<canopen::Duration>& longest = context.manners().at_work.emergency_latency;
  return longest ? std::clamp<canopen::Duration>(kTimesAsLong * *longest, kLeast, kEmergencyPatience)
                 : kEmergencyPatience;
}

void end(Context& context, const Provoked& provoked) {
  if (!provoked.how.end) return;
  provoked.how.end();
  // An error whose end is not told may go on.
  if (!wait_for_code(context, provoked.identifier, 0, kEmergencyPatience / 4))
    context.manners().errors_last = true;
}

namespace {

/// The first of @p ways for which the node sends an emergency message.
std::optional<Provoked> try_all(Context& context, std::uint32_t identifier, std::span<const Way> ways) {
  for (const Way way : ways) {
    const std::optional<Provocation> how = way(context);
    if (!how) continue;
    Provoked provoked{way, *how, identifier, {}};
    const std::optional<Emergency> emergency = bring_about(context, provoked);
    if (!emergency) continue;
    provoked.emergency = *emergency;
    return provoked;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Provoked> provoke(Context& context, std::span<const Way> ways) {
  Manners& manners = context.manners();
  const std::optional<std::uint32_t> identifier = emcy_identifier(context);
  if (!identifier) {
    context.skip("1014h is not there or invalid: the node sends no emergency messages");
    return std::nullopt;
  }
  const bool resets = context.settings().allow_reset;
  std::optional<Provoked> provoked;
  if (!manners.sends_no_emergency && !(resets && manners.errors_last))
    provoked = try_all(context, *identifier, ways);
  if (!provoked && !manners.sends_no_emergency && resets) {
    if (!context.restart(canopen::NmtCommand::ResetNode)) return std::nullopt;
    context.enter(canopen::NmtState::PreOperational);
    provoked = try_all(context, *identifier, ways);
    manners.errors_last = manners.errors_last || provoked.has_value();
  }
  manners.sends_no_emergency = !provoked && !context.session().ended();
  if (!provoked) context.skip("the node sends no emergency message for any error that the tester can bring about");
  return provoked;
}

}  // namespace conformance
