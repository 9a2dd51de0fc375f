#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "injection/language/fault.hpp"
#include "injection/language/trigger.hpp"
#include "injection/wire/frame_role.hpp"
#include "injection/wire/transfer.hpp"
#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace injection {

/// The identifier of @p frame as events name it: above 7FFh that of an extended frame. An extended frame with a
/// lower one has no name.
constexpr std::uint32_t event_identifier(const canopen::Frame& frame) noexcept {
  return frame.extended && frame.id <= canopen::cob_id::kBase ? canopen::identifier_of(frame) : frame.id;
}
/// The same the other way: the identifier under which a frame that an event names travels.
constexpr canopen::Identifier travelling_identifier(std::uint32_t identifier) noexcept {
  return identifier > canopen::cob_id::kBase ? identifier | canopen::cob_id::kExtended : identifier;
}

/// A frame on its way between the unit and the bus, and what faults make of it.
struct Passing {
  canopen::Frame frame;
  Role role;
  bool is_sent;                        ///< by the unit
  std::uint32_t identifier = 0;        ///< on the bus, as events name it
  const Transfer* transfer = nullptr;  ///< of SDO: the one that it belongs to

  bool is_dropped = false;
  canopen::Duration delay{};
  unsigned copies = 1;
  std::optional<std::uint32_t> abort{};  ///< the transfer is aborted with this code

  Occurrence occurrence() const noexcept { return {role.kind, identifier}; }
};

/// A fault that somebody has loaded.
struct Loaded {
  std::uint32_t id;
  Fault fault;
  Trigger trigger;
  bool was_hit = false;                       ///< by what is passing; of a cycle: by this one
  bool has_begun = false;                     ///< of Nature::Lasting: it has been carried out
  bool is_pending = false;                    ///< of Nature::Moment: it is to be carried out
  std::vector<canopen::Frame> kept{};         ///< what frozen PDOs repeat, one a PDO
  canopen::TimePoint next = canopen::kNever;  ///< of what it does by itself

  std::optional<std::uint32_t> value(Argument argument) const noexcept { return fault.value(argument); }
};

}  // namespace injection
