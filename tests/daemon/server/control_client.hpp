#pragma once

#include <string>
#include <string_view>

#include "os/descriptor.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// A client of a control server in the same thread: while it waits, it lets the server's events be handled.
class ControlClient {
 public:
  /// Connects to the server at @p path; throws std::runtime_error if nobody listens.
  ControlClient(ServiceEvents& events, const std::string& path);

  /// Sends all of @p text.
  void send(std::string_view text);
  /// Sends what fits before the server stops taking more, at most @p text; returns how much.
  std::size_t send_what_fits(std::string_view text);
  /// The next line without its newline; "" once the server has closed the connection. A server that does neither
  /// fails the test.
  std::string line();
  /// No more will be sent.
  void finish_sending();

 private:
  void wait(short wanted);

  ServiceEvents& events_;
  os::Descriptor descriptor_;
  std::string input_;
};

/// Handles what is pending until nothing is.
void settle(ServiceEvents& events);

}  // namespace axisd
