#include "can/port/socketcand/socketcand_client.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>

#include "can/port/socket_option.hpp"

namespace bus::socketcand {

namespace {

constexpr int kOn = 1;
// A server whose machine has vanished without a word is found out within some ten seconds.
constexpr int kSilence = 5;              // s until the kernel asks whether the server lives
constexpr int kInterval = 2;             // s between two questions
constexpr int kQuestions = 3;            // without an answer
constexpr unsigned kUnconfirmed = 5000;  // ms that what was sent may stay unconfirmed

std::string text_of(int error) {
  return std::generic_category().message(error);
}

bool is_writable(const os::Descriptor& socket) noexcept {
  pollfd wanted{socket.get(), POLLOUT, 0};
  return ::poll(&wanted, 1, 0) == 1;
}

int error_of(const os::Descriptor& socket) noexcept {
  int error = 0;
  socklen_t length = sizeof error;
  return ::getsockopt(socket.get(), SOL_SOCKET, SO_ERROR, &error, &length) == 0 ? error : errno;
}

/// What a server answers a step with.
template <class Answer>
bool is(const tl::expected<Message, std::string_view>& message) noexcept {
  return message && std::holds_alternative<Answer>(*message);
}

}  // namespace

bool Client::begin(const SocketAddress& server, std::string name) {
  close();
  name_ = std::move(name);
  reader_ = {};
  socket_ = os::Descriptor{::socket(server.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  if (socket_) {
    set_option(socket_, IPPROTO_TCP, TCP_NODELAY, kOn);
    set_option(socket_, SOL_SOCKET, SO_KEEPALIVE, kOn);
    set_option(socket_, IPPROTO_TCP, TCP_KEEPIDLE, kSilence);
    set_option(socket_, IPPROTO_TCP, TCP_KEEPINTVL, kInterval);
    set_option(socket_, IPPROTO_TCP, TCP_KEEPCNT, kQuestions);
    set_option(socket_, IPPROTO_TCP, TCP_USER_TIMEOUT, kUnconfirmed);
  }
  stage_ = Stage::Connecting;
  if (socket_ && (::connect(socket_.get(), server.get(), server.length) == 0 || errno == EINPROGRESS)) return true;
  fail(text_of(errno));
  return false;
}

void Client::close() noexcept {
  socket_ = os::Descriptor{};
  stage_ = Stage::Closed;
}

void Client::fail(std::string problem) {
  problem_ = std::move(problem);
  close();
}

void Client::advance() {
  if (stage_ == Stage::Connecting) on_connected();
  std::string_view text;
  while (stage_ > Stage::Connecting && stage_ < Stage::Raw) {
    switch (read(text)) {
      case Found::Nothing:
        return;
      case Found::Text:
        on_message(text);
        break;
      case Found::Malformed:
        return fail("is no socketcand server");
      case Found::End:
        return fail("the server has closed the connection");
    }
  }
}

void Client::on_connected() {
  if (!is_writable(socket_)) return;
  const int error = error_of(socket_);
  if (error != 0) return fail(text_of(error));
  stage_ = Stage::Greeting;
}

void Client::on_message(std::string_view text) {
  const auto message = parse(text);
  if (is<Error>(message))
    return fail(fmt::format("the server refuses {}: {}", name_, std::get<Error>(*message).text));
  const bool expected = stage_ == Stage::Greeting ? is<Hi>(message) : is<Ok>(message);
  if (!expected) return fail(fmt::format("unexpected answer of the server: {}", text));
  if (stage_ == Stage::Greeting) {
    stage_ = Stage::Opening;
    say(Open{name_});
  } else if (stage_ == Stage::Opening) {
    stage_ = Stage::Switching;
    say(RawMode{});
  } else {
    stage_ = Stage::Raw;
  }
}

/// The buffer of a new connection has room for what is said before raw mode.
void Client::say(const Message& message) {
  Room room{};
  const std::string_view text = print(message, room);
  if (::send(socket_.get(), text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL) !=
      static_cast<ssize_t>(text.size()))
    fail(text_of(errno));
}

SendStatus Client::send(const canopen::Frame& frame) noexcept {
  Room room{};
  const std::string_view text = print(Send{frame}, room);
  if (text.empty()) return SendStatus::Failed;
  // A socket that polls writable has room for a whole message.
  if (!is_writable(socket_)) return SendStatus::Full;
  const ssize_t sent = ::send(socket_.get(), text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (sent == static_cast<ssize_t>(text.size())) return SendStatus::Sent;
  if (sent < 0 && errno == EAGAIN) return SendStatus::Full;
  // Half a message would spoil the next one, so the connection ends; read() tells it.
  ::shutdown(socket_.get(), SHUT_RDWR);
  return SendStatus::Down;
}

Client::Found Client::read(std::string_view& text) noexcept {
  using Kind = MessageReader::Found::Kind;
  for (;;) {
    // Nothing is read beyond the end of a message: what waits must stay in the socket, which poll(2) shows.
    const std::span<char> room = reader_.room();
    const ssize_t waiting = ::recv(socket_.get(), room.data(), room.size(), MSG_PEEK | MSG_DONTWAIT);
    if (waiting < 0 && errno == EAGAIN) return Found::Nothing;
    if (waiting <= 0) return Found::End;
    const auto beginning = room.first(static_cast<std::size_t>(waiting));
    const auto end = std::find(beginning.begin(), beginning.end(), '>');
    const auto size = static_cast<std::size_t>(end - beginning.begin()) + (end == beginning.end() ? 0 : 1);
    if (::recv(socket_.get(), room.data(), size, MSG_DONTWAIT) != static_cast<ssize_t>(size)) return Found::End;
    reader_.filled(size);
    const MessageReader::Found found = reader_.next();
    if (found.kind == Kind::TooLong) return Found::Malformed;
    if (found.kind == Kind::Nothing) continue;
    text = found.text;
    return Found::Text;
  }
}

}  // namespace bus::socketcand
