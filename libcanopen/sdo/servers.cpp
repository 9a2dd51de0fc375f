#include "libcanopen/sdo/servers.hpp"

#include <algorithm>
#include <span>

#include "libcanopen/base/node_id.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kObjects = 128;

/// Sub-indices of a server's record (CiA 301, 7.5.2.33).
constexpr std::uint8_t kRequest = 1;   ///< COB-ID client to server
constexpr std::uint8_t kResponse = 2;  ///< COB-ID server to client

/// True for an identifier that the pre-defined connection set gives to the SDOs of a node, in the direction of
/// @p sub_index.
constexpr bool is_predefined(std::uint8_t sub_index, std::uint32_t cob_id) noexcept {
  const Identifier base = sub_index == kRequest ? function_code::kSdoRequest : function_code::kSdoResponse;
  const Identifier identifier = cob_id & (cob_id::kExtended | cob_id::kLong);
  return identifier > base && identifier <= base + kHighestNodeId;
}

constexpr bool is_valid(std::uint32_t cob_id) noexcept {
  return (cob_id & cob_id::kInvalid) == 0;
}

std::size_t servers_in(const Dictionary& dictionary) noexcept {
  std::size_t servers = 1;
  for (std::uint16_t number = 1; number < kObjects; ++number) {
    if (dictionary.contains(static_cast<std::uint16_t>(object::kSdoServer + number))) ++servers;
  }
  return servers;
}

}  // namespace

SdoServers::SdoServers(Context& context)
    : Service{context,
              {.lives_in = kStatesOfObjects,
               .identifiers = 2 * servers_in(context.dictionary),
               .timers = servers_in(context.dictionary)}},
      locks_{servers_in(context.dictionary)} {
  servers_.reserve(servers_in(context.dictionary));
  indices_.reserve(servers_in(context.dictionary));
  for (std::uint16_t number = 0; number < kObjects; ++number) {
    const auto index = static_cast<std::uint16_t>(object::kSdoServer + number);
    if (number != 0 && !context_.dictionary.contains(index)) continue;
    const std::size_t position = servers_.size();
    position_[number] = static_cast<std::uint8_t>(position);
    servers_.emplace_back(context_, first_timer() + position, locks_, position, static_cast<std::uint8_t>(number));
    indices_.push_back(index);
    own(index);
  }
}

void SdoServers::own(std::uint16_t index) {
  for (const std::uint8_t sub_index : {kRequest, kResponse})
    context_.dictionary.serve_writes(index, sub_index, *this);
}

void SdoServers::list_identifiers(IdentifierList& list) const noexcept {
  const std::size_t first_slot = context_.view != nullptr ? kViewed : 0;
  for (std::size_t position = 0; position < servers_.size(); ++position) {
    list.hears(servers_[position].request_identifier(), first_slot + position);
    list.sends(servers_[position].response_identifier());
  }
}

void SdoServers::on_frame(const Frame& frame, std::size_t slot) noexcept {
  if (slot >= kViewed) return servers_[slot - kViewed].on_viewed_frame(frame);
  servers_[slot].on_frame(frame);
}

void SdoServers::reload(Reload how) noexcept {
  if (how == Reload::Afresh) stop();
  for (std::size_t position = 0; position < servers_.size(); ++position) {
    const CobIds stored = cob_ids(position);
    if (is_possible(position, stored)) {
      servers_[position].connect(identifier_in(stored.request), identifier_in(stored.response));
      continue;
    }
    servers_[position].connect(0, 0);
    if (!is_incomplete(position, stored)) mark_invalid(position);
  }
}

/// True if the server at @p position only waits for an identifier, and may have the other one if there is one.
bool SdoServers::is_incomplete(std::size_t position, CobIds stored) const noexcept {
  const auto may_stay = [=, this](std::uint8_t sub_index, std::uint32_t cob_id) {
    return !is_valid(cob_id) || may_have(position, sub_index, cob_id);
  };
  return !(is_valid(stored.request) && is_valid(stored.response)) && may_stay(kRequest, stored.request) &&
         may_stay(kResponse, stored.response);
}

/// Shows that the server at @p position does not exist, so that a client gives it other identifiers.
void SdoServers::mark_invalid(std::size_t position) noexcept {
  for (const std::uint8_t sub_index : {kRequest, kResponse}) {
    const Entry* const entry = context_.dictionary.lookup(indices_[position], sub_index);
    if (entry == nullptr || entry->size == 0) continue;
    context_.dictionary.set(*entry, context_.dictionary.stored(*entry) | cob_id::kInvalid);
  }
}

void SdoServers::stop() noexcept {
  for (SdoServer& server : servers_) server.forget();
}

/// What the dictionary says of the server at @p position; the first one has its identifiers without an object too.
SdoServers::CobIds SdoServers::cob_ids(std::size_t position) const noexcept {
  const std::uint32_t node_id = context_.dictionary.node_id();
  const bool first = position == 0;
  const std::uint16_t index = indices_[position];
  return {cob_id(index, kRequest, first ? function_code::kSdoRequest + node_id : cob_id::kInvalid),
          cob_id(index, kResponse, first ? function_code::kSdoResponse + node_id : cob_id::kInvalid)};
}

std::uint32_t SdoServers::cob_id(std::uint16_t index, std::uint8_t sub_index,
                                 std::uint32_t otherwise) const noexcept {
  const auto entry = context_.dictionary.find(index, sub_index);
  return entry && (*entry)->size != 0 ? static_cast<std::uint32_t>(context_.dictionary.stored(**entry))
                                      : otherwise;
}

/// True if the server at @p position can work with @p wanted beside those before it.
bool SdoServers::is_possible(std::size_t position, CobIds wanted) const noexcept {
  if (!is_valid(wanted.request) || !is_valid(wanted.response)) return false;
  const Identifier request = identifier_in(wanted.request);
  const Identifier response = identifier_in(wanted.response);
  const auto collides = [=](const SdoServer& server) {
    const Identifier theirs[] = {server.request_identifier(), server.response_identifier()};
    return std::ranges::count(theirs, request) != 0 || std::ranges::count(theirs, response) != 0;
  };
  return request != response && may_have(position, kRequest, wanted.request) &&
         may_have(position, kResponse, wanted.response) &&
         std::ranges::none_of(std::span{servers_}.first(position), collides);
}

/// True for what the pre-defined connection set gives to the first server: kept for it, and for nobody else.
bool SdoServers::is_default(std::size_t position, Identifier identifier) const noexcept {
  const std::uint32_t node_id = context_.dictionary.node_id();
  return position == 0 && (identifier == function_code::kSdoRequest + node_id ||
                           identifier == function_code::kSdoResponse + node_id);
}

bool SdoServers::is_allowed(std::size_t position, std::uint8_t sub_index, std::uint32_t cob_id) const noexcept {
  const bool is_further = context_.policy.predefined_sdo_identifiers && position != 0;
  return is_default(position, cob_id) || is_assignable(cob_id, context_.policy.extended_identifiers) ||
         (is_further && is_predefined(sub_index, cob_id));
}

/// True for what is left to the first server, whether that uses it or not.
bool SdoServers::is_kept(std::size_t position, Identifier identifier) const noexcept {
  return position != 0 && is_default(0, identifier);
}

bool SdoServers::may_have(std::size_t position, std::uint8_t sub_index, std::uint32_t cob_id) const noexcept {
  return is_allowed(position, sub_index, cob_id) && !is_kept(position, identifier_in(cob_id));
}

Result<void> SdoServers::write(const Entry& entry, std::int64_t value) {
  const std::size_t position = position_[entry.index - object::kSdoServer];
  const auto cob_id = static_cast<std::uint32_t>(value);
  if (auto allowed = check(position, entry.sub_index, cob_id); !allowed) return allowed;
  CobIds wanted = cob_ids(position);
  (entry.sub_index == kRequest ? wanted.request : wanted.response) = cob_id;
  connect(position, wanted);
  return {};
}

Result<void> SdoServers::check(std::size_t position, std::uint8_t sub_index, std::uint32_t cob_id) const noexcept {
  if (!is_valid(cob_id)) return {};
  if (!is_allowed(position, sub_index, cob_id)) return refuse(AbortCode::InvalidValue);
  const CobIds present = cob_ids(position);
  const bool is_request = sub_index == kRequest;
  const Identifier wanted = identifier_in(cob_id);
  const Identifier own = valid_identifier(is_request ? present.request : present.response);
  const Identifier other = valid_identifier(is_request ? present.response : present.request);
  if (own != 0) return wanted == own ? Result<void>{} : refuse(AbortCode::DeviceState);
  const auto is_taken = [&](Identifier identifier) {
    if (is_default(position, identifier)) return false;
    return is_kept(position, identifier) || context_.identifiers.is_used(identifier);
  };
  const bool collides = wanted == other || is_taken(wanted) || (other != 0 && is_taken(other));
  return collides ? refuse(AbortCode::ParameterIncompatible) : Result<void>{};
}

/// Lets the server at @p position work with @p wanted, if both exist.
void SdoServers::connect(std::size_t position, CobIds wanted) noexcept {
  SdoServer& server = servers_[position];
  const bool works = is_valid(wanted.request) && is_valid(wanted.response);
  const Identifier request = works ? identifier_in(wanted.request) : 0;
  const Identifier response = works ? identifier_in(wanted.response) : 0;
  if (!server.connect(request, response)) return;
  context_.identifiers.on_identifiers_changed();
}

}  // namespace canopen
