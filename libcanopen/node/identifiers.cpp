#include <algorithm>

#include "libcanopen/node/node.hpp"

// Who has which identifier, and where frames go.

namespace canopen {
namespace {

/// Leads the identifiers of @p objects, 0 if they do not exist, to their positions in @p service.
template <class Objects, class IdentifierOf>
void lead_all(Routes& routes, Service service, const Objects& objects, const IdentifierOf& identifier_of_object) {
  for (std::size_t position = 0; position < objects.size(); ++position) {
    const Identifier identifier = identifier_of_object(objects[position]);
    if (identifier != 0) routes.lead(identifier, {service, static_cast<std::uint16_t>(position)});
  }
}

}  // namespace

bool Node::is_used(Identifier identifier) const noexcept {
  const auto servers = sdo_servers_.servers();
  const auto carries = [=](std::span<const PdoSettings> pdos) {
    return std::ranges::find(pdos, identifier, &PdoSettings::identifier) != pdos.end();
  };
  return routes_.of(identifier).service != Service::None || identifier == emcy_.identifier() ||
         carries(receive_pdos_.pdos()) || carries(transmit_pdos_.pdos()) ||
         std::any_of(servers.begin(), servers.end(),
                     [=](const auto& s) { return s.response_identifier() == identifier; });
}

void Node::on_identifiers_changed() noexcept {
  lay_routes();
  context_.application.on_subscriptions_changed();
}

void Node::lay_routes() noexcept {
  const Identifier error_control = function_code::kErrorControl + node_id();
  routes_.clear();
  lead_all(routes_, Service::Heartbeat, heartbeat_consumer_.identifiers(), [](Identifier i) { return i; });
  lead_all(routes_, Service::Rpdo, receive_pdos_.pdos(), [](const PdoSettings& p) { return p.identifier; });
  routes_.lead(error_control, {Service::Own, 0});
  routes_.lead(function_code::kSdoResponse + node_id(), {Service::Own, 0});
  lead_all(routes_, context_.view != nullptr ? Service::ViewedSdo : Service::Sdo, sdo_servers_.servers(),
           [](const SdoServer& s) { return s.request_identifier(); });
  if (time_.identifier() != 0) routes_.lead(time_.identifier(), {Service::Time, 0});
  if (sync_.identifier() != 0) routes_.lead(sync_.identifier(), {Service::Sync, 0});
  routes_.lead(function_code::kNmt, {Service::Nmt, 0});

  if (guarding_.is_on()) routes_.lead_remote(error_control, {Service::Guarding, 0});
  const auto tpdos = transmit_pdos_.pdos();
  for (std::size_t position = 0; position < tpdos.size(); ++position) {
    if (!tpdos[position].is_requestable()) continue;
    routes_.lead_remote(tpdos[position].identifier, {Service::TpdoRequest, static_cast<std::uint16_t>(position)});
  }
  routes_.list_subscriptions();
}

}  // namespace canopen
