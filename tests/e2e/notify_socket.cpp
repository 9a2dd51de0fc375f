#include "tests/e2e/notify_socket.hpp"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "tests/e2e/program.hpp"

namespace e2e {

NotifySocket::NotifySocket(std::string path)
    : path_{std::move(path)}, socket_{socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)} {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path_.copy(address.sun_path, sizeof address.sun_path - 1);
  if (bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::system_error{errno, std::generic_category(), path_};
  }
}

bool NotifySocket::wait_for(std::string_view line) {
  pollfd wanted{socket_.get(), POLLIN, 0};
  while (poll(&wanted, 1, static_cast<int>(std::chrono::milliseconds{kPatience}.count())) == 1) {
    std::array<char, 4096> bytes;
    const ssize_t size = recv(socket_.get(), bytes.data(), bytes.size(), 0);
    if (size < 0) return false;
    messages_.emplace_back(bytes.data(), static_cast<std::size_t>(size));
    const std::string lines = '\n' + messages_.back() + '\n';
    if (lines.find('\n' + std::string{line} + '\n') != std::string::npos) return true;
  }
  return false;
}

}  // namespace e2e
