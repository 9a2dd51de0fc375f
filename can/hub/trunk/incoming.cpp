#include "can/hub/trunk/incoming.hpp"

#include <fmt/format.h>

namespace hub::trunk {

using canopen::TimePoint;

bool Incoming::take(const Reader& reader, std::int64_t time_ns, Gate gate, TimePoint now) noexcept {
  if (hubs_.is_outdated(reader.header())) return false;
  const Hubs::Outcome outcome = hubs_.note(reader.header(), reader.frames(), now);
  meet(reader, outcome, now);
  const std::size_t fresh = reader.frames() - outcome.repeated;
  if (gate == Gate::Stale) {
    figures_.stale += fresh;
  } else if (gate == Gate::Closed) {
    hubs_.miss(outcome.hub, fresh);
  } else {
    for (std::size_t i = outcome.repeated; i < reader.frames(); ++i)
      if (pass(reader, i, time_ns, now)) ++outcome.hub.received;
  }
  return outcome.news != Hubs::News::None;
}

void Incoming::meet(const Reader& reader, const Hubs::Outcome& outcome, TimePoint now) noexcept {
  const bool has_name = is_beat(reader.header().kind);
  if (has_name) reader.name().copy(outcome.hub.name.data(), kLongestName);
  if (outcome.news == Hubs::News::Joined && has_name)
    notices_.tell(fmt::format("{} is on the bus", outcome.hub.text()), now);
  if (outcome.news == Hubs::News::Returned)
    notices_.tell(fmt::format("{} is on the bus again", outcome.hub.text()), now);
}

/// False if it is not for the members of this hub.
bool Incoming::pass(const Reader& reader, std::size_t number, std::int64_t time_ns, TimePoint now) noexcept {
  const MarkedFrame marked = reader.frame(number);
  if ((marked.frame.can_id & CAN_ERR_FLAG) != 0) return false;  // those of a hub stay on it
  Passage passage;
  passage.frame = marked.frame;
  passage.local = false;
  passage.time_ns = time_ns;
  passage.mark = {.hub = reader.header().origin, .number = marked.number};
  if (!medium_.is_new(passage.mark)) {
    ++figures_.returned;
    return false;
  }
  ++figures_.received;
  medium_.pass(passage, now);
  return true;
}

void Incoming::tell_gone(TimePoint now) noexcept {
  while (const Neighbour* const gone = hubs_.take_gone(now))
    notices_.tell(fmt::format("{} is on the bus no more", gone->text()), now);
}

}  // namespace hub::trunk
