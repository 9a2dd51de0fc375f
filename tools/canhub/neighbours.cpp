#include "tools/canhub/neighbours.hpp"

#include <array>
#include <iostream>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "can/connection/connection.hpp"
#include "can/nats/lease/nats_lease.hpp"
#include "can/nats/nats_stream.hpp"

namespace canhub {

namespace {

void print_notice(std::string_view line) {
  std::cerr << "canhub: " << line << std::endl;
}

/// Who this hub is for others: host and process.
std::string name_of_hub() {
  constexpr std::size_t kLongest = 48;
  std::array<char, kLongest + 1> host{};
  gethostname(host.data(), kLongest);
  return fmt::format("{} (canhub {})", host.data(), getpid());
}

}  // namespace

Neighbours::Neighbours(hub::Server& server, const Options& options) : server_{server} {
  for (const bus::Address& address : options.bridges)
    sources_.push_back(
        std::make_unique<hub::Bridge>(server.medium(), bus::open(address), address.text, print_notice));
  if (!options.socketcand.empty())
    sources_.push_back(
        std::make_unique<hub::SocketcandServer>(server.medium(), server.interfaces(), options.socketcand));
  if (options.join) join(*options.join, options.bit_rate.value_or(0));
  for (const auto& source : sources_) server_.add(*source);
}

void Neighbours::join(const nats::Bus& bus, std::uint32_t bit_rate) {
  server_.lengthen();
  hub::trunk::Trunk::Settings settings{
      .url = bus.server.url + "/" + bus.name, .name = name_of_hub(), .bit_rate = bit_rate};
  auto stream = std::make_unique<nats::NatsStream>(bus);
  std::unique_ptr<nats::NatsLease> lease;
  if (bit_rate != 0) {
    const std::uint32_t hub = server_.medium().number_of_hub();
    lease = std::make_unique<nats::NatsLease>(
        bus, nats::NatsLease::Holder{.hub = hub, .name = settings.name, .bit_rate = bit_rate});
  }
  const auto on_link = [this](bool up, canopen::TimePoint) { server_.set_link(up); };
  sources_.push_back(std::make_unique<hub::trunk::Trunk>(server_.medium(), std::move(stream), std::move(settings),
                                                         on_link, print_notice, std::move(lease)));
}

Neighbours::~Neighbours() {
  for (const auto& source : sources_) server_.remove(*source);
}

}  // namespace canhub
