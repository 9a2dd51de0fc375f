#include "libcanopen/service/routes.hpp"

#include <algorithm>

namespace canopen {

void Routes::make_room(std::size_t count) {
  room_ += count;
  extended_.reserve(room_);
  remote_.reserve(room_);
  subscriptions_.reserve(2 * room_);
  before_.reserve(2 * room_);
}

void Routes::clear() noexcept {
  base_.fill(Route{});
  extended_.clear();
  remote_.clear();
}

void Routes::lead(Identifier identifier, std::uint8_t service, std::uint16_t slot) noexcept {
  lead(place(identifier), service, slot);
}

void Routes::lead_remote(Identifier identifier, std::uint8_t service, std::uint16_t slot) noexcept {
  lead(place(remote_, identifier), service, slot);
}

void Routes::lead(Route& route, std::uint8_t service, std::uint16_t slot) noexcept {
  if (route.service == 0) route = {service, true, slot};
}

void Routes::use(Identifier identifier) noexcept {
  place(identifier).used = true;
}

bool Routes::is_used(Identifier identifier) const noexcept {
  return (identifier < base_.size() ? base_[identifier] : find(extended_, identifier)).used;
}

Route Routes::find(const List& list, Identifier identifier) noexcept {
  const auto at = std::ranges::lower_bound(list, identifier, {}, &Led::identifier);
  return at != list.end() && at->identifier == identifier ? at->route : Route{};
}

Route& Routes::place(Identifier identifier) noexcept {
  return identifier < base_.size() ? base_[identifier] : place(extended_, identifier);
}

Route& Routes::place(List& list, Identifier identifier) noexcept {
  const auto at = std::ranges::lower_bound(list, identifier, {}, &Led::identifier);
  if (at != list.end() && at->identifier == identifier) return at->route;
  return list.insert(at, {identifier, {}})->route;  // within the capacity reserved by make_room()
}

bool Routes::list_subscriptions() noexcept {
  subscriptions_.swap(before_);
  subscriptions_.clear();
  for (Identifier identifier = 0; identifier < base_.size(); ++identifier) {
    if (base_[identifier].service != 0) subscriptions_.push_back({identifier});
  }
  for (const Led& led : extended_)
    if (led.route.service != 0) subscriptions_.push_back({led.identifier});
  for (const Led& led : remote_) subscriptions_.push_back({led.identifier, true});
  return subscriptions_ != before_;
}

}  // namespace canopen
