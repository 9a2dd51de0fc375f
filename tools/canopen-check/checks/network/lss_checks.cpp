#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/stations.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

// LSS (CiA 305): identifiers and command specifiers.
constexpr std::uint32_t kMaster = 0x7E5, kSlave = 0x7E4;
constexpr std::uint8_t kSwitchGlobal = 0x04, kSwitchSelective = 0x40, kSwitched = 0x44, kConfigureNodeId = 0x11,
                       kInquireIdentity = 0x5A, kInquireNodeId = 0x5E;
constexpr std::uint8_t kWaiting = 0, kConfiguration = 1;
constexpr std::size_t kNumbers = 4;
constexpr canopen::Duration kPatience = std::chrono::milliseconds{200};

using Identity = std::array<std::uint32_t, kNumbers>;

canopen::Frame request(std::uint8_t command, std::uint32_t value = 0) {
  canopen::Frame frame{.id = kMaster, .length = 8, .data = {command}};
  std::ranges::copy(eds::little_endian(value, 4), frame.data.begin() + 1);
  return frame;
}

std::uint32_t value_of(const canopen::Frame& frame) {
  std::uint32_t value = 0;
  for (std::size_t i = kNumbers; i-- > 0;) value = value << 8U | frame.data[i + 1];
  return value;
}

/// Sends @p frame and gives the answer of the slave.
std::optional<canopen::Frame> ask(Context& context, const canopen::Frame& frame) {
  Session& session = context.session();
  session.drain();
  session.send(frame);
  const auto answer = session.wait_for(under(kSlave), kPatience);
  if (!answer) return std::nullopt;
  return answer->frame;
}

void switch_to_waiting(Context& context) {
  context.session().send(request(kSwitchGlobal, kWaiting));
}

/// The identity of 1018h; nothing, and the check is skipped, where it is not complete or there is no LSS.
std::optional<Identity> identity(Context& context) {
  if (!context.eds().device().lss) {
    context.skip("LSS_Supported is 0 in the EDS");
    return std::nullopt;
  }
  Identity found{};
  for (std::uint8_t sub = 1; sub <= kNumbers; ++sub) {
    if (!context.need(object::kIdentity, sub)) return std::nullopt;
    const std::optional<std::uint64_t> number = context.number(object::kIdentity, sub);
    if (!number) return std::nullopt;
    found[sub - 1U] = static_cast<std::uint32_t>(*number);
  }
  return found;
}

/// The answer to the four requests of a selective switch.
std::optional<canopen::Frame> select(Context& context, const Identity& numbers) {
  switch_to_waiting(context);
  for (std::size_t i = 0; i + 1 < kNumbers; ++i)
    context.session().send(request(static_cast<std::uint8_t>(kSwitchSelective + i), numbers[i]));
  return ask(context, request(kSwitchSelective + kNumbers - 1, numbers[kNumbers - 1]));
}

/// Takes the node to the configuration state; else the check is skipped.
bool configure(Context& context, const Identity& numbers) {
  const auto answer = select(context, numbers);
  if (answer && answer->data[0] == kSwitched) return true;
  context.skip("the node does not enter the configuration state");
  return false;
}

void is_silent_while_waiting(Context& context) {
  if (!identity(context)) return;
  switch_to_waiting(context);
  context.step();
  if (const auto answer = ask(context, request(kInquireNodeId)))
    context.fail("no answer in the waiting state", hexadecimal(answer->data));
}

void is_selected(Context& context) {
  const std::optional<Identity> numbers = identity(context);
  if (!numbers) return;
  context.step();
  const auto answer = select(context, *numbers);
  if (!answer || answer->data[0] != kSwitched)
    context.fail("44h when the node's own identity is selected", answer ? hexadecimal(answer->data) : "no answer");
  switch_to_waiting(context);
}

void is_not_selected(Context& context) {
  const std::optional<Identity> numbers = identity(context);
  if (!numbers) return;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    context.step();
    Identity other = *numbers;
    other[i] ^= 1U;
    if (const auto answer = select(context, other))
      context.fail(object::kIdentity, static_cast<std::uint8_t>(i + 1),
                   "no answer when another number is selected", hexadecimal(answer->data));
  }
  switch_to_waiting(context);
}

void tells_its_identity(Context& context) {
  const std::optional<Identity> numbers = identity(context);
  if (!numbers || !configure(context, *numbers)) return;
  for (std::size_t i = 0; i < kNumbers; ++i) {
    context.step();
    const auto command = static_cast<std::uint8_t>(kInquireIdentity + i);
    const auto answer = ask(context, request(command));
    if (!answer || answer->data[0] != command || value_of(*answer) != (*numbers)[i])
      context.fail(object::kIdentity, static_cast<std::uint8_t>(i + 1),
                   fmt::format("{:08X}h over LSS", (*numbers)[i]),
                   answer ? hexadecimal(answer->data) : "no answer");
  }
  switch_to_waiting(context);
}

void tells_its_node_id(Context& context) {
  const std::optional<Identity> numbers = identity(context);
  if (!numbers || !configure(context, *numbers)) return;
  context.step();
  const auto answer = ask(context, request(kInquireNodeId));
  if (!answer || answer->data[0] != kInquireNodeId || answer->data[1] != context.session().node_id())
    context.fail(fmt::format("node-ID {} over LSS", context.session().node_id()),
                 answer ? hexadecimal(answer->data) : "no answer");
  switch_to_waiting(context);
}

void refuses_wrong_node_ids(Context& context) {
  const std::optional<Identity> numbers = identity(context);
  if (!numbers || !configure(context, *numbers)) return;
  for (const std::uint8_t id : std::array<std::uint8_t, 2>{0, 128}) {
    context.step();
    const auto answer = ask(context, request(kConfigureNodeId, id));
    if (!answer || answer->data[0] != kConfigureNodeId || answer->data[1] == 0)
      context.fail(fmt::format("an error code for node-ID {}", id),
                   answer ? hexadecimal(answer->data) : "no answer");
  }
  // Whatever it has taken, it keeps its own.
  (void)ask(context, request(kConfigureNodeId, context.session().node_id()));
  switch_to_waiting(context);
}

void switches_with_all(Context& context) {
  if (!identity(context) || !alone(context, "a switch of all nodes")) return;
  context.step();
  context.session().send(request(kSwitchGlobal, kConfiguration));
  if (!ask(context, request(kInquireNodeId)))
    context.fail("an answer in the configuration state, which all nodes were switched to", "none");
  switch_to_waiting(context);
  context.step();
  if (ask(context, request(kInquireNodeId)))
    context.fail("no answer in the waiting state, which all nodes were switched to", "an answer");
}

constexpr std::array kChecks{
    Check{.id = "lss.waiting",
          .name = "Inquiries are not answered in the LSS waiting state",
          .clause = "CiA 305 state machine",
          .group = Group::Lss,
          .run = is_silent_while_waiting},
    Check{.id = "lss.switch-selective",
          .name = "The node is selected by its own identity",
          .clause = "CiA 305 switch state selective",
          .group = Group::Lss,
          .run = is_selected},
    Check{.id = "lss.switch-selective-others",
          .name = "The node is not selected by another identity",
          .clause = "CiA 305 switch state selective",
          .group = Group::Lss,
          .run = is_not_selected},
    Check{.id = "lss.switch-global",
          .name = "The node follows the switch of all nodes",
          .clause = "CiA 305 switch state global",
          .group = Group::Lss,
          .run = switches_with_all},
    Check{.id = "lss.inquire-identity",
          .name = "The identity over LSS is that of 1018h",
          .clause = "CiA 305 inquire LSS address",
          .group = Group::Lss,
          .run = tells_its_identity},
    Check{.id = "lss.inquire-node-id",
          .name = "The node-ID over LSS is that under which the node works",
          .clause = "CiA 305 inquire node-ID",
          .group = Group::Lss,
          .run = tells_its_node_id},
    Check{.id = "lss.node-id-refused",
          .name = "Node-IDs 0 and 128 are refused",
          .clause = "CiA 305 configure node-ID",
          .group = Group::Lss,
          .run = refuses_wrong_node_ids},
};

}  // namespace

std::span<const Check> lss_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
