#pragma once

#include <memory>
#include <optional>
#include <string>

#include "can/nats_options/nats_options.hpp"
#include "farm/mirror/mirror_thread.hpp"
#include "tools/axisctl/connection/failure.hpp"

namespace axisctl {

/// What the command line says of a farm.
struct FarmOption {
  std::optional<std::string> url{};  ///< nothing: what the environment says
  nats::ServerOptions server{};
};

/// Gives @p app the option --farm and those of its server.
void add_farm_options(CLI::App& app, FarmOption& option);

/// Begins to connect to the farm that @p option means, or AXISD_FARM; nullptr if there is none. With a @p socket
/// on the command line there is none. Throws std::system_error.
[[nodiscard]] Expected<std::unique_ptr<farm::MirrorThread>> open_farm(const FarmOption& option,
                                                                      const std::optional<std::string>& socket);

}  // namespace axisctl
