#include "libcanopen/lss/lss_slave.hpp"

#include <cassert>
#include <utility>

#include "libcanopen/base/node_id.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/lss/request.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {

namespace command = lss::command;

namespace {
constexpr NmtStates kStatesOfLss{NmtState::Unconfigured, NmtState::Stopped, NmtState::PreOperational,
                                 NmtState::Operational};
}  // namespace

LssSlave::LssSlave(Context& context, LssApplication& application)
    : Service{context, {.lives_in = kStatesOfLss, .identifiers = 2}}, application_{application} {}

LssSettings LssSlave::settings() const noexcept {
  return {.node_id = context_.pending_node_id, .bit_rate = bit_rate_};
}

void LssSlave::list_identifiers(IdentifierList& list) const noexcept {
  list.hears(lss::kRequests);
  list.sends(lss::kAnswers);
}

void LssSlave::reload(Reload how) noexcept {
  if (how != Reload::Afresh) return;
  state_ = LssState::Waiting;
  awaited_ = 0;
  scanned_ = 0;
  is_storing_ = false;
}

void LssSlave::on_frame(const Frame& frame, std::size_t) noexcept {
  if (frame.length != lss::kBytes) return;
  const std::uint8_t awaited = std::exchange(awaited_, std::uint8_t{0});
  if (frame.data[0] != command::kStore) is_storing_ = false;
  switch (frame.data[0]) {
    case command::kSwitchGlobal:
      return switch_to(frame.data[1]);
    case command::kIdentifyUnconfigured:
      if (is_unconfigured()) answer(command::kIsUnconfigured);
      return;
    case command::kFastscan:
      return scan(frame);
    default:
      break;
  }
  if (const lss::Part* const part = lss::part_of(frame.data[0])) return take_part(*part, frame, awaited);
  if (state_ == LssState::Configuration) configure(frame);
}

void LssSlave::switch_to(std::uint8_t mode) noexcept {
  const bool was_configured = state_ == LssState::Configuration;
  if (mode == static_cast<std::uint8_t>(LssState::Configuration)) state_ = LssState::Configuration;
  if (mode != static_cast<std::uint8_t>(LssState::Waiting)) return;
  state_ = LssState::Waiting;
  const bool has_got_a_node_id = context_.state == NmtState::Unconfigured && is_node_id(context_.pending_node_id);
  if (was_configured && has_got_a_node_id) context_.nmt.reset(NmtCommand::ResetCommunication);
}

/// A request of a sequence counts if it is the first one, or the one @p awaited.
void LssSlave::take_part(const lss::Part& part, const Frame& frame, std::uint8_t awaited) noexcept {
  const bool selects = part.command < command::kSelected;
  const bool is_first = part.command == command::kSelectFirst || part.command == command::kIdentifyFirst;
  if (selects && state_ != LssState::Waiting) return;
  if (!is_first && part.command != awaited) return;
  if (!lss::fits(part, identity(part.sub_index), load<std::uint32_t>(&frame.data[1]))) return;
  if (part.answer == 0) {
    awaited_ = static_cast<std::uint8_t>(part.command + 1);
    return;
  }
  if (selects) state_ = LssState::Configuration;
  answer(part.answer);
}

/// Fastscan finds one node without a node-ID, bit by bit of its identity, and selects it.
void LssSlave::scan(const Frame& frame) noexcept {
  if (state_ != LssState::Waiting || !is_unconfigured()) return;
  const lss::Fastscan request{frame};
  if (request.lowest_bit == lss::Fastscan::kRestart) {
    scanned_ = 0;
    return answer(command::kIdentified);
  }
  if (request.is_void() || request.position != scanned_) return;
  if (!request.fits(identity(static_cast<std::uint8_t>(scanned_ + 1)))) return;
  if (request.lowest_bit == 0) {
    scanned_ = request.next;
    if (request.next < request.position) state_ = LssState::Configuration;
  }
  answer(command::kIdentified);
}

void LssSlave::configure(const Frame& frame) noexcept {
  const std::uint8_t asked = frame.data[0];
  switch (asked) {
    case command::kConfigureNodeId:
      return take_node_id(frame.data[1]);
    case command::kConfigureBitTiming:
      return take_bit_rate(frame.data[1], frame.data[2]);
    case command::kActivateBitTiming:
      return application_.on_lss_activate(bit_rate_,
                                          std::chrono::milliseconds{load<std::uint16_t>(&frame.data[1])});
    case command::kStore:
      return store();
    case command::kInquireNodeId:
      return answer(asked, context_.dictionary.node_id());
    default:
      break;
  }
  if (asked >= command::kInquireFirst && asked < command::kInquireFirst + lss::kNumbers)
    answer(asked, identity(static_cast<std::uint8_t>(asked - command::kInquireFirst + 1)));
}

void LssSlave::take_node_id(std::uint8_t node_id) noexcept {
  const bool is_allowed = is_node_id(node_id) || node_id == kNoNodeId;
  if (is_allowed) context_.pending_node_id = node_id;
  answer(command::kConfigureNodeId, is_allowed ? lss::kDone : lss::kRefused);
}

/// There is one table, that of CiA 305.
void LssSlave::take_bit_rate(std::uint8_t table, std::uint8_t index) noexcept {
  const auto rate = table == 0 ? lss::bit_rate_of(index) : std::nullopt;
  if (rate) bit_rate_ = *rate;
  answer(command::kConfigureBitTiming, rate ? lss::kDone : lss::kRefused);
}

/// The same request again while the answer is put off is a master's impatience.
void LssSlave::store() noexcept {
  if (is_storing_) return;
  is_storing_ = true;
  const LssStored result = application_.on_lss_store(settings());
  if (result != LssStored::Later) answer_store(result);
}

void LssSlave::answer_store(LssStored result) noexcept {
  assert(result != LssStored::Later);
  if (std::exchange(is_storing_, false)) answer(command::kStore, static_cast<std::uint8_t>(result));
}

/// The node has no node-ID, and will not have one when it goes on.
bool LssSlave::is_unconfigured() const noexcept {
  return context_.dictionary.node_id() == kNoNodeId && context_.pending_node_id == kNoNodeId;
}

std::uint32_t LssSlave::identity(std::uint8_t sub_index) const noexcept {
  return static_cast<std::uint32_t>(context_.dictionary.stored(object::kIdentity, sub_index).value_or(0));
}

void LssSlave::answer(std::uint8_t command, std::uint32_t value) noexcept {
  Frame frame = frame_under(lss::kAnswers, lss::kBytes);
  frame.data[0] = command;
  canopen::store(&frame.data[1], value);
  context_.sink->send(frame, Delivery::Ordered);
}

}  // namespace canopen
