#include "farm/mirror/connections.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "control/protocol.hpp"

namespace farm {
namespace {

constexpr std::size_t kBlock = 16384;

}  // namespace

void Connections::add(os::Descriptor socket, Order order) {
  Connection& added = all_.emplace_back(Connection{this, ++last_, std::move(socket), order});
  added.source = events_.watch(added.socket.get(), EPOLLIN, &Connections::on_ready, &added);
}

void Connections::answer(const Ticket& ticket, std::string line) {
  Connection* const connection = find(ticket.client);
  if (connection == nullptr || connection->is_ending) return;
  --connection->waiting;
  put(*connection, ticket.number, std::move(line));
  listen_to(*connection);
}

/// What was asked before has its answer first, where that is the order.
void Connections::put(Connection& connection, std::uint64_t number, std::string line) {
  if (connection.order == Order::AsAnswered) {
    connection.output += line;
    return;
  }
  connection.answers[number - connection.first] = std::move(line);
  while (!connection.answers.empty() && connection.answers.front()) {
    connection.output += *connection.answers.front();
    connection.answers.pop_front();
    ++connection.first;
  }
}

void Connections::tell(Id client, std::string_view line) {
  Connection* const connection = find(client);
  if (connection == nullptr || connection->is_ending) return;
  connection->output += line;
  if (connection->output.size() > kMostUnread && flush(*connection) && connection->output.size() > kMostUnread) {
    ++cut_off_;
    connection->is_ending = true;
    ::shutdown(connection->socket.get(), SHUT_RDWR);  // which wakes it
  }
  listen_to(*connection);
}

void Connections::end(Id client, const control::Error& why) {
  Connection* const connection = find(client);
  if (connection == nullptr || connection->is_ending) return;
  connection->output += control::error_line(nullptr, why);
  connection->is_ending = true;
  listen_to(*connection);
}

Connections::Connection* Connections::find(Id id) noexcept {
  const auto found = std::ranges::find(all_, id, &Connection::id);
  return found == all_.end() ? nullptr : &*found;
}

bool Connections::has(Id client) const noexcept {
  return std::ranges::find(all_, client, &Connection::id) != all_.end();
}

int Connections::on_ready(sd_event_source*, int, std::uint32_t events, void* connection) noexcept {
  auto& ready = *static_cast<Connection*>(connection);
  Connections& owner = *ready.owner;
  if (owner.serve(ready, events)) {
    listen_to(ready);
    return 0;
  }
  const Id gone = ready.id;
  owner.all_.remove_if([gone](const Connection& each) { return each.id == gone; });
  owner.listener_.on_gone(gone);
  return 0;
}

/// False if the connection is over.
bool Connections::serve(Connection& connection, std::uint32_t events) {
  if ((events & EPOLLERR) != 0) return false;
  if ((events & EPOLLIN) != 0 && !connection.is_ending && !read(connection)) return false;
  if ((events & (EPOLLIN | EPOLLHUP)) == EPOLLHUP) return false;
  take_lines(connection);
  return flush(connection) && !(connection.is_ending && connection.output.empty());
}

bool Connections::read(Connection& connection) {
  std::array<char, kBlock> block{};
  const ssize_t got = ::recv(connection.socket.get(), block.data(), block.size(), MSG_DONTWAIT);
  if (got <= 0) return got < 0 && (errno == EAGAIN || errno == EINTR);
  connection.input.append(block.data(), static_cast<std::size_t>(got));
  return true;
}

bool Connections::may_ask(const Connection& connection) noexcept {
  return !connection.is_ending && connection.waiting < kMostWaiting && connection.output.size() < kMostUnread / 4;
}

void Connections::take_lines(Connection& connection) {
  std::size_t begin = 0;
  for (std::size_t end = connection.input.find('\n'); end != std::string::npos && may_ask(connection);
       end = connection.input.find('\n', begin)) {
    const Ticket ticket{connection.id, connection.next++};
    ++connection.waiting;
    if (connection.order == Order::AsAsked) connection.answers.emplace_back();
    listener_.on_line(ticket, std::string_view{connection.input}.substr(begin, end - begin));
    begin = end + 1;
  }
  connection.input.erase(0, begin);
  if (connection.input.size() < control::kMaximumLine || connection.input.find('\n') != std::string::npos) return;
  end(connection.id,
      {control::ErrorCode::Overflow, fmt::format("a request is longer than {} bytes", control::kMaximumLine)});
}

bool Connections::flush(Connection& connection) noexcept {
  while (!connection.output.empty()) {
    const ssize_t sent = ::send(connection.socket.get(), connection.output.data(), connection.output.size(),
                                MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return errno == EAGAIN;
    connection.output.erase(0, static_cast<std::size_t>(sent));
  }
  return true;
}

/// Lines that wait in the input are taken with the next turn in which the socket may be written to.
void Connections::listen_to(Connection& connection) noexcept {
  const bool asks = may_ask(connection);
  const bool writes = !connection.output.empty() || connection.is_ending ||
                      (asks && connection.input.find('\n') != std::string::npos);
  sd_event_source_set_io_events(connection.source.get(), (writes ? EPOLLOUT : 0U) | (asks ? EPOLLIN : 0U));
}

}  // namespace farm
