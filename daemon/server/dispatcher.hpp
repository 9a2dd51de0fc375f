#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "control/protocol.hpp"
#include "daemon/base/mailbox.hpp"
#include "daemon/control/handler.hpp"
#include "daemon/fleet/fleet.hpp"
#include "daemon/server/control_server.hpp"

namespace control {
struct Method;
}

namespace axisd {

/// Leads requests of the control socket to what they ask for: methods of a unit to the thread of the unit and the
/// results back, methods of the program to its own functions.
class Dispatcher final : private ControlServer::Requests {
 public:
  /// Serves at @p path; @p on_quit ends the program. The other arguments outlive it. Throws InstanceError or
  /// std::system_error.
  Dispatcher(ServiceEvents& events, std::string path, Fleet& fleet, std::function<void()> on_quit);

 private:
  using ClientId = ControlServer::ClientId;
  /// A request on its way.
  struct Asked {
    ClientId client;
    control::Request request;
  };
  /// A method of the program: answers at once, or later where it gives nothing.
  struct ProgramHandler {
    std::string_view method;
    std::optional<Outcome> (Dispatcher::*answer)(const Asked& asked);
  };
  static const ProgramHandler* find_program_handler(std::string_view method) noexcept;

  void on_request(ClientId client, std::string_view line) override;
  void dispatch(Asked asked);
  std::optional<Outcome> carry_out(Asked& asked);
  std::optional<Outcome> ask_unit(Asked& asked, const control::Method& method, const Handler& handler);
  void answer(const Asked& asked, const Outcome& outcome);

  std::optional<Outcome> list_units(const Asked& asked);
  std::optional<Outcome> switch_unit_off(const Asked& asked);
  std::optional<Outcome> switch_unit_on(const Asked& asked);
  std::optional<Outcome> quit(const Asked& asked);

  static int on_mail(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;

  Fleet& fleet_;
  std::function<void()> on_quit_;
  Mailbox mailbox_;  ///< results, from the threads of the units
  EventSource mail_;
  ControlServer server_;
};

}  // namespace axisd
