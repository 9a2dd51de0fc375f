#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/error/calm.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/provocation.hpp"
#include "tools/canopen-check/checks/shared/stations.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint32_t kParameterIncompatible = 0x06040043;

/// A watched heartbeat, and where its loss would be told; else the check is skipped.
struct Watched {
  Provocation how;
  std::uint32_t emcy;
};
std::optional<Watched> watch(Context& context) {
  if (!context.need(object::kConsumerHeartbeatTime, 1)) return std::nullopt;
  const std::optional<std::uint32_t> identifier = emcy_identifier(context);
  const std::optional<Provocation> how = heartbeat_loss(context);
  if (identifier && how) return Watched{*how, *identifier};
  context.skip(identifier ? "1016h:01 takes no node-ID that is free" : "1014h is not there or invalid");
  return std::nullopt;
}

void refuses_a_node_twice(Context& context) {
  constexpr std::uint64_t kTime = 1000, kOtherTime = 500;  // ms
  if (!context.need(object::kConsumerHeartbeatTime, 2)) return;
  const std::optional<std::uint8_t> node = unused_node_id(context);
  if (!node) return context.skip("every node-ID is taken by another station");
  const std::uint64_t word = std::uint64_t{*node} << 16U;
  if (!context.set(object::kConsumerHeartbeatTime, 1, word | kTime)) return;
  context.step();
  context.expect_abort(context.write_number(object::kConsumerHeartbeatTime, 2, word | kOtherTime),
                       {kParameterIncompatible}, object::kConsumerHeartbeatTime, 2,
                       fmt::format("node {} a second time", *node));
}

void waits_for_the_first_heartbeat(Context& context) {
  if (context.manners().right.consumer_begins) return;
  const std::optional<Watched> watched = watch(context);
  if (!watched) return;
  context.step();
  const auto emergency = wait_for_error(context, watched->emcy, watched->how.delay + kEmergencyPatience);
  if (emergency)
    context.fail(object::kConsumerHeartbeatTime, 1, "no loss before the first heartbeat",
                 "emergency message " + to_text(*emergency));
}

void tells_the_loss(Context& context) {
  const std::optional<Watched> watched = watch(context);
  if (!watched) return;
  const Provocation& how = watched->how;
  context.step();
  const canopen::TimePoint begin = context.session().now();
  how.raise();
  const auto emergency = wait_for_error(context, watched->emcy, how.delay + kEmergencyPatience);
  if (!emergency)
    return context.fail(object::kConsumerHeartbeatTime, 1, "an emergency message when " + how.name,
                        "none within " + milliseconds(how.delay + kEmergencyPatience));
  const canopen::Duration time = emergency->frame.time - begin;
  context.manners().at_work.tells_heartbeat_loss = true;
  note_latency(context, time - how.delay);
  how.end();  // for the check of the return
  context.manners().right.consumer_return = wait_for_code(context, watched->emcy, 0, how.delay / 2).has_value();
  context.note(fmt::format("{}: told after {}", how.name, milliseconds(time)));
  if (time < how.delay && !context.about(time, how.delay))
    context.fail(object::kConsumerHeartbeatTime, 1, "a loss not before " + milliseconds(how.delay),
                 "after " + milliseconds(time));
}

void tells_the_return(Context& context) {
  if (context.manners().right.consumer_return) return;
  const std::optional<Watched> watched = watch(context);
  if (!watched) return;
  const Provocation& how = watched->how;
  context.step();
  how.raise();
  if (!wait_for_error(context, watched->emcy, how.delay + kEmergencyPatience))
    return context.skip("the loss of a heartbeat is not told");
  how.end();
  if (!wait_for_code(context, watched->emcy, 0, how.delay / 2))
    context.fail(object::kConsumerHeartbeatTime, 1, "emergency message 0000h when the heartbeat is back", "none");
}

constexpr std::array kChecks{
    Check{.id = "error-control.consumer-node-twice",
          .name = "1016h refuses a node-ID that another entry watches",
          .clause = "CiA 301 7.5.2.19",
          .group = Group::ErrorControl,
          .run = refuses_a_node_twice},
    Check{.id = kConsumerBegins,
          .name = "A heartbeat is watched from its first frame on",
          .clause = "CiA 301 7.2.8.3.2.2",
          .group = Group::ErrorControl,
          .run = waits_for_the_first_heartbeat},
    Check{.id = "error-control.consumer-loss",
          .name = "The loss of a watched heartbeat is told by an emergency message, and not too early",
          .clause = "CiA 301 7.2.7.1",
          .group = Group::ErrorControl,
          .run = tells_the_loss},
    Check{.id = "error-control.consumer-return",
          .name = "The return of a watched heartbeat is told by emergency message 0000h",
          .clause = "CiA 301 7.2.7.1",
          .group = Group::ErrorControl,
          .run = tells_the_return},
};

}  // namespace

std::span<const Check> heartbeat_consumer_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
