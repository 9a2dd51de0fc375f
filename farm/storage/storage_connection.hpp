#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"
#include "farm/storage/nats_key_value.hpp"
#include "farm/storage/nats_object_store.hpp"

namespace farm {

/// A connection of its own for what waits for the answers of the server.
class StorageConnection {
 public:
  /// For each answer of the server.
  static constexpr std::chrono::milliseconds kPatience{2000};

  /// Connects; the error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<StorageConnection>, std::string> open(
      const nats::Server& server, const std::string& client);
  StorageConnection(const StorageConnection&) = delete;
  StorageConnection& operator=(const StorageConnection&) = delete;
  ~StorageConnection() = default;

  [[nodiscard]] Storage storage() noexcept { return {keys_, objects_}; }
  /// Whether it may be used on. One over which something has failed may not: libnats keeps one open whose
  /// subscription for answers was never sent.
  [[nodiscard]] bool is_good() const noexcept {
    return !natsConnection_IsClosed(connection_.get()) && !keys_.has_failed() && !objects_.has_failed();
  }
  /// Any thread: what waits for the server ends.
  void close() const noexcept { natsConnection_Close(connection_.get()); }

 private:
  StorageConnection(nats::Connection connection, nats::JetStream js)
      : connection_{std::move(connection)}, js_{std::move(js)}, keys_{js_.get()}, objects_{js_.get()} {}

  nats::Connection connection_;
  nats::JetStream js_;
  NatsKeyValue keys_;
  NatsObjectStore objects_;
};

}  // namespace farm
