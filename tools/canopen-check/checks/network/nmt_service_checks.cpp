#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/process_data.hpp"
#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::NmtCommand;
using canopen::NmtState;

constexpr std::string_view kNoRpdoInPreOperational = "nmt.no-rpdo-in-pre-operational",
                           kNoRpdoInStopped = "nmt.no-rpdo-in-stopped";
constexpr std::uint32_t kSegmentWithoutTransfer = 0x05040001;
/// How long something must not come.
constexpr canopen::Duration kQuiet = std::chrono::milliseconds{100};

/// TPDOs that come in @p state within kQuiet, with SYNC and on request, @p pause after it was commanded. @p rpdo
/// is sent too, if it is given.
std::vector<TimedFrame> tpdos_in(Context& context, NmtState state, const std::vector<ValidPdo>& tpdos,
                                 canopen::Duration pause, const std::optional<HarmlessRpdo>& rpdo = {}) {
  constexpr int kSyncs = 3;
  const std::uint32_t sync = sync_identifier(context);
  Session& session = context.session();
  context.enter(state);
  session.pass(pause);
  context.step();
  if (rpdo) session.send(rpdo->frame);
  for (int i = 0; i < kSyncs; ++i) session.send({.id = sync});
  if (session.carries_remote_frames())
    for (const ValidPdo& tpdo : tpdos) session.send({.id = tpdo.identifier, .length = 8, .remote = true});
  return session.collect([&](const canopen::Frame& frame) { return pdo_of(tpdos, frame) != nullptr; }, kQuiet);
}

/// An RPDO that can be sent beside, for @p check if that is still to come; nothing else is made of it here.
std::optional<HarmlessRpdo> rpdo_for(Context& context, std::string_view check) {
  if (!context.manners().ahead.contains(check)) return std::nullopt;
  std::optional<HarmlessRpdo> rpdo = working_rpdo(context);
  context.unskip();
  return rpdo;
}

/// Keeps that @p rpdo had no effect in @p state, if it had none.
void remember(Context& context, NmtState state, const HarmlessRpdo& rpdo) {
  context.enter(NmtState::PreOperational);
  const SdoAnswer now = context.read(rpdo.index, rpdo.sub_index);
  if (now.done() && now.number() != rpdo.after) context.manners().right.no_rpdo_in.insert(state);
}

/// Findings for TPDOs that come in @p state. What @p rpdo_check looks at is looked at too: both need a silence.
void no_tpdo_in(Context& context, NmtState state, std::string_view rpdo_check) {
  const std::vector<ValidPdo> tpdos = valid_pdos(context, object::kTpdoParameter);
  if (tpdos.empty()) return context.skip("no TPDO is valid");
  const std::optional<HarmlessRpdo> rpdo = rpdo_for(context, rpdo_check);
  std::vector<TimedFrame> found = tpdos_in(context, state, tpdos, context.quiet(kQuiet), rpdo);
  if (found.empty() && rpdo) remember(context, state, *rpdo);
  if (!found.empty()) {  // of a slow node they may be those of before
    context.enter(NmtState::PreOperational);
    found = tpdos_in(context, state, tpdos, kQuiet);
  }
  for (const ValidPdo& tpdo : tpdos)
    if (std::ranges::any_of(found, [&](const TimedFrame& each) { return each.frame.id == tpdo.identifier; }))
      context.fail(Subject{.index = tpdo.parameters}, fmt::format("no TPDO in {}", name_of(state)),
                   fmt::format("a frame {:03X}h", tpdo.identifier));
}

/// A finding if an RPDO is processed in @p state.
void no_rpdo_in(Context& context, NmtState state) {
  if (context.manners().right.no_rpdo_in.contains(state)) return;
  const std::optional<HarmlessRpdo> rpdo = working_rpdo(context);
  if (!rpdo) return;
  Session& session = context.session();
  const std::uint32_t sync = sync_identifier(context);
  context.step();
  context.enter(state);
  session.send(rpdo->frame);
  session.send({.id = sync});
  session.pass(kQuiet);
  context.enter(NmtState::PreOperational);
  const SdoAnswer now = context.read(rpdo->index, rpdo->sub_index);
  if (now.done() && now.number() == rpdo->after)
    context.fail(rpdo->index, rpdo->sub_index, fmt::format("no RPDO is processed in {}", name_of(state)),
                 fmt::format("the value of the RPDO, {:X}h", rpdo->after));
}

void no_tpdo_in_pre_operational(Context& context) {
  no_tpdo_in(context, NmtState::PreOperational, kNoRpdoInPreOperational);
}

void no_tpdo_in_stopped(Context& context) {
  no_tpdo_in(context, NmtState::Stopped, kNoRpdoInStopped);
}

void no_rpdo_in_pre_operational(Context& context) {
  no_rpdo_in(context, NmtState::PreOperational);
}

void no_rpdo_in_stopped(Context& context) {
  no_rpdo_in(context, NmtState::Stopped);
}

void sdo_in_operational(Context& context) {
  if (!context.observe_state()) return;
  context.enter(NmtState::Operational);
  if (context.state() != NmtState::Operational) return context.skip("the node does not enter Operational");
  (void)context.number(object::kDeviceType);
}

void no_sdo_in_stopped(Context& context) {
  if (!context.observe_state()) return;
  Session& session = context.session();
  context.enter(NmtState::Stopped);
  if (context.state() != NmtState::Stopped) return context.skip("the node does not enter Stopped");
  context.step();
  session.drain();
  session.send(context.sdo().request(0x40, object::kDeviceType));
  if (const auto answer = context.sdo().listen(std::min(context.settings().patience, context.quiet(2 * kQuiet))))
    context.fail("no answer to an upload of 1000h in Stopped",
                 "the answer " + hexadecimal(std::span{answer->data}.first(answer->length)));
}

/// Begins a transfer that needs another request; false if no object is known for it.
bool begin_transfer(Context& context) {
  constexpr std::uint8_t kUpload = 0x40, kDownloadAnnounced = 0x21;
  constexpr std::uint8_t kExpedited = 0x02;
  for (const std::uint16_t index : std::array<std::uint16_t, 3>{0x1008, 0x1009, 0x100A}) {
    const auto answer = context.sdo().exchange(context.sdo().request(kUpload, index));
    if (answer && !abort_code(*answer) && (answer->data[0] & kExpedited) == 0) return true;
  }
  const auto answer =
      context.sdo().exchange(context.sdo().request(kDownloadAnnounced, object::kHeartbeatTime, 0, 2));
  return answer && !abort_code(*answer);
}

void reset_ends_transfers(Context& context) {
  constexpr std::uint8_t kUploadSegment = 0x60;
  if (!begin_transfer(context)) return context.skip("no transfer in segments can be begun");
  if (!context.restart(NmtCommand::ResetCommunication)) return;
  context.enter(NmtState::PreOperational);
  // Which code refuses a segment without a transfer is a matter of the SDO checks.
  const auto answer = context.sdo().exchange(context.sdo().request(kUploadSegment));
  if (answer && !abort_code(*answer))
    context.fail("abort " + meaning::abort_text(kSegmentWithoutTransfer) + " for a segment after the reset",
                 "the transfer goes on: " + hexadecimal(std::span{answer->data}.first(answer->length)));
  (void)context.number(object::kDeviceType);
}

void reset_communication_restores(Context& context) {
  constexpr std::uint64_t kOne = 250, kOther = 300;  // ms
  if (!context.need(object::kHeartbeatTime) || !context.restart(NmtCommand::ResetNode)) return;
  context.enter(NmtState::PreOperational);
  const std::optional<std::uint64_t> before = context.number(object::kHeartbeatTime);
  if (!before) return;
  const std::uint64_t other = *before == kOne ? kOther : kOne;
  if (!context.write_number(object::kHeartbeatTime, 0, other).done())
    return context.skip("1017h cannot be changed");
  if (!context.restart(NmtCommand::ResetCommunication)) return;
  context.enter(NmtState::PreOperational);
  const std::optional<std::uint64_t> now = context.number(object::kHeartbeatTime);
  if (now && *now != *before)
    context.fail(object::kHeartbeatTime, 0, fmt::format("{} again after a reset of the communication", *before),
                 fmt::format("{}", *now));
}

/// An entry of the application whose value has been changed by one.
struct Changed {
  std::uint16_t index;
  std::uint8_t sub_index;
  std::uint64_t before, after;
};

/// Objects of profiles first: what they mean is known. Others of the maker may be orders.
std::vector<const eds::EntryFacts*> candidates(const Context& context) {
  constexpr std::uint16_t kApplication = 0x2000, kProfiles = 0x6000, kEnd = 0xA000;
  std::vector<const eds::EntryFacts*> found;
  for (const eds::EntryFacts& entry : context.eds().entries())
    if (entry.index >= kApplication && entry.index < kEnd && entry.readable() && entry.writable() &&
        entry.numeric() && !entry.no_read && entry.type->kind != eds::ValueKind::Real &&
        write_refusal(entry, context.settings()) == nullptr)
      found.push_back(&entry);
  std::stable_partition(found.begin(), found.end(),
                        [](const eds::EntryFacts* each) { return each->index >= kProfiles; });
  return found;
}

std::optional<Changed> change_one(Context& context) {
  constexpr std::size_t kMostTried = 10;
  std::size_t tried = 0;
  for (const eds::EntryFacts* entry : candidates(context)) {
    if (++tried > kMostTried) break;
    const SdoAnswer before = context.read(entry->index, entry->sub_index);
    if (!before.done()) continue;
    const std::uint64_t one = before.number() ^ 1U;
    const bool taken = context.write_number(entry->index, entry->sub_index, one).done() &&
                       context.read(entry->index, entry->sub_index).number() == one;
    if (taken) return Changed{entry->index, entry->sub_index, before.number(), one};
  }
  context.skip("no object of the application was found that can be changed");
  return std::nullopt;
}

void resets_of_application(Context& context) {
  if (!context.restart(NmtCommand::ResetNode)) return;
  context.enter(NmtState::PreOperational);
  const std::optional<Changed> changed = change_one(context);
  if (!changed || !context.restart(NmtCommand::ResetCommunication)) return;
  context.enter(NmtState::PreOperational);
  std::optional<std::uint64_t> now = context.number(changed->index, changed->sub_index);
  if (now && *now != changed->after)
    return context.fail(changed->index, changed->sub_index,
                        fmt::format("{:X}h still after a reset of the communication", changed->after),
                        fmt::format("{:X}h", *now));
  if (!context.restart(NmtCommand::ResetNode)) return;
  context.enter(NmtState::PreOperational);
  now = context.number(changed->index, changed->sub_index);
  if (now && *now != changed->before)
    context.fail(changed->index, changed->sub_index,
                 fmt::format("{:X}h again after a reset of the node", changed->before),
                 fmt::format("{:X}h", *now));
}

constexpr std::array kChecks{
    Check{.id = "nmt.no-tpdo-in-pre-operational",
          .name = "No TPDO is sent in Pre-operational",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Nmt,
          .run = no_tpdo_in_pre_operational},
    Check{.id = kNoRpdoInPreOperational,
          .name = "No RPDO is processed in Pre-operational",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Nmt,
          .run = no_rpdo_in_pre_operational},
    Check{.id = "nmt.sdo-in-operational",
          .name = "SDO requests are answered in Operational",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Nmt,
          .run = sdo_in_operational},
    Check{.id = "nmt.no-tpdo-in-stopped",
          .name = "No TPDO is sent in Stopped",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Nmt,
          .run = no_tpdo_in_stopped},
    Check{.id = kNoRpdoInStopped,
          .name = "No RPDO is processed in Stopped",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Nmt,
          .run = no_rpdo_in_stopped},
    Check{.id = "nmt.no-sdo-in-stopped",
          .name = "SDO requests are not answered in Stopped",
          .clause = "CiA 301 7.3.2.2.5",
          .group = Group::Nmt,
          .run = no_sdo_in_stopped},
    Check{.id = "nmt.reset-during-sdo",
          .name = "A reset ends an SDO transfer, and the server works afterwards",
          .clause = "CiA 301 7.3.2.2.3",
          .group = Group::Nmt,
          .run = reset_ends_transfers},
    Check{.id = "nmt.reset-communication-objects",
          .name = "A reset of the communication brings back the objects of the communication",
          .clause = "CiA 301 7.3.2.2.3",
          .group = Group::Nmt,
          .run = reset_communication_restores},
    Check{.id = "nmt.reset-application-objects",
          .name =
              "A reset of the node brings back the objects of the application, one of the communication does not",
          .clause = "CiA 301 7.3.2.2.2",
          .group = Group::Nmt,
          .run = resets_of_application},
};

}  // namespace

std::span<const Check> nmt_service_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
