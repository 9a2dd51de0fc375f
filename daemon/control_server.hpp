#pragma once

#include <functional>
#include <list>
#include <string>
#include <string_view>

#include "bus/descriptor.hpp"
#include "daemon/service_events.hpp"

namespace axisd {

/// Serves the control socket: one JSON request a line, one answer a line, for any number of clients.
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
    bus::Descriptor descriptor;
    EventSource source;
    std::string input;
    std::string output;
  };

  static int on_connection(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  static int on_client(sd_event_source* source, int descriptor, std::uint32_t events, void* client) noexcept;
  void accept();
  bool serve(Client& client, std::uint32_t events);
  bool read(Client& client);
  static bool flush(Client& client);
  void close(const Client& client);

  ServiceEvents& events_;
  std::string path_;
  Answer answer_;
  bus::Descriptor listener_;
  EventSource source_;
  std::list<Client> clients_;
};

}  // namespace axisd
