#pragma once

#include <functional>
#include <list>
#include <string>
#include <string_view>

#include "daemon/program/service_events.hpp"
#include "os/descriptor.hpp"

namespace axisd {

/// Serves the control socket: one JSON request a line, one answer a line. An event that is handled answers one
/// request, however many wait; clients that ask take turns. Beyond the greatest number of clients the one that has
/// asked nothing for the longest time makes room, with a word.
class ControlServer {
 public:
  /// Turns the line of a request into the line of its answer.
  using Answer = std::function<std::string(std::string_view line)>;

  /// Listens at @p path with mode 0600, in place of a socket that nobody serves any more. Throws InstanceError if
  /// somebody does, or if the socket cannot be made.
  ControlServer(ServiceEvents& events, std::string path, Answer answer);
  ~ControlServer();
  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;

  const std::string& path() const noexcept { return path_; }

 private:
  struct Client {
    ControlServer* server;
    os::Descriptor descriptor;
    EventSource source;
    std::string input;
    std::string output;
  };

  static int on_connection(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  static int on_client(sd_event_source* source, int descriptor, std::uint32_t events, void* client) noexcept;
  static int on_pause_over(sd_event_source* source, std::uint64_t now, void* self) noexcept;
  void accept();
  void pause();
  void make_room();
  bool serve(Client& client, std::uint32_t events);
  static bool read(Client& client);
  void answer_line(Client& client);
  static void refuse(Client& client, std::string_view message);
  static bool flush(Client& client);
  void close(const Client& client);

  ServiceEvents& events_;
  std::string path_;
  Answer answer_;
  os::Descriptor listener_;
  EventSource source_;
  EventSource pause_;          ///< a timer
  std::list<Client> clients_;  ///< the one that has asked last is the last
};

}  // namespace axisd
