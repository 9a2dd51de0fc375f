#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/stations.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::NmtCommand;
using canopen::NmtState;

constexpr canopen::Duration kQuiet = std::chrono::milliseconds{200};

void boots_after(Context& context, NmtCommand command) {
  if (const auto time = context.reset(command)) context.note("boot-up after " + milliseconds(*time));
}

void boots_after_reset_node(Context& context) {
  boots_after(context, NmtCommand::ResetNode);
}

void boots_after_reset_communication(Context& context) {
  boots_after(context, NmtCommand::ResetCommunication);
}

void boots_once(Context& context) {
  if (!context.may_reset()) return;
  if (context.manners().boots_without_message) return context.skip("the node sends no boot-up message");
  Session& session = context.session();
  context.step();
  session.drain();
  session.command(NmtCommand::ResetNode);
  const auto first =
      session.wait_for(under(session.identifier(function_code::kErrorControl)), context.settings().boot_up_limit);
  if (!first) return context.skip("the node sends no boot-up message");
  if (first->frame.length != 1 || first->frame.data[0] != 0)
    context.fail("a boot-up message of one byte, 00h",
                 fmt::format("{} bytes, the first {:02X}h", first->frame.length, first->frame.data[0]));
  const auto others = session.collect(
      [id = session.identifier(function_code::kErrorControl)](const canopen::Frame& frame) {
        return frame.id == id && !frame.remote && frame.length >= 1 && frame.data[0] == 0;
      },
      kQuiet);
  if (!others.empty()) context.fail("one boot-up message", fmt::format("{}", 1 + others.size()));
}

/// True if 1F80h lets the node enter Operational by itself (CiA 302-2).
bool starts_by_itself(Context& context) {
  constexpr std::uint64_t kWaits = 1U << 2U;
  if (!context.eds().empty() && !context.eds().has(object::kNmtStartup)) return false;
  const SdoAnswer startup = context.read(object::kNmtStartup);
  return startup.done() && (startup.number() & kWaits) == 0;
}

void pre_operational_after_boot_up(Context& context) {
  const bool may_start = starts_by_itself(context);
  if (!context.restart(NmtCommand::ResetNode)) return;
  if (!context.observe_state()) {
    if (context.sdo().upload(0x1000, 0).kind == SdoAnswer::Kind::Silent)
      context.fail("Pre-operational after boot-up", "a state in which SDO requests are not answered");
    return;
  }
  if (may_start && context.state() == NmtState::Operational) return;
  context.expect_state(NmtState::PreOperational, "boot-up");
}

void enters_operational(Context& context) {
  context.step();
  std::string& refusal = context.manners().refuses_operational;
  refusal = refusal_of_operational(context);
  if (!refusal.empty()) context.fail("Operational after Start", refusal);
}

void follows_transitions(Context& context) {
  constexpr std::array kWay{NmtState::Operational,    NmtState::PreOperational, NmtState::Stopped,
                            NmtState::PreOperational, NmtState::Operational,    NmtState::Stopped,
                            NmtState::Operational,    NmtState::Stopped,        NmtState::PreOperational};
  if (!context.observe_state()) return;
  if (!context.expect_state(NmtState::PreOperational, "the command for it")) return;
  NmtState from = NmtState::PreOperational;
  for (const NmtState to : kWay) {
    context.step();
    context.enter(to);
    if (!context.expect_state(to, fmt::format("the command for it in {}", name_of(from)))) return;
    from = to;
  }
}

void resets_in_every_state(Context& context) {
  for (const NmtState state : {NmtState::Operational, NmtState::Stopped}) {
    if (!context.restart(NmtCommand::ResetCommunication)) return;
    context.enter(state);
    for (const NmtCommand command : {NmtCommand::ResetCommunication, NmtCommand::ResetNode}) {
      context.step();
      context.enter(state);
      if (context.restart(command)) continue;
      return context.fail(
          fmt::format("a {} in {}", command == NmtCommand::ResetNode ? "reset of the node" : "reset",
                      name_of(state)),
          "neither a boot-up message nor answers to SDO requests");
    }
  }
}

void obeys_node_id_0(Context& context) {
  if (!alone(context, "a command to all nodes") || !context.observe_state()) return;
  context.step();
  context.rest_on_operational();
  context.session().command_to(0, NmtCommand::Start);
  if (!context.expect_state(NmtState::Operational, "Start to node-ID 0")) return;
  context.session().command_to(0, NmtCommand::EnterPreOperational);
  context.expect_state(NmtState::PreOperational, "Enter Pre-operational to node-ID 0");
}

void ignores_other_node_ids(Context& context) {
  const std::optional<std::uint8_t> other = unused_node_id(context);
  if (!other) return context.skip("every node-ID is taken by another station");
  if (!context.observe_state()) return;
  context.step();
  for (const NmtCommand command : {NmtCommand::Start, NmtCommand::Stop}) {
    context.session().command_to(*other, command);
    if (!context.expect_state(NmtState::PreOperational,
                              fmt::format("command {} to node {}", static_cast<unsigned>(command), *other)))
      return;
  }
}

void ignores_wrong_lengths(Context& context) {
  if (!context.observe_state()) return;
  for (const std::uint8_t length : std::array<std::uint8_t, 4>{0, 1, 3, 8}) {
    context.step();
    context.session().send({.id = 0,
                            .length = length,
                            .data = {static_cast<std::uint8_t>(NmtCommand::Stop), context.session().node_id()}});
    const std::optional<NmtState> state = context.state();
    if (state == NmtState::Stopped) {
      context.note(fmt::format("a Stop of {} bytes is obeyed", length));
      context.enter(NmtState::PreOperational);
    } else if (state != NmtState::PreOperational) {
      context.expect_state(NmtState::PreOperational, fmt::format("a Stop of {} bytes", length));
    }
  }
  context.enter(NmtState::PreOperational);
  context.expect_state(NmtState::PreOperational, "Enter Pre-operational behind commands of wrong lengths");
}

void ignores_unknown_commands(Context& context) {
  if (!context.observe_state()) return;
  for (const std::uint8_t command : std::array<std::uint8_t, 5>{0, 3, 127, 131, 255}) {
    context.step();
    context.session().command(static_cast<NmtCommand>(command));
    if (!context.expect_state(NmtState::PreOperational, fmt::format("command specifier {}", command)))
      context.enter(NmtState::PreOperational);
  }
}

constexpr std::array kChecks{
    Check{.id = "nmt.boot-up-after-reset-node",
          .name = "A reset of the node ends with the boot-up message",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = boots_after_reset_node},
    Check{.id = "nmt.boot-up-after-reset-communication",
          .name = "A reset of the communication ends with the boot-up message",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = boots_after_reset_communication},
    Check{.id = "nmt.boot-up-once",
          .name = "The boot-up message is one frame with one byte, 00h",
          .clause = "CiA 301 7.2.8.3.3",
          .group = Group::Nmt,
          .run = boots_once},
    Check{.id = "nmt.pre-operational-after-boot-up",
          .name = "The node enters Pre-operational after its boot-up message",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = pre_operational_after_boot_up},
    Check{.id = "nmt.operational",
          .name = "The node enters Operational, on which many checks rest",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = enters_operational},
    Check{.id = "nmt.transitions",
          .name = "Start, Stop and Enter Pre-operational are obeyed in every state",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = follows_transitions},
    Check{.id = "nmt.resets-in-every-state",
          .name = "Both resets are obeyed in Operational and in Stopped",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = resets_in_every_state},
    Check{.id = "nmt.node-id-0",
          .name = "Commands to node-ID 0 are obeyed",
          .clause = "CiA 301 7.2.8.3.1",
          .group = Group::Nmt,
          .run = obeys_node_id_0},
    Check{.id = "nmt.other-node-id",
          .name = "Commands to another node-ID have no effect",
          .clause = "CiA 301 7.2.8.3.1",
          .group = Group::Nmt,
          .run = ignores_other_node_ids},
    Check{.id = "nmt.wrong-length",
          .name = "Commands that are not two bytes long are ignored or obeyed, and do no harm",
          .clause = "CiA 301 7.2.8.3.1",
          .group = Group::Nmt,
          .run = ignores_wrong_lengths},
    Check{.id = "nmt.unknown-command",
          .name = "Command specifiers that are reserved have no effect",
          .clause = "CiA 301 7.2.8.3.1",
          .group = Group::Nmt,
          .run = ignores_unknown_commands},
};

}  // namespace

std::span<const Check> nmt_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
