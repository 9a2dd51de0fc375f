#include "daemon/server/control_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "control/protocol.hpp"
#include "control/socket_name.hpp"
#include "daemon/base/instance_error.hpp"

namespace axisd {
namespace {

constexpr std::size_t kMostClients = 256;
/// What a client may leave unread of the lines that it has subscribed to (bytes).
constexpr std::size_t kMostUnread = std::size_t{1} << 20;
constexpr int kBacklog = 128;
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

/// A service whose own group it is need not be allowed to change owners.
void open_to_group(const std::string& path, gid_t group) {
  if (group != getegid() && chown(path.c_str(), static_cast<uid_t>(-1), group) != 0)
    throw failure(path, fmt::format("cannot be given to group {}: {}", group, std::strerror(errno)));
  if (chmod(path.c_str(), S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP) != 0) throw failure(path, std::strerror(errno));
}

os::Descriptor listen_at(const ControlSocket& socket) {
  os::Descriptor descriptor = listen_at(socket.path);
  if (!socket.group) return descriptor;
  try {
    open_to_group(socket.path, *socket.group);
  } catch (const InstanceError&) {
    unlink(socket.path.c_str());
    throw;
  }
  return descriptor;
}

bool has_line(std::string_view text) noexcept {
  return text.find('\n') != std::string_view::npos;
}

}  // namespace

ControlServer::ControlServer(ServiceEvents& events, ControlSocket socket, Requests& requests)
    : events_{events}, socket_{std::move(socket)}, requests_{requests}, listener_{listen_at(socket_)} {
  source_ = events_.watch(listener_.get(), EPOLLIN, &ControlServer::on_connection, this);
  pause_ = events_.timer(&ControlServer::on_pause_over, this);
}

ControlServer::~ControlServer() {
  unlink(socket_.path.c_str());
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
  Client& client = clients_.emplace_back(Client{this, ++last_id_, std::move(descriptor), nullptr});
  try {
    client.source = events_.watch(client.descriptor.get(), EPOLLIN, &ControlServer::on_client, &client);
  } catch (const std::system_error&) {  // the kernel has no memory for it: who has connected finds it closed
    clients_.pop_back();
    pause();
  }
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

/// Who has subscribed to something makes room only where all have.
void ControlServer::make_room() {
  const auto idle = std::ranges::find(clients_, false, &Client::is_kept);
  Client& client = idle == clients_.end() ? clients_.front() : *idle;
  refuse(client, "the connection was idle, and others need its place");
  static_cast<void>(flush(client));
  close(client);
}

void ControlServer::close(const Client& client) {
  const ClientId id = client.id;
  clients_.remove_if([&](const Client& known) { return known.id == id; });
  requests_.on_client_gone(id);
}

ControlServer::Client* ControlServer::find(ClientId id) noexcept {
  const auto found = std::ranges::find(clients_, id, &Client::id);
  return found == clients_.end() ? nullptr : &*found;
}

bool ControlServer::has(ClientId id) const noexcept {
  return std::ranges::find(clients_, id, &Client::id) != clients_.end();
}

/// False if the client is to be closed.
bool ControlServer::serve(Client& client, std::uint32_t events) {
  if ((events & (EPOLLHUP | EPOLLERR)) != 0) return false;
  if ((events & EPOLLIN) != 0 && !read(client)) return false;
  if (!client.is_busy && client.output.empty()) take_line(client);
  const bool too_long = client.input.size() >= control::kMaximumLine && !has_line(client.input);
  if (too_long) refuse(client, fmt::format("a request is longer than {} bytes", control::kMaximumLine));
  if (!flush(client) || too_long) return false;
  listen_to(client);
  return true;
}

bool ControlServer::read(Client& client) {
  std::array<char, 4096> chunk{};
  const ssize_t got = recv(client.descriptor.get(), chunk.data(), chunk.size(), 0);
  if (got <= 0) return got < 0 && (errno == EAGAIN || errno == EINTR);
  client.input.append(chunk.data(), static_cast<std::size_t>(got));
  return true;
}

void ControlServer::take_line(Client& client) {
  const std::size_t end = client.input.find('\n');
  if (end == std::string::npos) return;
  const std::string line = client.input.substr(0, end);
  client.input.erase(0, end + 1);
  const auto place = std::ranges::find(clients_, &client, [](const Client& known) { return &known; });
  clients_.splice(clients_.end(), clients_, place);
  client.is_busy = true;
  taking_ = client.id;
  requests_.on_request(client.id, line);
  taking_ = kNobody;
}

void ControlServer::answer(ClientId id, std::string_view line) {
  Client* const client = find(id);
  if (client == nullptr) return;
  client->is_busy = false;
  client->output += line;
  deliver(*client);
}

/// Whose request is being taken is looked after behind it.
void ControlServer::deliver(Client& client) {
  if (client.id == taking_) return;
  if (!flush(client)) return close(client);
  listen_to(client);
}

void ControlServer::push(ClientId id, std::string_view line) {
  Client* const client = find(id);
  if (client == nullptr) return;
  client->output += line;
  if (client->output.size() <= kMostUnread || id == taking_) return deliver(*client);
  ++counters_.cut_off;
  close(*client);
}

void ControlServer::keep(ClientId id, bool kept) noexcept {
  if (Client* const client = find(id)) client->is_kept = kept;
}

void ControlServer::refuse(Client& client, std::string_view message) {
  ++counters_.refused;
  client.output += control::error_line(nullptr, {control::ErrorCode::Overflow, std::string{message}});
}

bool ControlServer::flush(Client& client) {
  const ssize_t sent = client.output.empty() ? 0
                                             : send(client.descriptor.get(), client.output.data(),
                                                    client.output.size(), MSG_NOSIGNAL);
  if (sent < 0 && errno != EAGAIN && errno != EINTR) return false;
  if (sent > 0) client.output.erase(0, static_cast<std::size_t>(sent));
  return true;
}

/// A client that does not read its answers, or has a request under way, is asked for no more requests until then;
/// one whose requests wait here is served again when it could take the answer.
void ControlServer::listen_to(Client& client) {
  const bool writes = !client.output.empty() || (!client.is_busy && has_line(client.input));
  const std::uint32_t events = writes ? EPOLLOUT : client.is_busy ? 0U : EPOLLIN;
  sd_event_source_set_io_events(client.source.get(), events);
}

}  // namespace axisd
