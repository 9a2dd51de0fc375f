#include "can/nats/reach.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/nats/nats_handles.hpp"
#include "os/descriptor.hpp"

namespace nats {

namespace {

using Clock = std::chrono::steady_clock;
using Addresses = std::unique_ptr<addrinfo, Destroyer<freeaddrinfo>>;

/// Connections that are being made, to all addresses at the same time.
class Attempts {
 public:
  void begin(const addrinfo& address) {
    os::Descriptor socket{::socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    if (!socket || (connect(socket.get(), address.ai_addr, address.ai_addrlen) != 0 && errno != EINPROGRESS)) {
      error_ = errno;
      return;
    }
    wanted_.push_back({socket.get(), POLLOUT, 0});
    sockets_.push_back(std::move(socket));
  }
  /// Waits for the first that is made; 0, or the errno of one that was not.
  [[nodiscard]] int wait_until(Clock::time_point end) {
    for (std::size_t left = wanted_.size(); left > 0;) {
      const auto rest = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
      if (poll(wanted_.data(), wanted_.size(), static_cast<int>(std::max<std::int64_t>(rest, 0))) == 0)
        return ETIMEDOUT;
      for (pollfd& each : wanted_) {
        if (each.fd < 0 || each.revents == 0) continue;
        error_ = error_of(each.fd);
        if (error_ == 0) return 0;
        each.fd = -1;
        --left;
      }
    }
    return error_;
  }

 private:
  static int error_of(int socket) noexcept {
    int error = 0;
    socklen_t size = sizeof error;
    return getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
  }

  std::vector<os::Descriptor> sockets_;
  std::vector<pollfd> wanted_;
  int error_ = EADDRNOTAVAIL;
};

}  // namespace

tl::expected<void, std::string> reach(const std::string& host, const std::string& port,
                                      std::chrono::milliseconds patience) {
  const auto failed = [&](const std::string& why) {
    return tl::unexpected{fmt::format("{} cannot be reached: {}", host, why)};
  };
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(host.c_str(), port.c_str(), &hints, &found); error != 0)
    return failed(gai_strerror(error));
  const Addresses addresses{found};
  Attempts attempts;
  for (const addrinfo* address = found; address != nullptr; address = address->ai_next) attempts.begin(*address);
  if (const int error = attempts.wait_until(Clock::now() + patience); error != 0)
    return failed(std::generic_category().message(error));
  return {};
}

}  // namespace nats
