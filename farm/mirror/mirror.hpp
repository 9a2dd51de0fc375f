#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/protocol.hpp"
#include "farm/mirror/connections.hpp"
#include "farm/mirror/deliveries.hpp"
#include "farm/mirror/directory.hpp"
#include "farm/mirror/event_relay.hpp"
#include "farm/mirror/mirror_times.hpp"
#include "farm/mirror/settling.hpp"
#include "farm/mirror/unit_requests.hpp"
#include "service/service_events.hpp"

namespace farm {

/// The units of a whole farm as if one daemon had them: clients speak the protocol of the control socket, and what
/// they ask goes to the units by messages.
class Mirror final : private Connections::Listener {
 public:
  /// Of @p farm; @p place names its server, for people. @p events and @p messages outlive it.
  Mirror(axisd::ServiceEvents& events, Messages& messages, std::string farm, std::string place,
         const MirrorTimes& times = {});
  Mirror(const Mirror&) = delete;
  Mirror& operator=(const Mirror&) = delete;
  ~Mirror() override;

  /// Messages come and go: what Link::Listener is told.
  void on_up();
  /// They do no longer, for the reason @p why.
  void on_down(const std::string& why);

  /// Serves the client at the other end of @p socket, a stream. Throws std::system_error.
  void serve(os::Descriptor socket, Order order) { connections_.add(std::move(socket), order); }
  /// Tells @p then, at once or later, whether there is a connection to the server; if not, in one line why.
  void when_in_contact(std::function<void(tl::expected<void, std::string>)> then);

 private:
  enum class Contact : std::uint8_t { Unknown, Up, Down };
  /// What has to wait until more is known; true when it is done.
  using Waiting = std::function<bool()>;
  using Ticket = Connections::Ticket;
  using Request = control::Request;
  /// Which unit a method needs.
  enum class Needs : std::uint8_t { None, OneOrAll, One };
  /// A method that is not simply handed on to a unit. Without a unit, one that needs one or all means all.
  struct OwnMethod {
    std::string_view name;
    Needs unit;
    bool needs_all_known;  ///< where it means all
    void (Mirror::*answer)(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  };
  /// The unit that is meant, or why none is; nothing: that is not known yet.
  using Meant = std::optional<tl::expected<Directory::Entry, control::Error>>;

  static const OwnMethod* find_own(std::string_view method) noexcept;
  void on_line(const Ticket& ticket, std::string_view line) override;
  void on_gone(Connections::Id client) override;
  bool answer(const Ticket& ticket, const Request& request);
  void list_units(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void subscribe_to_events(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void end_events(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void subscribe_to_stream(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void end_stream(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void refuse_to_quit(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void ask_unit(const Ticket& ticket, const Request& request, const Directory::Entry* unit);
  void refuse(const Ticket& ticket, const Request& request, const control::Error& why);

  [[nodiscard]] Meant unit_called(std::string_view name) const;
  [[nodiscard]] tl::expected<Directory::Entry, control::Error> unit_among_all(std::string_view name) const;
  [[nodiscard]] control::Error absent(const UnitName& name, const Absence& absence) const;

  void take_beat(const Message& message);
  void tick();
  void wait(Waiting waiting);
  void retry();
  [[nodiscard]] bool is_settled() const noexcept;

  Messages& messages_;
  std::string farm_;
  std::string place_;
  MirrorTimes times_;
  Instant begun_;
  Contact contact_ = Contact::Unknown;
  std::string why_down_;
  Directory directory_;
  Settling settling_;
  Connections connections_;
  UnitRequests requests_;
  EventRelay events_;
  Deliveries deliveries_;
  std::vector<Waiting> waiting_;
  axisd::EventSource tick_;
};

}  // namespace farm
