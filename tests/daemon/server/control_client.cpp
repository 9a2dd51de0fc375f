#include "tests/daemon/server/control_client.hpp"

#include <array>
#include <stdexcept>

#include <poll.h>
#include <sys/socket.h>

#include "control/socket_name.hpp"

namespace axisd {
namespace {
constexpr int kPatience_ms = 20'000;  // only a broken server takes it
}

ControlClient::ControlClient(ServiceEvents& events, const std::string& path)
    : events_{events}, descriptor_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)} {
  const sockaddr_un address = control::socket_address(path).value();
  if (::connect(descriptor_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error{"nobody listens at " + path};
}

void ControlClient::wait(short wanted) {
  std::array<pollfd, 2> ends{pollfd{descriptor_.get(), wanted, 0}, pollfd{events_.descriptor(), POLLIN, 0}};
  if (::poll(ends.data(), ends.size(), kPatience_ms) <= 0) throw std::runtime_error{"the server does nothing"};
  if (ends[1].revents != 0) events_.dispatch();
}

void ControlClient::send(std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = ::send(descriptor_.get(), text.data(), text.size(), MSG_NOSIGNAL);
    if (sent > 0)
      text.remove_prefix(static_cast<std::size_t>(sent));
    else if (errno == EAGAIN)
      wait(POLLOUT);
    else
      throw std::runtime_error{"the server has closed the connection"};
  }
}

std::size_t ControlClient::send_what_fits(std::string_view text) {
  std::size_t total = 0;
  for (bool stuck = false; total < text.size();) {
    const ssize_t sent = ::send(descriptor_.get(), text.data() + total, text.size() - total, MSG_NOSIGNAL);
    if (sent > 0) {
      total += static_cast<std::size_t>(sent);
      stuck = false;
    } else if (stuck) {
      break;
    } else {
      settle(events_);
      stuck = true;
    }
  }
  return total;
}

std::string ControlClient::line() {
  for (;;) {
    if (const std::size_t end = input_.find('\n'); end != std::string::npos) {
      std::string line = input_.substr(0, end);
      input_.erase(0, end + 1);
      return line;
    }
    std::array<char, 4096> part;
    const ssize_t got = ::recv(descriptor_.get(), part.data(), part.size(), 0);
    if (got > 0)
      input_.append(part.data(), static_cast<std::size_t>(got));
    else if (got < 0 && errno == EAGAIN)
      wait(POLLIN);
    else
      return "";
  }
}

void ControlClient::finish_sending() {
  ::shutdown(descriptor_.get(), SHUT_WR);
}

void settle(ServiceEvents& events) {
  pollfd end{events.descriptor(), POLLIN, 0};
  for (bool waits = false; waits || ::poll(&end, 1, 0) > 0;) waits = events.dispatch();
}

}  // namespace axisd
