#include "audit/network/network.hpp"

#include <utility>

#include "audit/base/transfer.hpp"
#include "audit/network/pdo_record.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace audit {

namespace {

namespace object = canopen::object;

using canopen::NmtCommand;
using canopen::NmtState;
using meaning::Role;

constexpr std::uint8_t kCommandBytes = 2;
constexpr std::uint16_t kVerifyConfiguration = 0x1020;  // date and time of the configuration (CiA 301, 7.5.2.22)
constexpr std::uint8_t kToggle = 0x80;
/// A heartbeat that comes so soon after a command may have been under way before it.
constexpr canopen::Duration kUnderWay = std::chrono::milliseconds{20};

/// The state that @p command leads to.
std::optional<NmtState> state_behind(NmtCommand command) noexcept {
  switch (command) {
    case NmtCommand::Start:
      return NmtState::Operational;
    case NmtCommand::Stop:
      return NmtState::Stopped;
    case NmtCommand::EnterPreOperational:
      return NmtState::PreOperational;
    case NmtCommand::ResetNode:
    case NmtCommand::ResetCommunication:
      return NmtState::Initialising;
  }
  return std::nullopt;
}

/// Whether @p node was told to start last: a PDO that it sends then shows that it runs.
bool was_started(const Node& node) noexcept {
  return node.told && node.told->frame.data[0] == static_cast<std::uint8_t>(NmtCommand::Start);
}

/// Whether @p at is an entry that tells devices apart: device type, vendor, product.
bool is_identity(const canopen::sdo::Address& at) noexcept {
  return (at.index == object::kDeviceType && at.sub_index == 0) ||
         (at.index == object::kIdentity && (at.sub_index == 1 || at.sub_index == 2));
}

/// What @p transfer shows of a device that is not that of the EDS of @p node.
std::optional<Misfit> misfit_of(const Node& node, const Transfer& transfer) {
  const eds::EntryFacts* const entry = node.description.find(transfer.at.index, transfer.at.sub_index);
  if (entry == nullptr) return std::nullopt;
  const bool is_missing = transfer.end == Transfer::End::AbortedByServer &&
                          (canopen::AbortCode{transfer.abort_code} == canopen::AbortCode::NoObject ||
                           canopen::AbortCode{transfer.abort_code} == canopen::AbortCode::NoSubIndex);
  if (is_missing) return Misfit{.at = transfer.at, .is_missing = true};
  if (!transfer.is_done() || transfer.is_write || !is_identity(transfer.at) || !entry->initial)
    return std::nullopt;
  const auto expected = entry->initial->at(node.id);
  if (!expected || expected->magnitude == transfer.value) return std::nullopt;
  return Misfit{.at = transfer.at, .value = transfer.value};
}

/// The value of @p transfer; @p description says how much of it counts if that was not told.
std::uint64_t value_in(const Transfer& transfer, const eds::Description& description) noexcept {
  const eds::EntryFacts* const entry = description.find(transfer.at.index, transfer.at.sub_index);
  if (transfer.is_size_told || entry == nullptr || !entry->numeric()) return transfer.value;
  const std::size_t bytes = entry->bytes();
  return bytes >= sizeof transfer.value ? transfer.value : transfer.value & ((std::uint64_t{1} << 8 * bytes) - 1);
}

/// Whether a frame of @p role comes from the node that it belongs to.
bool is_of_node(Role role) noexcept {
  return role == Role::Tpdo || role == Role::SdoResponse || role == Role::Emergency || role == Role::ErrorControl;
}

}  // namespace

std::optional<std::uint64_t> Node::value(std::uint16_t index, std::uint8_t sub_index) const {
  if (const auto heard = values.find(index, sub_index)) return heard;
  const bool is_default = boot_up && (has_default_pdos || !pdo_at(index));
  const eds::EntryFacts* const entry = is_default ? description.find(index, sub_index) : nullptr;
  if (entry == nullptr || !entry->initial || !entry->numeric()) return std::nullopt;
  const auto value = entry->initial->at(id);
  if (!value) return std::nullopt;
  return value->negative ? std::uint64_t{0} - value->magnitude : value->magnitude;
}

Network::Network() {
  for (std::size_t i = 0; i < kNodes; ++i) nodes_[i].id = static_cast<std::uint8_t>(i);
}

void Network::describe(eds::Description description) {
  Node& node = nodes_[description.node_id() & (kNodes - 1)];
  node.description = std::move(description);
  node.values = {};
  ++node.changes;
}

void Network::follow(const Passage& passage, const Transfer* transfer) {
  const Role role = passage.meaning.role;
  if (role == Role::Nmt) return follow_command(passage.heard);
  Node& node = nodes_[passage.meaning.node & (kNodes - 1)];
  const bool is_sent = is_of_node(role) && !passage.frame().remote;
  if (is_sent) node.is_there = true;
  if (is_sent && role == Role::Emergency) node.has_sent_emcy = true;
  const bool has_answered = is_sent && (role == Role::SdoResponse || role == Role::Tpdo);
  if (has_answered && node.resets && node.told && passage.at() > node.told->at + kUnderWay) {
    node.resets = false;  // its boot-up message was not heard
    node.state.reset();
  }
  if (role == Role::Tpdo && !passage.frame().remote) follow_tpdo(node, passage);
  if (role == Role::ErrorControl) follow_error_control(node, passage.heard);
  if (transfer != nullptr) follow_transfer(node, *transfer);
}

void Network::follow_tpdo(Node& node, const Passage& passage) {
  if (was_started(node)) node.state = NmtState::Operational;
  const PdoRecord record{.is_receive = false, .number = passage.meaning.number};
  const std::uint64_t bit = Node::bit_of(record.number);
  if (node.has_sent_tpdo(record.number) || bit == 0) return;
  node.seen_tpdos |= bit;
  if (node.values.find(record.mapping(), 0)) return;
  const auto objects = mapping_of(node, record);
  if (!objects || bytes_of(*objects) == passage.frame().length) return;
  node.has_default_pdos = false;
  ++node.changes;
}

void Network::follow_command(const Heard& heard) {
  if (heard.frame.length != kCommandBytes || heard.frame.remote) return;
  const auto order = static_cast<NmtCommand>(heard.frame.data[0]);
  const std::uint8_t id = heard.frame.data[1];
  if (id != 0 && id < kNodes) return command(nodes_[id], order, heard);
  if (id == 0)
    for (std::size_t i = 1; i < kNodes; ++i) command(nodes_[i], order, heard);
}

void Network::command(Node& node, NmtCommand order, const Heard& heard) {
  const auto state = state_behind(order);
  if (!state) return;
  node.told = heard;
  node.state = state;
  if (*state != NmtState::Initialising) return;
  node.resets = true;
  node.values.reset(order == NmtCommand::ResetCommunication);
  ++node.changes;
}

void Network::follow_error_control(Node& node, const Heard& heard) {
  if (heard.frame.length != 1) return;
  const auto state = static_cast<NmtState>(heard.frame.data[0] & ~kToggle);
  if (state != NmtState::Initialising) {
    const bool was_under_way = node.told && heard.at > node.told->at && heard.at - node.told->at < kUnderWay;
    if (!was_under_way) node.state = state;
    node.error_control = heard;
    node.resets = false;
    return;
  }
  if (!node.resets) {  // it has been switched on
    node.values.reset(false);
    ++node.changes;
  }
  node.boot_up = heard;
  node.resets = false;
  node.state = NmtState::PreOperational;
}

void Network::follow_transfer(Node& node, const Transfer& transfer) {
  if (!node.misfit) node.misfit = misfit_of(node, transfer);
  if (!transfer.is_done()) return;
  if (transfer.is_write && transfer.at.index == object::kStoreParameters && transfer.at.sub_index != 0)
    node.values.save();
  if (transfer.is_write && transfer.at.index == object::kRestoreParameters && transfer.at.sub_index != 0)
    node.values.forget_saved(transfer.at.sub_index);
  if (transfer.at.index == kVerifyConfiguration && transfer.at.sub_index != 0 && transfer.value != 0)
    node.has_default_pdos = false;  // it was configured, and has stored that
  if (transfer.bytes == 0 || transfer.bytes > sizeof transfer.value) return;
  node.values.learn(transfer.at, value_in(transfer, node.description));
  ++node.changes;
}

}  // namespace audit
