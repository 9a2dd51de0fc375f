#pragma once

#include <string>
#include <thread>

namespace fakes {

/// The far end of a control socket: takes one connection, keeps the line it was sent, and answers what it was
/// told.
class ControlServer {
 public:
  /// Listens at @p path; the client gets @p answer as it stands, or a closed connection if it is empty.
  ControlServer(const std::string& path, std::string answer);
  ControlServer(const ControlServer&) = delete;
  ControlServer& operator=(const ControlServer&) = delete;
  ~ControlServer();

  /// The request, once the connection is over; empty if nobody came.
  std::string request();

 private:
  void serve();
  void finish();

  int listener_ = -1;
  std::string answer_;
  std::string request_;
  std::thread thread_;
};

}  // namespace fakes
