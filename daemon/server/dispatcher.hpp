#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "control/protocol.hpp"
#include "daemon/control/handler.hpp"
#include "daemon/fleet/fleet.hpp"
#include "daemon/server/control_server.hpp"
#include "daemon/server/subscriptions.hpp"
#include "service/mailbox.hpp"

namespace control {
struct Method;
}

namespace axisd {

/// Leads requests of the control socket to what they ask for: methods of a unit to the thread of the unit and the
/// results back, methods of the program to its own functions.
class Dispatcher final : private ControlServer::Requests {
 public:
  /// Serves @p socket; @p on_quit ends the program. The other arguments outlive it. Throws InstanceError or
  /// std::system_error.
  Dispatcher(ServiceEvents& events, ControlSocket socket, Fleet& fleet, EventQueue& queue,
             std::function<void()> on_quit);

 private:
  using ClientId = ControlServer::ClientId;
  /// A request on its way.
  struct Asked {
    ClientId client{};
    control::Request request;
  };
  /// Which unit a method of the program needs.
  enum class Needs : std::uint8_t { None, OneOrAll, One };
  /// A method of the program: answers at once, or later where it gives nothing.
  struct ProgramHandler {
    std::string_view method;
    Needs unit;
    std::optional<Outcome> (Dispatcher::*answer)(const Asked& asked, ServedUnit* unit);
  };
  static const ProgramHandler* find_program_handler(std::string_view method) noexcept;

  void on_request(ClientId client, std::string_view line) override;
  void dispatch(Asked asked);
  void on_client_gone(ClientId client) noexcept override { subscriptions_.forget(client); }
  std::optional<Outcome> carry_out(Asked& asked);
  std::optional<Outcome> call_unit(const Asked& asked, ServedUnit& unit, const Handler& handler);
  void run(ServedUnit& unit, UnitJob job, std::function<void(Outcome)> done);
  void answer(const Asked& asked, const Outcome& outcome);

  std::optional<Outcome> list_units(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> switch_unit_off(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> switch_unit_on(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> subscribe_to_events(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> end_events(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> subscribe_to_samples(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> end_samples(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> subscribe_to_frames(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> end_frames(const Asked& asked, ServedUnit* unit);
  std::optional<Outcome> quit(const Asked& asked, ServedUnit* unit);

  static int on_mail(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;

  Fleet& fleet_;
  std::function<void()> on_quit_;
  Mailbox mailbox_;  ///< results, from the threads of the units
  EventSource mail_;
  ControlServer server_;
  Subscriptions subscriptions_;
};

}  // namespace axisd
