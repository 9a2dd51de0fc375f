#include "can/nats/nats_stream.hpp"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <utility>

#include <sys/epoll.h>

#include "can/nats/delivery.hpp"

namespace nats {

namespace {

enum Ready : std::uint64_t { kConnector, kSocket };

}  // namespace

NatsStream::NatsStream(Bus bus)
    : bus_{std::move(bus)}, connector_{[this](std::chrono::milliseconds patience) {
        return join(bus_, patience);
      }} {
  if (!ready_.add(connector_.descriptor(), EPOLLIN, kConnector))
    throw std::system_error{errno, std::generic_category(), bus_.server.url};
}

NatsStream::State NatsStream::advance() noexcept {
  while (const auto ready = ready_.take()) {
    if (ready->name == kConnector) {
      accept();
    } else {
      serve_socket();
      break;  // messages first
    }
  }
  if (!member_) return State::Opening;
  return natsConnection_IsClosed(connection()) ? State::Lost : State::Open;
}

void NatsStream::accept() noexcept {
  auto made = connector_.take();
  if (!made) return;
  member_ = std::move(made);
  is_written_later_ = false;
  if (!ready_.add(member_->polled->socket, EPOLLIN, kSocket)) natsConnection_Close(connection());
}

void NatsStream::serve_socket() noexcept {
  if (!member_) return;
  natsConnection_ProcessReadEvent(connection());
  if (member_->polled->wants_to_write) write();
}

bool NatsStream::receive(Message& message) noexcept {
  for (;;) {
    message_.reset();
    natsMsg* next = nullptr;
    if (!member_ || natsSubscription_NextMsg(&next, member_->subscription.get(), 0) != NATS_OK) return false;
    message_.reset(next);
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
  write();
}

void NatsStream::write() noexcept {
  const PolledConnection& polled = *member_->polled;
  natsConnection_ProcessWriteEvent(connection());
  if (std::exchange(is_written_later_, polled.wants_to_write) == polled.wants_to_write) return;
  const unsigned wanted = is_written_later_ ? EPOLLIN | EPOLLOUT : EPOLLIN;
  if (!ready_.change(polled.socket, wanted, kSocket)) natsConnection_Close(connection());
}

void NatsStream::reopen() noexcept {
  message_.reset();
  if (member_) ready_.remove(member_->polled->socket);
  connector_.again(std::move(member_));
}

std::string NatsStream::take_problem() {
  return connector_.take_problem();
}

}  // namespace nats
