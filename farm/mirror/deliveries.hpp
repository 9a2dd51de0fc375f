#pragma once

#include <chrono>
#include <list>
#include <set>
#include <string>

#include "farm/mirror/connections.hpp"
#include "farm/mirror/unit_requests.hpp"
#include "service/service_events.hpp"

namespace farm {

/// Samples and frames of units for clients that have subscribed to them: what a unit is asked to deliver, to a
/// subject for each client and unit, and shown again and again that somebody wants it. A client has at most one
/// subscription of each kind.
class Deliveries {
 public:
  /// From units of @p requests, which are shown every @p keep that they are wanted. All outlive it.
  Deliveries(axisd::ServiceEvents& events, Messages& messages, UnitRequests& requests, Connections& connections,
             std::chrono::milliseconds keep);
  Deliveries(const Deliveries&) = delete;
  Deliveries& operator=(const Deliveries&) = delete;
  ~Deliveries() = default;

  /// Asks by @p request, whose method is that of a stream ("samples.subscribe"), for @p client; @p on_line is told
  /// the answer.
  void subscribe(Connections::Id client, UnitRequests::Request request, UnitRequests::OnLine on_line);
  /// @p client wants no more of @p stream ("samples").
  void end(Connections::Id client, const std::string& stream);
  /// @p client is gone.
  void forget(Connections::Id client);
  /// Ends the connections of clients to which units of @p host deliver.
  void give_up(const std::string& host);
  /// Ends the connections of all clients to which something is delivered.
  void give_up(const control::Error& why);

 private:
  struct Delivery {
    Connections::Id client;
    Directory::Entry unit;
    std::string subject;
    std::set<std::string> streams{};  ///< that are asked for or granted
    unsigned unanswered = 0;          ///< signs of life
  };

  Delivery& delivery_to(Connections::Id client, const Directory::Entry& unit);
  Delivery* find(const std::string& subject) noexcept;
  void take_answer(const std::string& subject, const std::string& stream, const std::string& line);
  void take(const Delivery& delivery, const Message& message);
  void keep();
  void take_kept(const std::string& subject, const std::string& line);
  void drop(const std::string& subject);

  Messages& messages_;
  UnitRequests& requests_;
  Connections& connections_;
  std::chrono::milliseconds keep_;
  std::string prefix_;  ///< of the subjects
  unsigned last_ = 0;
  std::list<Delivery> all_;
  axisd::EventSource timer_;
};

}  // namespace farm
