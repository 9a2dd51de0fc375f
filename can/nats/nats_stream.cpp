#include "can/nats/nats_stream.hpp"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include <sys/epoll.h>

#include "can/nats/delivery.hpp"
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

}  // namespace

NatsStream::NatsStream(Bus bus)
    : bus_{std::move(bus)}, connector_{[this](std::chrono::milliseconds) {
        return reach(bus_.host, bus_.port, kReach).and_then([this] { return join(bus_, kAnswer); });
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
  for (;;) {
    if (received_.size() == kAtOnce) received_.clear();
    natsMsg* next = nullptr;
    if (!member_ || natsSubscription_NextMsg(&next, member_->subscription.get(), 0) != NATS_OK) return false;
    received_.emplace_back(next);
    const char* const reply = natsMsg_GetReply(next);
    const auto place = parse_delivery(reply != nullptr ? reply : "");
    if (!place) continue;  // of the server to its client, not of the stream
    message.sequence = place->sequence;
    message.time_ns = place->time_ns;
    message.bytes =
        std::as_bytes(std::span{natsMsg_GetData(next), static_cast<std::size_t>(natsMsg_GetDataLength(next))});
    return true;
  }
}

void NatsStream::publish(std::span<const std::byte> bytes) noexcept {
  if (!member_) return;
  natsConnection_Publish(connection(), bus_.subject().c_str(), bytes.data(), static_cast<int>(bytes.size()));
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
