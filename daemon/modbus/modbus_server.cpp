#include "daemon/modbus/modbus_server.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/socket.h>

#include "daemon/modbus/listener.hpp"

namespace axisd {
namespace {

/// Requests of a client that are answered in one go.
constexpr std::size_t kShare = 4;
/// What the listener is called among the places of the clients.
constexpr std::uint64_t kListener = ModbusServer::kMostClients;

os::Descriptor nothing() noexcept {
  return os::Descriptor{::open("/dev/null", O_RDONLY | O_CLOEXEC)};
}

bool is_later(int reason) noexcept {
  return reason == EAGAIN || reason == EINTR;
}

}  // namespace

ModbusServer::ModbusServer(const ModbusSettings& settings, modbus::Service& service)
    : service_{service}, spare_{nothing()} {
  Listener listener = listen_at(settings);
  listener_ = std::move(listener.descriptor);
  place_ = std::move(listener.place);
  if (!events_.add(listener_.get(), EPOLLIN, kListener))
    throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
}

std::size_t ModbusServer::clients() const noexcept {
  return static_cast<std::size_t>(
      std::ranges::count_if(clients_, [](const auto& client) { return client.has_value(); }));
}

void ModbusServer::handle() noexcept {
  const auto ready = events_.take();
  if (!ready) return;
  ready->name == kListener ? accept() : serve(static_cast<std::size_t>(ready->name), ready->events);
}

void ModbusServer::accept() noexcept {
  os::Descriptor socket = accept_at(listener_);
  if (!socket) {
    if (errno == EMFILE || errno == ENFILE) free_descriptor();
    return;
  }
  auto* const place = std::ranges::find_if(clients_, [](const auto& client) { return !client; });
  if (place == clients_.end() || !service_.is_available()) {
    ++turned_away_;
    return;
  }
  const auto name = static_cast<std::uint64_t>(place - clients_.begin());
  if (!events_.add(socket.get(), EPOLLIN, name)) return;
  place->emplace(std::move(socket), service_, counters_).events = EPOLLIN;
}

/// The connection would stay in the queue of the listener and wake the loop over and over.
void ModbusServer::free_descriptor() noexcept {
  spare_ = os::Descriptor{};
  static_cast<void>(accept_at(listener_));
  spare_ = nothing();
  ++turned_away_;
}

void ModbusServer::serve(std::size_t place, std::uint32_t events) noexcept {
  if (exchange(*clients_[place], events)) return listen_to(place);
  close(place);
}

/// False if the connection is over.
bool ModbusServer::exchange(Client& client, std::uint32_t events) noexcept {
  if (!service_.is_available()) return false;
  const bool is_broken = (events & (EPOLLERR | EPOLLHUP)) != 0;
  const bool receives = (events & EPOLLIN) != 0;
  if (is_broken && !receives) return false;
  if (receives && !receive(client)) return false;
  client.connection.answer(kShare);
  if (service_.take_command()) client.commands = true;
  return send(client) && !client.connection.is_over();
}

bool ModbusServer::receive(Client& client) noexcept {
  const std::span<std::uint8_t> room = client.connection.room();
  if (room.empty()) return true;
  const ssize_t got = ::recv(client.descriptor.get(), room.data(), room.size(), 0);
  if (got < 0) return is_later(errno);
  got == 0 ? client.connection.on_end() : client.connection.on_received(static_cast<std::size_t>(got));
  return true;
}

bool ModbusServer::send(Client& client) noexcept {
  const std::span<const std::uint8_t> bytes = client.connection.to_send();
  if (bytes.empty()) return true;
  const ssize_t sent = ::send(client.descriptor.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (sent < 0) return is_later(errno);
  client.connection.on_sent(static_cast<std::size_t>(sent));
  return true;
}

/// A client whose requests wait here is served again when it could take the answers, at once as a rule.
void ModbusServer::listen_to(std::size_t place) noexcept {
  Client& client = *clients_[place];
  const bool writes = !client.connection.to_send().empty() || client.connection.has_request();
  const std::uint32_t wanted =
      (writes ? std::uint32_t{EPOLLOUT} : 0U) | (client.connection.room().empty() ? 0U : std::uint32_t{EPOLLIN});
  if (wanted == client.events) return;
  client.events = wanted;
  if (!events_.change(client.descriptor.get(), wanted, place)) close(place);
}

void ModbusServer::close(std::size_t place) noexcept {
  const bool commanded = clients_[place]->commands;
  clients_[place].reset();
  if (commanded) service_.on_command_lost();
}

}  // namespace axisd
