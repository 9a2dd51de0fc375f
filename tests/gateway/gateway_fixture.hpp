#pragma once

#include <functional>
#include <list>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "os/descriptor.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace gateway {

/// Lets @p events happen until @p is_done; a test that waits in vain fails.
void wait_until(axisd::ServiceEvents& events, const std::function<bool()>& is_done);

/// A daemon as far as its control socket goes, in the loop of the test.
class FakeDaemon {
 public:
  /// Listens at @p path and sends what @p answer gives for each line.
  FakeDaemon(axisd::ServiceEvents& events, const std::string& path,
             std::function<std::string(std::string)> answer);
  FakeDaemon(const FakeDaemon&) = delete;
  FakeDaemon& operator=(const FakeDaemon&) = delete;
  ~FakeDaemon();

  /// Sends @p text to all clients.
  void tell(std::string_view text);
  /// Closes all connections.
  void hang_up() { clients_.clear(); }
  [[nodiscard]] std::size_t clients() const noexcept { return clients_.size(); }
  /// The lines that have come.
  std::list<std::string> lines{};

 private:
  struct Client {
    FakeDaemon* daemon;
    os::Descriptor socket;
    axisd::EventSource source{};
    std::string input{};
  };

  void accept();
  static bool serve(Client& client);

  axisd::ServiceEvents& events_;
  std::string path_;
  std::function<std::string(std::string)> answer_;
  os::Descriptor listener_;
  axisd::EventSource source_;
  std::list<Client> clients_;
};

/// The daemon of one unit, vcan0/5: answers `units`, and {"method": NAME} to all else.
std::string answer_of_unit(const std::string& line);

/// A client of the server in the same loop.
class HttpClient {
 public:
  HttpClient(axisd::ServiceEvents& events, std::uint16_t port);

  void send(std::string_view text);
  /// What has come so far, as soon as @p pattern is in it or the server has closed the connection.
  std::string read_until(std::string_view pattern);
  /// All that comes until the server closes the connection.
  std::string rest() { return read_until("\x01"); }
  [[nodiscard]] bool is_closed() const noexcept { return is_closed_; }

 private:
  axisd::ServiceEvents& events_;
  os::Descriptor socket_;
  std::string input_;
  bool is_closed_ = false;
};

}  // namespace gateway
