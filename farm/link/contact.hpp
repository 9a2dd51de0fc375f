#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/polled_connection.hpp"
#include "farm/link/arrivals.hpp"

namespace farm {

/// One connection to the server, from its beginning to its end.
class Contact {
 public:
  /// Connects; may wait for the server. The error is one line.
  [[nodiscard]] static tl::expected<std::unique_ptr<Contact>, std::string> make(
      const nats::Server& server, const std::string& client, std::chrono::milliseconds patience);
  Contact(const Contact&) = delete;
  Contact& operator=(const Contact&) = delete;
  ~Contact() = default;

  /// The socket, to be polled: EPOLLIN, and EPOLLOUT while wants_to_write().
  [[nodiscard]] int socket() const noexcept { return polled_->socket; }
  [[nodiscard]] bool wants_to_write() const noexcept { return polled_->wants_to_write; }
  void read() noexcept;
  void write() noexcept;
  /// Why it has ended; empty while it has not.
  [[nodiscard]] std::string why_closed() const;
  /// What the server has complained of last; empty if of nothing.
  [[nodiscard]] std::string complaint() const;
  /// What has been read.
  [[nodiscard]] Arrivals& arrivals() const noexcept { return *arrivals_; }

  /// Messages of @p subject arrive as those of subscription @p id until what it gives is destroyed. The error is
  /// one line: the server does not have it.
  [[nodiscard]] tl::expected<nats::Subscription, std::string> subscribe(std::uint64_t id,
                                                                        const std::string& subject);
  /// Ends @p subscription: what is on its way to it still arrives, and after that nothing once (a null message).
  /// False if that cannot be waited for.
  [[nodiscard]] static bool drain(const nats::Subscription& subscription) noexcept {
    return natsSubscription_Drain(subscription.get()) == NATS_OK;
  }
  /// Hands @p data over to be written; false if @p most bytes would wait, or the server takes no such message.
  [[nodiscard]] bool publish(const std::string& subject, const std::string& reply, std::string_view data,
                             std::size_t most);
  /// What waits to be written will not be.
  void drop_unsent() const noexcept { polled_->drop_unsent(); }

 private:
  explicit Contact(std::unique_ptr<nats::PolledConnection> polled) : polled_{std::move(polled)} {}
  [[nodiscard]] natsConnection* connection() const noexcept { return polled_->connection.get(); }

  std::unique_ptr<nats::PolledConnection> polled_;
  std::shared_ptr<Arrivals> arrivals_ = std::make_shared<Arrivals>();
};

}  // namespace farm
