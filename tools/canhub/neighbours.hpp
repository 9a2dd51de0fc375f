#pragma once

#include <memory>
#include <vector>

#include "can/hub/bridge.hpp"
#include "can/hub/server.hpp"
#include "can/hub/socketcand/socketcand_server.hpp"
#include "can/hub/trunk/trunk.hpp"
#include "tools/canhub/options.hpp"

namespace canhub {

/// What takes part in a hub's bus beside its members: bridges to other buses, the clients of socketcand, the hubs
/// of other hosts. Lines about them go to standard error.
class Neighbours {
 public:
  /// Opens what @p options name; bus::OpenError, hub::SocketcandServer::ListenError or std::system_error.
  Neighbours(hub::Server& server, const Options& options);
  Neighbours(const Neighbours&) = delete;
  Neighbours& operator=(const Neighbours&) = delete;
  ~Neighbours();

 private:
  void join(const nats::Bus& bus, std::uint32_t bit_rate);

  hub::Server& server_;
  std::vector<std::unique_ptr<hub::Source>> sources_;
};

}  // namespace canhub
