#pragma once

#include <cstdint>
#include <list>
#include <optional>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// Where the control socket lies, and who may use it beside its user.
struct ControlSocket {
  std::string path;
  std::optional<gid_t> group{};  ///< its members; none: nobody
};

/// Serves the control socket: one JSON request a line, one answer a line, and lines that nobody has asked for to
/// those who have subscribed to them. An event that is handled takes one request, however many wait; clients that
/// ask take turns, and none has more than one request under way. Beyond the greatest number of clients the one
/// that has asked nothing for the longest time makes room, with a word.
class ControlServer {
 public:
  /// A connection; no number comes twice.
  using ClientId = std::uint64_t;
  static constexpr ClientId kNobody = 0;

  /// Who answers.
  class Requests {
   public:
    virtual ~Requests() = default;
    /// @p line has come from @p client; answer() follows, in the call or later.
    virtual void on_request(ClientId client, std::string_view line) = 0;
    /// @p client is gone, and whatever is for it.
    virtual void on_client_gone(ClientId client) noexcept { (void)client; }
  };

  /// What has happened to clients.
  struct Counters {
    std::uint64_t refused = 0;  ///< made room for others, or sent a line that was too long
    std::uint64_t cut_off = 0;  ///< did not read what they had subscribed to
  };

  /// Listens at @p socket with mode 0600, or 0660 of its group, in place of a socket that nobody serves any more.
  /// @p requests outlives it. Throws InstanceError if somebody does, or if the socket cannot be made.
  ControlServer(ServiceEvents& events, ControlSocket socket, Requests& requests);
  ~ControlServer();
  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;

  const std::string& path() const noexcept { return socket_.path; }
  std::size_t clients() const noexcept { return clients_.size(); }
  const Counters& counters() const noexcept { return counters_; }

  /// Whether @p id is still there.
  bool has(ClientId id) const noexcept;
  /// @p line, with its newline, answers the request of @p id that is under way, if that is still there.
  void answer(ClientId id, std::string_view line);
  /// @p line, with its newline, goes to @p id as well; one that has left too much unread is cut off.
  void push(ClientId id, std::string_view line);
  /// @p id will be told something without asking: it makes no room for others.
  void keep(ClientId id, bool kept) noexcept;

 private:
  struct Client {
    ControlServer* server;
    ClientId id;
    os::Descriptor descriptor;
    EventSource source;
    std::string input{};
    std::string output{};
    bool is_busy = false;  ///< a request is under way
    bool is_kept = false;
  };

  static int on_connection(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  static int on_client(sd_event_source* source, int descriptor, std::uint32_t events, void* client) noexcept;
  static int on_pause_over(sd_event_source* source, std::uint64_t now, void* self) noexcept;
  Client* find(ClientId id) noexcept;
  void accept();
  void pause();
  void make_room();
  bool serve(Client& client, std::uint32_t events);
  static bool read(Client& client);
  void take_line(Client& client);
  void refuse(Client& client, std::string_view message);
  void deliver(Client& client);
  static bool flush(Client& client);
  static void listen_to(Client& client);
  void close(const Client& client);

  ServiceEvents& events_;
  ControlSocket socket_;
  Requests& requests_;
  os::Descriptor listener_;
  EventSource source_;
  EventSource pause_;          ///< a timer
  std::list<Client> clients_;  ///< the one that has asked last is the last
  ClientId last_id_ = kNobody;
  ClientId taking_ = kNobody;  ///< whose line is being taken
  Counters counters_;
};

}  // namespace axisd
