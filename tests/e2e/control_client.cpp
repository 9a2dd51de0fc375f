#include "tests/e2e/control_client.hpp"

#include <array>
#include <stdexcept>
#include <system_error>

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>

#include "tests/e2e/program.hpp"

namespace e2e {

ControlClient::ControlClient(const std::string& path) : socket_{socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
  const timeval patience{kPatience.count(), 0};
  setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  if (connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::system_error{errno, std::generic_category(), path};
  }
}

void ControlClient::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) throw std::system_error{errno, std::generic_category(), "control socket"};
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

std::string ControlClient::line() {
  std::size_t end = 0;
  while ((end = rest_.find('\n')) == std::string::npos) {
    std::array<char, 4096> part;
    const ssize_t size = recv(socket_.get(), part.data(), part.size(), 0);
    if (size <= 0) throw std::runtime_error{size == 0 ? "the daemon hung up" : "no answer"};
    rest_.append(part.data(), static_cast<std::size_t>(size));
  }
  std::string result = rest_.substr(0, end);
  rest_.erase(0, end + 1);
  return result;
}

nlohmann::json ControlClient::ask(const nlohmann::json& request) {
  send(request.dump() + '\n');
  return nlohmann::json::parse(line());
}

}  // namespace e2e
