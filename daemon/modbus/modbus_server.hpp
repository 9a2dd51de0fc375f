#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "daemon/configuration/settings/modbus_settings.hpp"
#include "modbus/connection.hpp"
#include "modbus/service.hpp"
#include "os/descriptor.hpp"
#include "os/pollable.hpp"

namespace axisd {

/// Serves the registers of one unit to clients of Modbus TCP, on the thread of the unit. It waits for nobody: what
/// a client sends is read when it is there, and what it does not take is kept for it, both within bounds. Nothing
/// is allocated after construction.
class ModbusServer {
 public:
  static constexpr std::size_t kMostClients = 8;

  /// Listens where @p settings say; @p service outlives this. Throws InstanceError if it cannot.
  ModbusServer(const ModbusSettings& settings, modbus::Service& service);
  ~ModbusServer() = default;
  ModbusServer(const ModbusServer&) = delete;
  ModbusServer& operator=(const ModbusServer&) = delete;

  /// Readable while handle() has something to do.
  int descriptor() const noexcept { return events_.descriptor(); }
  /// Does a bounded share of that: a connection is accepted, or a few requests of one client are answered.
  void handle() noexcept;

  /// Address and port, "127.0.0.1:502" or "[::1]:502".
  const std::string& place() const noexcept { return place_; }
  /// Clients that are connected.
  std::size_t clients() const noexcept;
  const modbus::Counters& counters() const noexcept { return counters_; }
  /// Connections that were closed at once because there was no place or no service for them.
  std::uint64_t turned_away() const noexcept { return turned_away_; }

 private:
  struct Client {
    Client(os::Descriptor socket, modbus::Service& service, modbus::Counters& counters) noexcept
        : descriptor{std::move(socket)}, connection{service, counters} {}

    os::Descriptor descriptor;
    modbus::Connection connection;
    std::uint32_t events = 0;  ///< that are waited for
    bool commands = false;     ///< it has written process data
  };

  void accept() noexcept;
  void free_descriptor() noexcept;
  void serve(std::size_t place, std::uint32_t events) noexcept;
  bool exchange(Client& client, std::uint32_t events) noexcept;
  static bool receive(Client& client) noexcept;
  static bool send(Client& client) noexcept;
  void listen_to(std::size_t place) noexcept;
  void close(std::size_t place) noexcept;

  modbus::Service& service_;
  os::Descriptor listener_;
  os::Descriptor spare_;  ///< given up for a connection that there is no descriptor for
  os::Pollable events_;   ///< over the listener and the clients
  std::string place_;
  std::array<std::optional<Client>, kMostClients> clients_;
  modbus::Counters counters_;
  std::uint64_t turned_away_ = 0;
};

}  // namespace axisd
