#include "tests/fakes/control_server.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace fakes {

ControlServer::ControlServer(const std::string& path, std::string answer)
    : listener_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)}, answer_{std::move(answer)} {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw std::runtime_error{"path too long: " + path};
  std::copy(path.begin(), path.end(), address.sun_path);
  if (::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(listener_, 1) != 0)
    throw std::runtime_error{"cannot listen at " + path};
  thread_ = std::thread{[this] { serve(); }};
}

ControlServer::~ControlServer() {
  finish();
  ::close(listener_);
}

std::string ControlServer::request() {
  finish();
  return request_;
}

void ControlServer::serve() {
  const int connection = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
  if (connection < 0) return;
  char byte = 0;
  while (::recv(connection, &byte, 1, 0) == 1 && byte != '\n') request_.push_back(byte);
  std::string_view rest{answer_};
  while (!rest.empty()) {
    const ssize_t sent = ::send(connection, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent <= 0) break;
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
  ::close(connection);
}

void ControlServer::finish() {
  if (!thread_.joinable()) return;
  ::shutdown(listener_, SHUT_RDWR);  // wakes accept() if nobody came; a connection taken already goes on
  thread_.join();
}

}  // namespace fakes
