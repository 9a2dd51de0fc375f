#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "control/error.hpp"
#include "farm/link/messages.hpp"
#include "farm/mirror/connections.hpp"
#include "farm/naming/unit_name.hpp"

namespace farm {

/// Events of units for clients that have subscribed to them. A client has at most one subscription.
class EventRelay {
 public:
  /// What of a farm a client wants to know.
  struct Filter {
    std::optional<UnitName> unit{};    ///< nothing: all
    std::vector<std::string> kinds{};  ///< none: all
  };

  /// All outlive it.
  EventRelay(Messages& messages, Connections& connections, std::string farm)
      : messages_{messages}, connections_{connections}, farm_{std::move(farm)} {}
  EventRelay(const EventRelay&) = delete;
  EventRelay& operator=(const EventRelay&) = delete;
  ~EventRelay() = default;

  void subscribe(Connections::Id client, Filter filter);
  void end(Connections::Id client);
  /// Ends the connections of all who have subscribed: they would not know what they miss.
  void give_up(const control::Error& why);

  /// Messages on the subjects of events that were none.
  [[nodiscard]] std::uint64_t strange() const noexcept { return strange_; }

 private:
  struct Subscription {
    std::string subject;
    std::vector<std::string> kinds;
  };

  void take(const std::string& subject, const Message& message);

  Messages& messages_;
  Connections& connections_;
  std::string farm_;
  std::map<Connections::Id, Subscription> subscriptions_;
  std::map<std::string, std::set<Connections::Id>> clients_;  ///< of each subject that is subscribed to
  std::uint64_t strange_ = 0;
};

}  // namespace farm
