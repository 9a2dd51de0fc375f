#include "can/hub/trunk/hubs.hpp"

#include <algorithm>
#include <utility>

namespace hub::trunk {

namespace {

/// With a bit rate frames of a hub may be in the stream already when it says how many have passed.
bool is_rough(const Header& header) noexcept {
  return is_beat(header.kind) && header.bit_rate() != 0;
}

}  // namespace

bool Hubs::is_outdated(const Header& header) const noexcept {
  const auto known = std::ranges::find(hubs_, header.hub, &Neighbour::hub);
  return known != hubs_.end() && header.epoch < known->epoch;
}

Hubs::Outcome Hubs::note(const Header& header, std::size_t frames, canopen::TimePoint now) noexcept {
  Neighbour& hub = place_of(header.hub);
  Outcome outcome{.hub = hub};
  if (hub.hub == 0) {
    hub.hub = header.hub;
    outcome.news = News::Joined;
  } else if (!hub.is_present || hub.epoch != header.epoch) {
    outcome.news = News::Returned;
  }
  hub.epoch = header.epoch;
  hub.heard = now;
  hub.is_present = true;
  if (hub.next == 0) {
    if (is_rough(header)) return outcome;
    hub.next = header.counter;
  }
  if (header.counter > hub.next) {
    hub.missed += header.counter - hub.next;
    missed_ += header.counter - hub.next;
    hub.next = header.counter;
  }
  outcome.repeated = std::min<std::uint64_t>(hub.next - header.counter, frames);
  repeated_ += outcome.repeated;
  hub.next = std::max(hub.next, header.counter + frames);
  return outcome;
}

void Hubs::miss(Neighbour& hub, std::size_t frames) noexcept {
  hub.missed += frames;
  missed_ += frames;
}

Neighbour& Hubs::place_of(std::uint32_t hub) noexcept {
  if (const auto known = std::ranges::find(hubs_, hub, &Neighbour::hub); known != hubs_.end()) return *known;
  Neighbour& place = *std::ranges::min_element(hubs_, {}, [](const Neighbour& one) {
    return std::pair{one.hub != 0, one.heard};
  });
  place = Neighbour{};
  return place;
}

Neighbour* Hubs::take_gone(canopen::TimePoint now) noexcept {
  const auto gone = std::ranges::find_if(
      hubs_, [now](const Neighbour& hub) { return hub.is_present && now - hub.heard > kPatience; });
  if (gone == hubs_.end()) return nullptr;
  gone->is_present = false;
  return &*gone;
}

void Hubs::forgive(canopen::TimePoint now) noexcept {
  for (Neighbour& hub : hubs_) hub.heard = std::max(hub.heard, now);
}

}  // namespace hub::trunk
