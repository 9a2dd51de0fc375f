#include "meaning/cob_ids.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/base/object_index.hpp"

namespace meaning {
namespace {

namespace object = canopen::object;

constexpr std::uint32_t kNodeBits = 0x7F;
constexpr std::uint32_t kLssRequest = 0x7E5, kLssResponse = 0x7E4;

/// A row of the predefined connection set: the identifier is that of the row and the node-ID.
struct Predefined {
  std::uint32_t function;
  Role role;
  std::uint16_t number;
};
constexpr std::array kPredefined{
    Predefined{0x080, Role::Emergency, 0},  Predefined{0x180, Role::Tpdo, 1},
    Predefined{0x200, Role::Rpdo, 1},       Predefined{0x280, Role::Tpdo, 2},
    Predefined{0x300, Role::Rpdo, 2},       Predefined{0x380, Role::Tpdo, 3},
    Predefined{0x400, Role::Rpdo, 3},       Predefined{0x480, Role::Tpdo, 4},
    Predefined{0x500, Role::Rpdo, 4},       Predefined{0x580, Role::SdoResponse, 1},
    Predefined{0x600, Role::SdoRequest, 1}, Predefined{0x700, Role::ErrorControl, 0},
};

Meaning predefined(std::uint32_t identifier) noexcept {
  if (identifier == 0) return {Role::Nmt};
  if (identifier == canopen::function_code::kSync) return {Role::Sync};
  if (identifier == canopen::function_code::kTime) return {Role::Time};
  if (identifier == kLssRequest) return {Role::LssRequest};
  if (identifier == kLssResponse) return {Role::LssResponse};
  const auto row = std::ranges::find(kPredefined, identifier & ~kNodeBits, &Predefined::function);
  const auto node = static_cast<std::uint8_t>(identifier & kNodeBits);
  if (row == kPredefined.end() || node == 0) return {};
  return {row->role, node, row->number};
}

/// Entries that hold COB-IDs: objects from `first` to `last`, one of a PDO or server each.
struct CobIdEntry {
  std::uint16_t first, last;
  std::uint8_t sub_index;
  Role role;
  bool is_of_node;
};
constexpr std::array kCobIdEntries{
    CobIdEntry{object::kCobIdSync, object::kCobIdSync, 0, Role::Sync, false},
    CobIdEntry{object::kCobIdTime, object::kCobIdTime, 0, Role::Time, false},
    CobIdEntry{object::kCobIdEmcy, object::kCobIdEmcy, 0, Role::Emergency, true},
    CobIdEntry{object::kSdoServer, 0x127F, 1, Role::SdoRequest, true},
    CobIdEntry{object::kSdoServer, 0x127F, 2, Role::SdoResponse, true},
    CobIdEntry{object::kRpdoParameter, 0x15FF, 1, Role::Rpdo, true},
    CobIdEntry{object::kTpdoParameter, 0x19FF, 1, Role::Tpdo, true},
};

/// The service whose COB-ID stands at @p at of @p node.
std::optional<Meaning> service_at(std::uint8_t node, const canopen::sdo::Address& at) noexcept {
  for (const CobIdEntry& row : kCobIdEntries) {
    if (at.index < row.first || at.index > row.last || at.sub_index != row.sub_index) continue;
    const bool is_numbered = row.first != row.last;
    const auto number = static_cast<std::uint16_t>(is_numbered ? at.index - row.first + 1 : 0);
    return Meaning{row.role, row.is_of_node ? node : std::uint8_t{0}, number};
  }
  return std::nullopt;
}

/// The identifier in @p cob_id of a service of @p role; 0: none.
canopen::Identifier identifier_of(Role role, std::uint32_t cob_id) noexcept {
  const bool may_be_invalid = role != Role::Sync && role != Role::Time;
  return may_be_invalid ? canopen::valid_identifier(cob_id) : canopen::identifier_in(cob_id);
}

}  // namespace

canopen::Identifier predefined_tpdo(std::uint8_t node, std::uint16_t number) noexcept {
  for (const Predefined& row : kPredefined)
    if (row.role == Role::Tpdo && row.number == number) return row.function + node;
  return 0;
}

void CobIds::describe(const eds::Description& description) {
  for (const eds::EntryFacts& entry : description.entries()) {
    const auto service = service_at(description.node_id(), {entry.index, entry.sub_index});
    if (!service || !entry.initial) continue;
    const auto value = entry.initial->at(description.node_id());
    if (value && !value->negative)
      given_.identifiers[*service] = described_.identifiers[*service] =
          identifier_of(service->role, static_cast<std::uint32_t>(value->magnitude));
  }
  saved_ = given_;
  index();
}

void CobIds::index() {
  services_.clear();
  for (const auto& [service, identifier] : given_.identifiers)
    if (identifier != 0) take_in(service, identifier);
}

/// Of services with one identifier the first is meant: a TPDO before the RPDO of who listens to it.
void CobIds::take_in(const Meaning& service, canopen::Identifier identifier) {
  const auto [row, is_new] = services_.try_emplace(identifier, Service{service});
  if (is_new) return;
  Service& known = row->second;
  known.is_shared = known.is_shared || (known.meaning.role == Role::Rpdo && service.role == Role::Rpdo);
  known.meaning = std::min(known.meaning, service);
}

Meaning CobIds::meaning_of(const canopen::Frame& frame) const noexcept {
  Meaning meaning;
  if (const auto found = services_.find(canopen::identifier_of(frame)); found != services_.end()) {
    meaning = found->second.meaning;
  } else if (!frame.extended) {
    meaning = predefined(frame.id);
    // What an EDS has as invalid and is on the bus all the same was made valid before the log begins.
    const auto moved = given_.identifiers.find(meaning);
    if (moved != given_.identifiers.end() && moved->second != 0) meaning = {};
  }
  if (meaning.role == Role::Rpdo && !frame.extended) {  // of a node that listens to the TPDO of another one
    const Meaning sent = predefined(frame.id);
    const bool is_of_node = sent.role == Role::Tpdo || sent.role == Role::Emergency;
    if (is_of_node && !given_.identifiers.contains(sent)) meaning = sent;
  }
  if (meaning.role == Role::ErrorControl && frame.remote) meaning.role = Role::Guarding;
  return meaning;
}

bool CobIds::is_shared(const canopen::Frame& frame) const noexcept {
  const auto found = services_.find(canopen::identifier_of(frame));
  return found != services_.end() && found->second.is_shared;
}

std::optional<EntryValue> CobIds::follow(const canopen::Frame& frame, const Meaning& meaning) {
  const SdoChannel channel{meaning.node, meaning.number};
  std::optional<EntryValue> entry;
  switch (meaning.role) {
    case Role::SdoRequest:
      sdo_.take_request(channel, frame);
      break;
    case Role::SdoResponse:
      entry = sdo_.take_response(channel, frame);
      if (entry) learn(*entry);
      break;
    case Role::Nmt:
      if (frame.data[0] == static_cast<std::uint8_t>(canopen::NmtCommand::ResetNode) ||
          frame.data[0] == static_cast<std::uint8_t>(canopen::NmtCommand::ResetCommunication))
        reset(frame.data[1]);
      break;
    case Role::ErrorControl:
      if (frame.length == 1 && frame.data[0] == 0) reset(meaning.node);  // a boot-up message: it may have been off
      break;
    default:
      break;
  }
  return entry;
}

void CobIds::learn(const EntryValue& entry) {
  const bool is_order = entry.is_write && entry.at.sub_index != 0;
  if (is_order && entry.at.index == object::kStoreParameters) copy(given_, saved_, entry.node);
  if (is_order && entry.at.index == object::kRestoreParameters) copy(described_, saved_, entry.node);
  if (const auto service = service_at(entry.node, entry.at))
    give(*service, identifier_of(service->role, entry.value));
}

void CobIds::give(const Meaning& service, canopen::Identifier identifier) {
  const canopen::Identifier before = std::exchange(given_.identifiers[service], identifier);
  if (before == identifier) return;
  if (before != 0) return index();
  take_in(service, identifier);
}

void CobIds::copy(const Given& from, Given& to, std::uint8_t node) {
  const auto is_of_node = [node](const auto& item) { return node == 0 || item.first.node == node; };
  std::erase_if(to.identifiers, is_of_node);
  for (const auto& item : from.identifiers)
    if (is_of_node(item)) to.identifiers.insert(item);
}

void CobIds::reset(std::uint8_t node) {
  if (given_ == saved_) return;
  copy(saved_, given_, node);
  index();
}

}  // namespace meaning
