#pragma once

#include <memory>
#include <string>
#include <vector>

#include "can/hub/trunk/stream.hpp"
#include "can/nats/connector.hpp"
#include "can/nats/join.hpp"
#include "can/nats/tls/tls_records.hpp"
#include "os/pollable.hpp"

namespace nats {

/// The stream of a bus on a NATS server with JetStream.
///
/// Connecting waits for the server, and a thread does it. The connection that it has made is served by whoever has
/// this: no thread stands between a frame and the socket.
class NatsStream final : public hub::trunk::Stream {
 public:
  /// Begins to connect; std::system_error if the kernel gives no descriptor or thread.
  explicit NatsStream(Bus bus);
  NatsStream(const NatsStream&) = delete;
  NatsStream& operator=(const NatsStream&) = delete;
  ~NatsStream() override = default;

  [[nodiscard]] int descriptor() const noexcept override { return ready_.descriptor(); }
  [[nodiscard]] State advance() noexcept override;
  [[nodiscard]] bool receive(Message& message) noexcept override;
  void publish(std::span<const std::byte> bytes) noexcept override;
  void flush() noexcept override;
  void reopen() noexcept override;
  [[nodiscard]] std::string take_problem() override;
  void ask(std::span<const std::byte> bytes) noexcept override;
  void listen(bool on) noexcept override;
  [[nodiscard]] bool receive_request(Message& message) noexcept override;

 private:
  [[nodiscard]] natsConnection* connection() const noexcept { return member_->polled->connection.get(); }
  void accept() noexcept;
  /// Whether the library can be let read without waiting.
  [[nodiscard]] bool may_read() noexcept;
  void publish(const std::string& subject, std::span<const std::byte> bytes) noexcept;
  /// The next message of @p subscription, kept for a while; nullptr if there is none.
  [[nodiscard]] natsMsg* next_of(const Subscription& subscription) noexcept;

  Bus bus_;
  os::Pollable ready_;  ///< of the socket, or of the connector while there is none
  std::unique_ptr<Membership> member_;
  bool is_written_later_ = false;  ///< the socket is watched for room
  TlsRecords records_;
  std::vector<nats::Message> received_;  ///< the last ones are what receive() gave last
  Connector<Membership> connector_;
};

}  // namespace nats
