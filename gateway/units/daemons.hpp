#pragma once

#include <list>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gateway/units/daemon_client.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

namespace gateway {

/// The daemons of this machine and their units. Every second it is looked which have come; one that goes, or sends
/// what is no line of the protocol, is forgotten until it is there again.
class Daemons final : private DaemonClient::Listener {
 public:
  /// Who hears.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// @p event has happened in one of the units.
    virtual void on_event(const nlohmann::json& event) = 0;
    /// Units have come or gone.
    virtual void on_units() = 0;
  };

  /// Of the sockets @p paths alone, or of all in the runtime folders where there are none. The other arguments
  /// outlive it.
  Daemons(axisd::ServiceEvents& events, std::vector<std::string> paths, const axisd::Log& log);
  Daemons(const Daemons&) = delete;
  Daemons& operator=(const Daemons&) = delete;
  ~Daemons() override;

  /// Who is told; nullptr: nobody.
  void listen(Listener* listener) noexcept { listener_ = listener; }
  /// Whether the daemons shall tell their events: while nobody listens, they cost nothing.
  void want_events(bool wanted);

  /// The daemon of @p unit ("vcan0/5"), or why there is none: no unit is called so, or it is gone just now.
  [[nodiscard]] tl::expected<DaemonClient*, Error> find(std::string_view unit) const;
  /// All daemons that can be reached.
  [[nodiscard]] std::vector<DaemonClient*> clients() const;
  /// Whether all daemons that were found have told their units.
  [[nodiscard]] bool are_known() const noexcept;
  /// The names of all units that can be reached, in their order.
  [[nodiscard]] std::vector<std::string> units() const;

 private:
  struct Daemon {
    std::unique_ptr<DaemonClient> client;
    std::vector<std::string> units{};
    bool is_known = false;  ///< it has told its units
  };

  void on_notice(DaemonClient& client, std::string_view key, const nlohmann::json& value) override;
  void on_gone(DaemonClient& client, const std::string& why) override;
  void look();
  void reach(const std::string& path);
  void complain(const std::string& why);
  void take_units(DaemonClient& client, const Answer& answer);
  void forget(DaemonClient& client, const std::string& why);
  void subscribe(DaemonClient& client) const;

  axisd::ServiceEvents& events_;
  std::vector<std::string> paths_;
  const axisd::Log& log_;
  Listener* listener_ = nullptr;
  std::list<Daemon> daemons_;
  std::set<std::string, std::less<>> known_;  ///< units that have been there
  std::set<std::string> complaints_;          ///< that were told
  bool wants_events_ = false;
  axisd::EventSource timer_;
};

}  // namespace gateway
