#pragma once

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gateway/security/authority.hpp"
#include "gateway/server/counters.hpp"
#include "gateway/server/exchange.hpp"
#include "os/descriptor.hpp"
#include "service/service_events.hpp"

struct MHD_Connection;
struct MHD_Daemon;

namespace gateway {

/// HTTP by libmicrohttpd, in the loop of the program: one thread, whose connections that wait are suspended.
class HttpServer {
 public:
  /// Longest body of a request (bytes).
  static constexpr std::size_t kLongestBody = 65536;

  /// Who answers.
  class Requests {
   public:
    virtual ~Requests() = default;
    /// The headers of @p exchange have come: an answer at once spares the body.
    virtual void on_headers(Exchange& exchange) = 0;
    /// All of it has come; the answer follows, in the call or later.
    virtual void on_request(const std::shared_ptr<Exchange>& exchange) = 0;
  };

  /// Serves at @p addresses. @p events and @p requests outlive it. Throws std::runtime_error with one line if one
  /// of them cannot be served.
  HttpServer(axisd::ServiceEvents& events, const std::vector<Authority>& addresses, Requests& requests);
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  ~HttpServer();

  /// What is served, with the ports that were taken.
  [[nodiscard]] const std::vector<Authority>& addresses() const noexcept { return addresses_; }
  [[nodiscard]] const Counters& counters() const noexcept { return counters_; }

 private:
  /// A connection, which may bring one request after the other.
  struct Connection {
    int descriptor = -1;
    std::optional<std::int64_t> deadline{};  ///< (µs, monotonic) of the request that is awaited
  };
  /// A request on its way through the library.
  struct Turn;
  /// The library's server at one address.
  struct Door {
    HttpServer* server = nullptr;
    os::Descriptor listener{};
    MHD_Daemon* daemon = nullptr;
    axisd::EventSource source{};
    axisd::EventSource timer{};

    /// Lets the library look at the connections that were resumed: nothing else tells it.
    void look_soon() const noexcept { axisd::ServiceEvents::start(timer, std::chrono::microseconds{0}); }
  };
  struct Callbacks;

  /// The time of deadlines (µs).
  static std::int64_t now() noexcept;
  void open(Door& door, const Authority& address);
  static void run(Door& door) noexcept;
  void look_for_late_ones() noexcept;
  /// Gives the library the answer of @p turn; false if it has no memory for it.
  bool send(MHD_Connection& connection, Turn& turn);

  axisd::ServiceEvents& events_;
  Requests& requests_;
  std::vector<Authority> addresses_;
  Counters counters_;
  std::list<Connection> connections_;
  std::list<Door> doors_;
  std::list<Turn*> turns_;
  axisd::EventSource second_;  ///< a timer
};

}  // namespace gateway
