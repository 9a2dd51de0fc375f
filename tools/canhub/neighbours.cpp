#include "tools/canhub/neighbours.hpp"

#include <iostream>
#include <utility>

#include "can/connection/connection.hpp"

namespace canhub {

namespace {

void print_notice(std::string_view line) {
  std::cerr << "canhub: " << line << std::endl;
}

}  // namespace

Neighbours::Neighbours(hub::Server& server, const Options& options) : server_{server} {
  for (const bus::Address& address : options.bridges)
    sources_.push_back(
        std::make_unique<hub::Bridge>(server.medium(), bus::open(address), address.text, print_notice));
  if (!options.socketcand.empty())
    sources_.push_back(
        std::make_unique<hub::SocketcandServer>(server.medium(), server.interfaces(), options.socketcand));
  for (const auto& source : sources_) server_.add(*source);
}

Neighbours::~Neighbours() {
  for (const auto& source : sources_) server_.remove(*source);
}

}  // namespace canhub
