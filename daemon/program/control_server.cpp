#include "daemon/program/control_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "control/protocol.hpp"
#include "control/socket_name.hpp"
#include "daemon/program/instance_lock.hpp"

namespace axisd {
namespace {

constexpr std::size_t kMostClients = 64;
constexpr int kBacklog = 16;
/// From a connection that could not be accepted to the next try.
constexpr std::chrono::seconds kPause{1};

InstanceError failure(const std::string& path, std::string_view what) {
  return InstanceError{fmt::format("control socket {}: {}", path, what)};
}

/// True if a server answers at @p address; a socket left behind by a killed one refuses.
bool is_served(const sockaddr_un& address) {
  const os::Descriptor probe{socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  return connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

bool is_socket(const std::string& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode);
}

/// Everybody may take a name in /tmp, and what lies there is then neither asked nor removed.
void expect_ours(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || status.st_uid == geteuid() || geteuid() == 0) return;
  throw failure(path, fmt::format("the name is taken by user {}; --control names another one", status.st_uid));
}

os::Descriptor listen_at(const std::string& path) {
  const auto address = control::socket_address(path);
  if (!address) throw failure(path, address.error());
  expect_ours(path);
  if (is_socket(path)) {
    if (is_served(*address)) throw failure(path, "another axisd serves it");
    unlink(path.c_str());
  }
  os::Descriptor descriptor{socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  const mode_t previous = umask(0177);  // mode 0600 from the first moment
  const int bound = bind(descriptor.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address);
  const int reason = errno;
  umask(previous);
  if (bound != 0) throw failure(path, std::strerror(reason));
  if (listen(descriptor.get(), kBacklog) != 0) throw failure(path, std::strerror(errno));
  return descriptor;
}

bool has_line(std::string_view text) noexcept {
  return text.find('\n') != std::string_view::npos;
}

}  // namespace

ControlServer::ControlServer(ServiceEvents& events, std::string path, Answer answer)
    : events_{events}, path_{std::move(path)}, answer_{std::move(answer)}, listener_{listen_at(path_)} {
  source_ = events_.watch(listener_.get(), EPOLLIN, &ControlServer::on_connection, this);
  pause_ = events_.timer(&ControlServer::on_pause_over, this);
}

ControlServer::~ControlServer() {
  unlink(path_.c_str());
}

int ControlServer::on_connection(sd_event_source*, int, std::uint32_t, void* self) noexcept {
  static_cast<ControlServer*>(self)->accept();
  return 0;
}

int ControlServer::on_client(sd_event_source*, int, std::uint32_t events, void* client) noexcept {
  auto& known = *static_cast<Client*>(client);
  if (!known.server->serve(known, events)) known.server->close(known);
  return 0;
}

void ControlServer::accept() {
  os::Descriptor descriptor{accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK)};
  if (!descriptor) {
    const bool is_out_of_means = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
    if (is_out_of_means) pause();
    return;
  }
  if (clients_.size() >= kMostClients) make_room();
  Client& client = clients_.emplace_back(Client{this, std::move(descriptor), nullptr, {}, {}});
  client.source = events_.watch(client.descriptor.get(), EPOLLIN, &ControlServer::on_client, &client);
}

/// The connection stays in the queue of the listener and would wake the loop over and over.
void ControlServer::pause() {
  sd_event_source_set_enabled(source_.get(), SD_EVENT_OFF);
  ServiceEvents::start(pause_, kPause);
}

int ControlServer::on_pause_over(sd_event_source*, std::uint64_t, void* self) noexcept {
  sd_event_source_set_enabled(static_cast<ControlServer*>(self)->source_.get(), SD_EVENT_ON);
  return 0;
}

void ControlServer::make_room() {
  Client& client = clients_.front();
  refuse(client, "the connection was idle, and others need its place");
  static_cast<void>(flush(client));
  close(client);
}

void ControlServer::close(const Client& client) {
  clients_.remove_if([&](const Client& known) { return &known == &client; });
}

/// False if the client is to be closed.
bool ControlServer::serve(Client& client, std::uint32_t events) {
  if ((events & EPOLLIN) != 0 && !read(client)) return false;
  if (client.output.empty()) answer_line(client);
  const bool too_long = client.input.size() >= control::kMaximumLine && !has_line(client.input);
  if (too_long) refuse(client, fmt::format("a request is longer than {} bytes", control::kMaximumLine));
  return flush(client) && !too_long;
}

bool ControlServer::read(Client& client) {
  std::array<char, 4096> chunk{};
  const ssize_t got = recv(client.descriptor.get(), chunk.data(), chunk.size(), 0);
  if (got <= 0) return got < 0 && (errno == EAGAIN || errno == EINTR);
  client.input.append(chunk.data(), static_cast<std::size_t>(got));
  return true;
}

void ControlServer::answer_line(Client& client) {
  const std::size_t end = client.input.find('\n');
  if (end == std::string::npos) return;
  client.output += answer_(std::string_view{client.input}.substr(0, end));
  client.input.erase(0, end + 1);
  const auto place = std::ranges::find(clients_, &client, [](const Client& known) { return &known; });
  clients_.splice(clients_.end(), clients_, place);
}

void ControlServer::refuse(Client& client, std::string_view message) {
  client.output += control::error_line(nullptr, {control::ErrorCode::Overflow, std::string{message}});
}

bool ControlServer::flush(Client& client) {
  const ssize_t sent = client.output.empty() ? 0
                                             : send(client.descriptor.get(), client.output.data(),
                                                    client.output.size(), MSG_NOSIGNAL);
  if (sent < 0 && errno != EAGAIN && errno != EINTR) return false;
  if (sent > 0) client.output.erase(0, static_cast<std::size_t>(sent));
  // A client that does not read its answers is asked for no more requests until it does; one whose requests wait
  // here is served again when it could take the answer.
  const bool waits = !client.output.empty() || has_line(client.input);
  sd_event_source_set_io_events(client.source.get(), waits ? EPOLLOUT : EPOLLIN);
  return true;
}

}  // namespace axisd
