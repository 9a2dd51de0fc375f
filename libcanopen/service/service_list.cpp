#include "libcanopen/service/service_list.hpp"

#include <stdexcept>

#include "libcanopen/service/identifier_list.hpp"

namespace canopen {

std::size_t ServiceList::add(Service& service, const ServiceFacts& facts) {
  if (services_.size() == kMost) throw std::length_error{"the node has too many services"};
  const std::size_t first_timer = context_.timers.add(facts.timers);
  services_.push_back({&service, facts, first_timer});
  timer_owners_.resize(first_timer + facts.timers, static_cast<std::uint8_t>(services_.size()));
  routes_.make_room(facts.identifiers);
  return first_timer;
}

void ServiceList::on_rare_frame(const Frame& frame) noexcept {
  if (frame.remote) {
    const Route route = routes_.of_remote(frame);
    return living_[route.service]->on_request(route.slot);
  }
  const Route route = frame.extended ? routes_.of_extended(frame) : Route{};
  living_[route.service]->on_frame(frame, route.slot);
}

void ServiceList::on_timer(std::size_t timer) noexcept {
  const std::uint8_t place = timer_owners_[timer];
  living_[place]->on_timer(timer - services_[place - 1U].first_timer);
}

void ServiceList::leave() noexcept {
  for (std::size_t i = 0; i < services_.size(); ++i)
    living_[i + 1] = lives(services_[i]) ? services_[i].service : &nobody_;
  for (Registered& registered : services_) {
    if (!registered.started || lives(registered)) continue;
    registered.started = false;
    registered.service->stop();
  }
}

void ServiceList::enter() noexcept {
  for (Registered& registered : services_) {
    if (registered.started || !lives(registered)) continue;
    registered.started = true;
    registered.service->start();
  }
}

void ServiceList::go_on() noexcept {
  for (const Registered& registered : services_)
    if (registered.started) registered.service->start();
}

void ServiceList::reload(Reload how) noexcept {
  reloading_ = true;
  reload(how, ReloadStage::Senders);
  reload(how, ReloadStage::Values);
  lay_routes();  // those that services which claim theirs must leave alone
  for (const Registered& registered : services_)
    if (takes_part(registered)) registered.service->claim_identifiers();
  reloading_ = false;
  lay_routes();
  context_.application.on_subscriptions_changed();
}

void ServiceList::reload(Reload how, ReloadStage stage) noexcept {
  for (const Registered& registered : services_)
    if (registered.facts.stage == stage && takes_part(registered)) registered.service->reload(how);
}

void ServiceList::on_identifiers_changed() noexcept {
  if (!reloading_ && lay_routes()) context_.application.on_subscriptions_changed();
}

/// True if the node has to receive other frames than before.
bool ServiceList::lay_routes() noexcept {
  routes_.clear();
  for (std::size_t i = 0; i < services_.size(); ++i) {
    if (!takes_part(services_[i])) continue;
    IdentifierList list{routes_, static_cast<std::uint8_t>(i + 1)};
    services_[i].service->list_identifiers(list);
  }
  return routes_.list_subscriptions();
}

}  // namespace canopen
