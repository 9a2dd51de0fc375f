#include "libcanopen/pdo/parameters.hpp"

#include <algorithm>

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kPdoNumbers = 512;
constexpr std::uint8_t kLastSyncStart = 240;  // CiA 301, 7.5.2.37

constexpr std::uint16_t base_of(Direction direction) noexcept {
  return direction == Direction::Receive ? 0x1400 : 0x1800;
}

}  // namespace

std::size_t PdoParameters::count_in(const Dictionary& dictionary, Direction direction) noexcept {
  std::size_t pdos = 0;
  for (std::uint16_t number = 0; number < kPdoNumbers; ++number)
    pdos += dictionary.contains(static_cast<std::uint16_t>(base_of(direction) + number)) ? 1U : 0U;
  return pdos;
}

PdoParameters::PdoParameters(Context& context, Direction direction)
    : context_{context},
      direction_{direction},
      communication_base_{base_of(direction)},
      mapping_base_{static_cast<std::uint16_t>(base_of(direction) + kPdoNumbers)} {
  for (std::uint16_t number = 0; number < kPdoNumbers; ++number) {
    const auto index = static_cast<std::uint16_t>(communication_base_ + number);
    if (!context_.dictionary.contains(index)) continue;
    position_[number] = static_cast<std::uint16_t>(pdos_.size());
    pdos_.push_back(PdoSettings{.number = number});
    own(index);
    own(static_cast<std::uint16_t>(mapping_base_ + number));
  }
  give_room();
}

/// Gives every PDO as much room for mapped values as its mapping record has entries.
void PdoParameters::give_room() {
  std::vector<std::size_t> rooms;
  for (const PdoSettings& pdo : pdos_) {
    std::size_t room = 0;
    for (std::uint8_t sub = 1; sub <= kMostMappedObjects; ++sub)
      room += context_.dictionary.find(mapping_index(pdo), sub) ? 1U : 0U;
    rooms.push_back(room);
    values_.resize(values_.size() + room);
  }
  std::size_t first = 0;
  for (std::size_t position = 0; position < pdos_.size(); first += rooms[position++])
    pdos_[position].plan = MappingPlan{std::span{values_}.subspan(first, rooms[position])};
}

void PdoParameters::own(std::uint16_t index) {
  for (std::uint8_t sub = 0; sub <= kMostMappedObjects; ++sub) context_.dictionary.serve_writes(index, sub, *this);
}

void PdoParameters::reload() noexcept {
  for (PdoSettings& pdo : pdos_) {
    pdo.identifier = 0;
    const bool restored = count(pdo) != 0 || leading_entries(pdo) == 0;
    if (restored || pdo.mapping_count == MappingCount::Zero) pdo.mapping_count = MappingCount::Follows;
    pdo.transmission_type = static_cast<std::uint8_t>(communication(pdo, pdo_sub::kTransmissionType));
  }
}

void PdoParameters::claim_identifiers() noexcept {
  for (PdoSettings& pdo : pdos_) {
    const auto index = static_cast<std::uint16_t>(communication_base_ + pdo.number);
    const auto entry = context_.dictionary.find(index, pdo_sub::kCobId);
    if (!entry) continue;
    const std::int64_t cob_id = context_.dictionary.stored(**entry);
    if (!claim(pdo, static_cast<std::uint32_t>(cob_id)))
      context_.dictionary.set(**entry, cob_id | cob_id::kInvalid);
  }
}

/// Makes @p pdo valid under @p cob_id; false if it cannot be.
bool PdoParameters::claim(PdoSettings& pdo, std::uint32_t cob_id) noexcept {
  const bool usable = (cob_id & cob_id::kInvalid) == 0 &&
                      is_assignable(cob_id, context_.policy.extended_identifiers) &&
                      !context_.identifiers.is_used(identifier_in(cob_id)) &&
                      compile_mapping(rules(), mapping_index(pdo), count(pdo), pdo.plan);
  if (!usable) return false;
  pdo.identifier = identifier_in(cob_id);
  pdo.remote_allowed = allows_remote(cob_id);
  context_.identifiers.take(pdo.identifier);
  return true;
}

bool PdoParameters::allows_remote(std::uint32_t cob_id) const noexcept {
  return direction_ == Direction::Transmit && context_.policy.tpdo_requests && (cob_id & cob_id::kNoRemote) == 0;
}

MappingRules PdoParameters::rules() const noexcept {
  return {context_.dictionary, direction_, context_.policy.dummy_types};
}

std::int64_t PdoParameters::communication(const PdoSettings& pdo, std::uint8_t sub_index) const noexcept {
  const auto index = static_cast<std::uint16_t>(communication_base_ + pdo.number);
  return context_.dictionary.stored(index, sub_index).value_or(0);
}

std::uint16_t PdoParameters::mapping_index(const PdoSettings& pdo) const noexcept {
  return static_cast<std::uint16_t>(mapping_base_ + pdo.number);
}

std::uint8_t PdoParameters::count(const PdoSettings& pdo) const noexcept {
  return static_cast<std::uint8_t>(context_.dictionary.stored(mapping_index(pdo), 0).value_or(0));
}

void PdoParameters::changed(std::size_t position) noexcept {
  if (listener_ != nullptr) listener_->on_pdo_changed(position);
  context_.identifiers.on_identifiers_changed();
}

Result<void> PdoParameters::write(const Entry& entry, std::int64_t value) {
  if (context_.state == NmtState::Operational && !context_.policy.pdo_changes_in_operational) {
    return refuse(AbortCode::DeviceState);
  }
  if (entry.index < mapping_base_) {
    return write_communication(position_[entry.index - communication_base_], entry.sub_index, value);
  }
  PdoSettings& pdo = pdos_[position_[entry.index - mapping_base_]];
  if (pdo.is_valid()) return refuse(AbortCode::DeviceState);
  return entry.sub_index == 0 ? write_count(pdo, static_cast<std::uint8_t>(value))
                              : write_mapping(pdo, entry.sub_index, static_cast<std::uint32_t>(value));
}

Result<void> PdoParameters::write_communication(std::size_t position, std::uint8_t sub_index, std::int64_t value) {
  switch (sub_index) {
    case pdo_sub::kCobId:
      return write_cob_id(position, static_cast<std::uint32_t>(value));
    case pdo_sub::kTransmissionType:
      return write_type(position, static_cast<std::uint8_t>(value));
    case pdo_sub::kSyncStart:
      if (value > kLastSyncStart) return refuse(AbortCode::InvalidValue);
      [[fallthrough]];
    case pdo_sub::kInhibitTime:
      if (pdos_[position].is_valid()) return refuse(AbortCode::DeviceState);
      break;
    default:
      break;
  }
  if (listener_ != nullptr) listener_->on_pdo_time_changed(position, sub_index, value);
  return {};
}

Result<void> PdoParameters::write_cob_id(std::size_t position, std::uint32_t cob_id) {
  PdoSettings& pdo = pdos_[position];
  if ((cob_id & cob_id::kInvalid) != 0) {
    pdo.identifier = 0;
    if (pdo.mapping_count == MappingCount::Zero) pdo.mapping_count = MappingCount::Follows;
    changed(position);
    return {};
  }
  if (!is_assignable(cob_id, context_.policy.extended_identifiers)) return refuse(AbortCode::InvalidValue);
  if (pdo.is_valid()) return write_remote_bit(pdo, cob_id);
  if (context_.identifiers.is_used(identifier_in(cob_id))) return refuse(AbortCode::ParameterIncompatible);
  const std::uint8_t mapped = pdo.mapping_count == MappingCount::Awaited ? leading_entries(pdo) : count(pdo);
  const auto compiled = compile_mapping(rules(), mapping_index(pdo), mapped, pdo.plan);
  if (!compiled) return compiled;
  set_count(pdo, mapped);
  pdo.identifier = identifier_in(cob_id);
  pdo.remote_allowed = allows_remote(cob_id);
  pdo.mapping_count = MappingCount::Follows;
  changed(position);
  return {};
}

/// All that may change in the COB-ID of a valid PDO.
Result<void> PdoParameters::write_remote_bit(PdoSettings& pdo, std::uint32_t cob_id) {
  if (identifier_in(cob_id) != pdo.identifier) return refuse(AbortCode::DeviceState);
  if (pdo.remote_allowed == allows_remote(cob_id)) return {};
  pdo.remote_allowed = allows_remote(cob_id);
  context_.identifiers.on_identifiers_changed();
  return {};
}

Result<void> PdoParameters::write_type(std::size_t position, std::uint8_t type) {
  const auto& types = direction_ == Direction::Receive ? context_.policy.rpdo_types : context_.policy.tpdo_types;
  const bool known = std::ranges::any_of(types, [=](TypeRange r) { return type >= r.first && type <= r.last; });
  if (!known) return refuse(AbortCode::InvalidValue);
  pdos_[position].transmission_type = type;
  if (listener_ != nullptr) listener_->on_pdo_changed(position);
  return {};
}

Result<void> PdoParameters::write_count(PdoSettings& pdo, std::uint8_t count) {
  const auto compiled = compile_mapping(rules(), mapping_index(pdo), count, pdo.plan);
  if (!compiled) return compiled;
  pdo.mapping_count = count == 0 ? MappingCount::Zero : MappingCount::Follows;
  return {};
}

Result<void> PdoParameters::write_mapping(PdoSettings& pdo, std::uint8_t sub_index, std::uint32_t mapped) {
  if (auto fits = check_mapping_entry(rules(), mapped); !fits) return fits;
  if (!context_.policy.count_follows_entries)
    return count(pdo) == 0 ? Result<void>{} : refuse(AbortCode::DeviceState);
  if (pdo.mapping_count == MappingCount::Follows) return follow_entries(pdo, sub_index, mapped);
  pdo.mapping_count = MappingCount::Awaited;
  return {};
}

/// The entries before the first empty one.
std::uint8_t PdoParameters::leading_entries(const PdoSettings& pdo) const noexcept {
  std::uint8_t entries = 0;
  while (entries < kMostMappedObjects &&
         context_.dictionary.stored(mapping_index(pdo), static_cast<std::uint8_t>(entries + 1)).value_or(0) != 0)
    ++entries;
  return entries;
}

void PdoParameters::set_count(const PdoSettings& pdo, std::uint8_t count) noexcept {
  if (const Entry* const entry = context_.dictionary.lookup(mapping_index(pdo), 0))
    context_.dictionary.set(*entry, count);
}

/// Sets the count to the entries before the first empty one, with @p mapped already in its place.
Result<void> PdoParameters::follow_entries(const PdoSettings& pdo, std::uint8_t sub_index, std::uint32_t mapped) {
  std::uint8_t count = 0;
  unsigned bits = 0;
  for (std::uint8_t sub = 1; sub <= kMostMappedObjects; ++sub, ++count) {
    const std::int64_t stored = context_.dictionary.stored(mapping_index(pdo), sub).value_or(0);
    const std::uint32_t word = sub == sub_index ? mapped : static_cast<std::uint32_t>(stored);
    if (word == 0) break;
    bits += word & 0xFF;
  }
  if (bits > 64) return refuse(AbortCode::PdoLengthExceeded);
  set_count(pdo, count);
  return {};
}

}  // namespace canopen
