#include "farm/link/contact.hpp"

#include <limits>
#include <utility>

namespace farm {

namespace {

/// What a thread of the library needs to hand messages of one subscription over; the library has it until it has
/// handed over the last one.
struct Channel {
  std::shared_ptr<Arrivals> arrivals;
  std::uint64_t id;
};

void on_message(natsConnection*, natsSubscription*, natsMsg* message, void* channel) noexcept {
  const auto& [arrivals, id] = *static_cast<Channel*>(channel);
  arrivals->put(id, nats::Message{message});
}

void on_complete(void* given) noexcept {
  const std::unique_ptr<const Channel> channel{static_cast<Channel*>(given)};
  channel->arrivals->put(channel->id, nullptr);
}

/// Messages and bytes that may wait in a subscription: losing one in silence is worse than any memory.
constexpr int kNoLimit = std::numeric_limits<int>::max();

}  // namespace

tl::expected<std::unique_ptr<Contact>, std::string> Contact::make(const nats::Server& server,
                                                                  const std::string& client,
                                                                  std::chrono::milliseconds patience) {
  auto polled = nats::connect_polled(server, client, patience);
  if (!polled) return tl::unexpected{polled.error()};
  return std::unique_ptr<Contact>{new Contact{*std::move(polled)}};
}

void Contact::read() noexcept {
  natsConnection_ProcessReadEvent(connection());
}

void Contact::write() noexcept {
  natsConnection_ProcessWriteEvent(connection());
}

std::string Contact::complaint() const {
  const char* text = nullptr;
  natsConnection_GetLastError(connection(), &text);
  return text != nullptr ? text : "";
}

std::string Contact::why_closed() const {
  if (!natsConnection_IsClosed(connection())) return {};
  const std::string text = complaint();
  return text.empty() ? "the server has closed the connection" : text;
}

tl::expected<nats::Subscription, std::string> Contact::subscribe(std::uint64_t id, const std::string& subject) {
  auto channel = std::make_unique<Channel>(Channel{arrivals_, id});
  natsSubscription* made = nullptr;
  const natsStatus status =
      natsConnection_Subscribe(&made, connection(), subject.c_str(), on_message, channel.get());
  if (status != NATS_OK) return tl::unexpected{nats::text_of(status)};
  natsSubscription_SetOnCompleteCB(made, on_complete, channel.release());
  natsSubscription_SetPendingLimits(made, kNoLimit, kNoLimit);
  return nats::Subscription{made};
}

bool Contact::publish(const std::string& subject, const std::string& reply, std::string_view data,
                      std::size_t most) {
  const int waiting = natsConnection_Buffered(connection());
  if (waiting < 0 || static_cast<std::size_t>(waiting) + data.size() > most) return false;
  const auto size = static_cast<int>(data.size());
  if (reply.empty()) return natsConnection_Publish(connection(), subject.c_str(), data.data(), size) == NATS_OK;
  return natsConnection_PublishRequest(connection(), subject.c_str(), reply.c_str(), data.data(), size) == NATS_OK;
}

}  // namespace farm
