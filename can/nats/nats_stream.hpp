#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "can/hub/trunk/stream.hpp"
#include "can/nats/join.hpp"
#include "os/descriptor.hpp"
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
  ~NatsStream() override;

  [[nodiscard]] int descriptor() const noexcept override { return ready_.descriptor(); }
  [[nodiscard]] State advance() noexcept override;
  [[nodiscard]] bool receive(Message& message) noexcept override;
  void publish(std::span<const std::byte> bytes) noexcept override;
  void reopen() noexcept override;
  [[nodiscard]] std::string take_problem() override;

 private:
  void connect(const std::stop_token& stop);
  [[nodiscard]] bool is_wanted(const std::stop_token& stop);
  void wait(const std::stop_token& stop, std::chrono::milliseconds time);
  void hand_over(std::unique_ptr<Membership> member);
  void report(const std::string& problem);
  void ring() noexcept;
  void accept() noexcept;
  void serve_socket() noexcept;
  void write() noexcept;

  Bus bus_;
  os::Descriptor bell_;  ///< the thread has something
  os::Pollable ready_;   ///< of the bell, and of the socket
  std::unique_ptr<Membership> member_;
  bool is_written_later_ = false;  ///< the socket is watched for room
  nats::Message message_;          ///< that receive() gave last

  std::mutex mutex_;  ///< of what the thread shares: the rest of the members
  std::condition_variable_any wanted_;
  bool is_wanted_ = true;                 ///< a connection shall be made
  std::unique_ptr<Membership> made_;      ///< one that was
  std::unique_ptr<Membership> given_up_;  ///< to be closed by the thread
  std::string problem_;
  std::string told_;  ///< the last one that was told
  std::jthread thread_;
};

}  // namespace nats
