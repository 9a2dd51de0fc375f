#pragma once

#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gateway/units/daemon_client.hpp"
#include "gateway/units/reach.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

namespace gateway {

/// The daemons of this machine, or a farm as one of them, and their units. Every second it is looked which have
/// come; one that goes, or sends what is no line of the protocol, is forgotten until it is there again.
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

  /// Those that @p reach leads to. The other arguments outlive it.
  Daemons(axisd::ServiceEvents& events, std::unique_ptr<Reach> reach, const axisd::Log& log);
  Daemons(const Daemons&) = delete;
  Daemons& operator=(const Daemons&) = delete;
  ~Daemons() override;

  /// Who is told; nullptr: nobody.
  void listen(Listener* listener) noexcept { listener_ = listener; }
  /// Whether the daemons shall tell their events: while nobody listens, they cost nothing.
  void want_events(bool wanted);

  /// The daemon of @p unit ("vcan0/5"), or why there is none: no unit is called so, or it is gone just now.
  [[nodiscard]] tl::expected<DaemonClient*, Error> find(std::string_view unit) const;
  /// One more connection to the daemon at @p path, for @p listener, which outlives it; the error is one line.
  [[nodiscard]] tl::expected<std::unique_ptr<DaemonClient>, std::string> connect(const std::string& path,
                                                                                 DaemonClient::Listener& listener);
  /// All daemons that can be reached.
  [[nodiscard]] std::vector<DaemonClient*> clients() const;
  /// Whether all daemons that were found have told their units.
  [[nodiscard]] bool are_known() const noexcept;
  /// The names of all units that can be reached, in their order.
  [[nodiscard]] std::vector<std::string> units() const;
  /// The host of @p unit, if it is one of a farm; else empty.
  [[nodiscard]] std::string host_of(std::string_view unit) const;

 private:
  struct Daemon {
    std::unique_ptr<DaemonClient> client;
    std::vector<std::string> units{};
    std::map<std::string, std::string, std::less<>> hosts{};  ///< of units of a farm
    bool is_known = false;                                    ///< it has told its units
    bool is_asked = false;                                    ///< it will
    bool is_lost = false;                                     ///< it could not, last time
  };

  void on_notice(DaemonClient& client, std::string_view key, const nlohmann::json& value) override;
  void on_gone(DaemonClient& client, const std::string& why) override;
  void look();
  void reach(const std::string& path);
  void complain(const std::string& why);
  void ask_for_units(Daemon& daemon);
  void take_units(DaemonClient& client, const Answer& answer);
  void tell_of_units(const Daemon& daemon);
  [[nodiscard]] std::list<Daemon>::iterator find(const DaemonClient& client) noexcept;
  void forget(DaemonClient& client, const std::string& why);
  void subscribe(DaemonClient& client) const;

  axisd::ServiceEvents& events_;
  std::unique_ptr<Reach> reach_;
  const axisd::Log& log_;
  Listener* listener_ = nullptr;
  std::list<Daemon> daemons_;
  std::set<std::string, std::less<>> known_;  ///< units that have been there
  std::set<std::string> complaints_;          ///< that were told
  bool wants_events_ = false;
  axisd::EventSource timer_;
};

}  // namespace gateway
