#include "tools/axisctl/client.hpp"

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/time.h>

#include "control/protocol.hpp"
#include "control/socket_name.hpp"
#include "os/descriptor.hpp"
#include "tools/axisctl/server_trust.hpp"

namespace axisctl {

namespace {

using Failure = tl::unexpected<std::string>;

// A daemon that is alive answers within a turn of its event loop.
constexpr timeval kPatience{10, 0};
constexpr int kRequestId = 1;

std::string reason() {
  return std::generic_category().message(errno);
}

tl::expected<os::Descriptor, std::string> connect_to(const std::string& path) {
  const auto address = control::socket_address(path);
  if (!address) return Failure{address.error()};
  os::Descriptor socket{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  if (!socket) return Failure{"socket: " + reason()};
  ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &kPatience, sizeof kPatience);
  ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &kPatience, sizeof kPatience);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return Failure{fmt::format("{}: no daemon answers here ({})", path, reason())};
  if (const auto trusted = check_server(socket.get(), path); !trusted) return Failure{trusted.error()};
  return socket;
}

bool send_all(const os::Descriptor& socket, std::string_view rest) {
  while (!rest.empty()) {
    const ssize_t sent = ::send(socket.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

/// One line without its newline.
tl::expected<std::string, std::string> read_line(const os::Descriptor& socket) {
  std::string line;
  std::array<char, 4096> part{};
  while (line.size() < control::kMaximumLine) {
    const ssize_t size = ::recv(socket.get(), part.data(), part.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
      return Failure{fmt::format("no answer within {} s", kPatience.tv_sec)};
    if (size == 0 || (size < 0 && errno == ECONNRESET))
      return Failure{"the daemon closed the connection without an answer"};
    if (size < 0) return Failure{reason()};
    const std::string_view got{part.data(), static_cast<std::size_t>(size)};
    const std::size_t end = got.find('\n');
    line.append(got.substr(0, end));
    if (end != std::string_view::npos && line.size() < control::kMaximumLine) return line;
  }
  return Failure{fmt::format("the answer is longer than {} bytes", control::kMaximumLine)};
}

}  // namespace

tl::expected<nlohmann::json, control::AnswerError> ask(const std::string& path, const Call& call) {
  const auto fail = [](std::string message) {
    return tl::unexpected{control::AnswerError{std::nullopt, std::move(message)}};
  };
  const auto socket = connect_to(path);
  if (!socket) return fail(socket.error());
  // A daemon that closes the connection before it has read the request may have said why.
  if (!send_all(*socket, control::request_line(kRequestId, call.method, call.params)) && errno != EPIPE)
    return fail(fmt::format("{}: {}", path, reason()));
  const auto line = read_line(*socket);
  if (!line) return fail(fmt::format("{}: {}", path, line.error()));
  return control::parse_answer(*line, kRequestId);
}

}  // namespace axisctl
