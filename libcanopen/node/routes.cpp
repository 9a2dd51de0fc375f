#include "libcanopen/node/routes.hpp"

#include <algorithm>

namespace canopen {

Routes::Routes(std::size_t most) {
  extended_.reserve(most);
  remote_.reserve(most);
  subscriptions_.reserve(2 * most);
}

void Routes::clear() noexcept {
  base_.fill(Route{});
  extended_.clear();
  remote_.clear();
}

void Routes::lead(Identifier identifier, Route route) noexcept {
  if (identifier < base_.size()) {
    base_[identifier] = route;
  } else {
    insert(extended_, identifier, route);
  }
}

void Routes::lead_remote(Identifier identifier, Route route) noexcept {
  insert(remote_, identifier, route);
}

Route Routes::of(Identifier identifier) const noexcept {
  return identifier < base_.size() ? base_[identifier] : find(extended_, identifier);
}

Route Routes::find(const List& list, Identifier identifier) noexcept {
  const auto at = std::ranges::lower_bound(list, identifier, {}, &Led::identifier);
  return at != list.end() && at->identifier == identifier ? at->route : Route{};
}

void Routes::insert(List& list, Identifier identifier, Route route) noexcept {
  const auto at = std::ranges::lower_bound(list, identifier, {}, &Led::identifier);
  if (at != list.end() && at->identifier == identifier) {
    at->route = route;
  } else {
    list.insert(at, {identifier, route});  // within the capacity reserved by the constructor
  }
}

void Routes::list_subscriptions() noexcept {
  subscriptions_.clear();
  for (Identifier identifier = 0; identifier < base_.size(); ++identifier) {
    if (base_[identifier].service != Service::None) subscriptions_.push_back({identifier});
  }
  for (const Led& led : extended_) subscriptions_.push_back({led.identifier});
  for (const Led& led : remote_) subscriptions_.push_back({led.identifier, true});
}

}  // namespace canopen
