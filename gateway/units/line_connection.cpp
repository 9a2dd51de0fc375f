#include "gateway/units/line_connection.hpp"

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "control/protocol.hpp"

namespace gateway {
namespace {

constexpr std::size_t kBlock = 16384;

std::string reason() {
  return std::generic_category().message(errno);
}

}  // namespace

LineConnection::LineConnection(axisd::ServiceEvents& events, os::Descriptor socket, Listener& listener)
    : socket_{std::move(socket)}, listener_{listener} {
  source_ = events.watch(socket_.get(), EPOLLIN, &LineConnection::on_ready, this);
}

bool LineConnection::send(std::string_view line) {
  if (output_.size() + line.size() > kMostUnsent) return false;
  output_.append(line);
  // What goes wrong is seen when the socket is ready.
  if (!flush().empty() || !output_.empty()) sd_event_source_set_io_events(source_.get(), EPOLLIN | EPOLLOUT);
  return true;
}

int LineConnection::on_ready(sd_event_source*, int, std::uint32_t events, void* self) noexcept {
  auto& connection = *static_cast<LineConnection*>(self);
  const std::string why = connection.serve(events);
  if (!why.empty()) connection.listener_.on_closed(why);  // which may have been its end
  return 0;
}

std::string LineConnection::serve(std::uint32_t events) {
  if ((events & EPOLLOUT) != 0) {
    if (std::string why = flush(); !why.empty() && (events & EPOLLIN) == 0) return why;
    if (output_.empty()) sd_event_source_set_io_events(source_.get(), EPOLLIN);
  }
  return (events & ~std::uint32_t{EPOLLOUT}) == 0 ? std::string{} : read();
}

std::string LineConnection::read() {
  std::array<char, kBlock> block{};
  const ssize_t size = ::recv(socket_.get(), block.data(), block.size(), 0);
  if (size < 0 && (errno == EAGAIN || errno == EINTR)) return {};
  if (size < 0) return reason();
  if (size == 0) return "the daemon closed the connection";
  input_.append(block.data(), static_cast<std::size_t>(size));
  std::size_t begin = 0;
  for (std::size_t end = input_.find('\n'); end != std::string::npos; end = input_.find('\n', begin)) {
    if (std::string why = listener_.on_line(std::string_view{input_}.substr(begin, end - begin)); !why.empty())
      return why;
    begin = end + 1;
  }
  input_.erase(0, begin);
  if (input_.size() < control::kMaximumLine) return {};
  return fmt::format("the daemon sent a line of more than {} bytes", control::kMaximumLine);
}

std::string LineConnection::flush() {
  while (!output_.empty()) {
    const ssize_t sent = ::send(socket_.get(), output_.data(), output_.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return errno == EAGAIN ? std::string{} : reason();
    output_.erase(0, static_cast<std::size_t>(sent));
  }
  return {};
}

}  // namespace gateway
