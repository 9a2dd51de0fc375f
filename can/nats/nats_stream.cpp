#include "can/nats/nats_stream.hpp"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include <sys/epoll.h>

#include "can/nats/delivery.hpp"
#include "can/nats/message.hpp"
#include "can/nats/reach.hpp"

namespace nats {

namespace {

/// For a server to be reached: one that is further away could not keep a bus together.
constexpr std::chrono::milliseconds kReach{300};
/// For each answer of a server that was: one that stands still gives it when it goes on.
constexpr std::chrono::milliseconds kAnswer{2000};

/// Messages that are destroyed together: the library leaves that to a thread, which the first of them wakes.
constexpr std::size_t kAtOnce = 256;

/// What is heard of the connector while there is a connection.
constexpr unsigned kNothing = 0;

std::span<const std::byte> bytes_of(natsMsg* message) noexcept {
  return std::as_bytes(std::span{data_of(message)});
}

}  // namespace

NatsStream::NatsStream(Bus bus)
    : bus_{std::move(bus)}, connector_{[this](std::chrono::milliseconds) -> Connector<Membership>::Result {
        if (auto reached = reach(bus_.host, bus_.port, kReach); !reached) return tl::unexpected{reached.error()};
        return join(bus_, kAnswer);
      }} {
  if (!ready_.add(connector_.descriptor(), EPOLLIN))
    throw std::system_error{errno, std::generic_category(), bus_.server.url};
  received_.reserve(kAtOnce);
}

NatsStream::State NatsStream::advance() noexcept {
  if (!member_) accept();
  if (!member_) return State::Opening;
  if (may_read()) natsConnection_ProcessReadEvent(connection());
  if (member_->polled->wants_to_write) flush();
  return natsConnection_IsClosed(connection()) ? State::Lost : State::Open;
}

bool NatsStream::may_read() noexcept {
  if (!bus_.server.has_tls()) return true;
  const auto ready = ready_.take();
  return records_.is_whole(member_->polled->socket, ready ? ready->events : kNothing);
}

/// The socket stands alone in what is polled then: whatever makes that ready is on the socket, and it need not be
/// asked.
void NatsStream::accept() noexcept {
  member_ = connector_.take();
  if (!member_) return;
  is_written_later_ = false;
  records_ = {};
  if (!ready_.add(member_->polled->socket, EPOLLIN | EPOLLRDHUP) ||
      !ready_.change(connector_.descriptor(), kNothing))
    natsConnection_Close(connection());
}

bool NatsStream::receive(Message& message) noexcept {
  while (member_) {
    natsMsg* const next = next_of(member_->subscription);
    if (next == nullptr) return false;
    const char* const reply = natsMsg_GetReply(next);
    const auto place = parse_delivery(reply != nullptr ? reply : "");
    if (!place) continue;  // of the server to its client, not of the stream
    message.sequence = place->sequence;
    message.time_ns = place->time_ns;
    message.bytes = bytes_of(next);
    return true;
  }
  return false;
}

natsMsg* NatsStream::next_of(const Subscription& subscription) noexcept {
  if (received_.size() == kAtOnce) received_.clear();
  natsMsg* next = nullptr;
  if (!subscription || natsSubscription_NextMsg(&next, subscription.get(), 0) != NATS_OK) return nullptr;
  received_.emplace_back(next);
  return next;
}

void NatsStream::publish(std::span<const std::byte> bytes) noexcept {
  publish(bus_.subject(), bytes);
}

void NatsStream::ask(std::span<const std::byte> bytes) noexcept {
  publish(bus_.requests(), bytes);
}

void NatsStream::publish(const std::string& subject, std::span<const std::byte> bytes) noexcept {
  if (!member_) return;
  natsConnection_Publish(connection(), subject.c_str(), bytes.data(), static_cast<int>(bytes.size()));
}

/// Without a subscription requests are lost, and who asks is told by nobody: so the connection is given up then.
void NatsStream::listen(bool on) noexcept {
  if (!member_) return;
  natsSubscription* subscription = nullptr;
  natsStatus status = NATS_OK;
  if (on) status = natsConnection_SubscribeSync(&subscription, connection(), bus_.requests().c_str());
  member_->requests.reset(subscription);
  if (subscription != nullptr) status = natsSubscription_SetPendingLimits(subscription, kNoLimit, kNoLimit);
  if (status != NATS_OK) natsConnection_Close(connection());
}

bool NatsStream::receive_request(Message& message) noexcept {
  natsMsg* const next = member_ ? next_of(member_->requests) : nullptr;
  if (next == nullptr) return false;
  message = {.bytes = bytes_of(next)};
  return true;
}

void NatsStream::flush() noexcept {
  if (!member_) return;
  const PolledConnection& polled = *member_->polled;
  natsConnection_ProcessWriteEvent(connection());
  if (std::exchange(is_written_later_, polled.wants_to_write) == polled.wants_to_write) return;
  const unsigned wanted = EPOLLIN | EPOLLRDHUP | (is_written_later_ ? EPOLLOUT : 0U);
  if (!ready_.change(polled.socket, wanted)) natsConnection_Close(connection());
}

void NatsStream::reopen() noexcept {
  received_.clear();
  if (member_) ready_.remove(member_->polled->socket);
  [[maybe_unused]] const bool is_heard = ready_.change(connector_.descriptor(), EPOLLIN);
  connector_.again(std::move(member_));
}

std::string NatsStream::take_problem() {
  return connector_.take_problem();
}

}  // namespace nats
