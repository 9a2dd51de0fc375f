#include "tools/canrec/server/messages.hpp"

#include <span>
#include <string_view>

#include <fmt/format.h>

#include "can/nats/delivery.hpp"
#include "can/nats/message.hpp"
#include "text/number.hpp"
#include "tools/canrec/server/stream_info.hpp"

namespace canrec {

namespace {

/// A consumer that nobody asks is removed by the server; after a pause that is longer there is a new one.
constexpr std::chrono::nanoseconds kInactive = std::chrono::minutes{5};

}  // namespace

Expected<Messages> Messages::open(Store& store, const Recording& recording) {
  auto inbox = Inbox::open(store);
  if (!inbox) return tl::unexpected{inbox.error()};
  return Messages{store, recording, *std::move(inbox)};
}

Expected<void> Messages::consume() {
  jsConsumerConfig config;
  jsConsumerConfig_Init(&config);
  config.DeliverPolicy = js_DeliverByStartSequence;
  config.OptStartSeq = next_;
  config.AckPolicy = js_AckNone;
  config.MemoryStorage = true;
  config.Replicas = 1;
  config.InactiveThreshold = kInactive.count();
  jsConsumerInfo* info = nullptr;
  jsErrCode code{};
  const natsStatus status = js_AddConsumer(&info, store_->session().js.get(), Recording::stream_of(name_).c_str(),
                                           &config, nullptr, &code);
  const nats::ConsumerInfo owned{info};
  if (status == NATS_NOT_FOUND) return fail(Status::NotThere, fmt::format("the recording {} was removed", name_));
  if (status != NATS_OK) return tl::unexpected{store_->failure_of(status, code, name_)};
  consumer_ = info->Name;
  return {};
}

Expected<void> Messages::ask() {
  if (consumer_.empty())
    if (auto done = consume(); !done) return done;
  const std::string subject =
      fmt::format("$JS.API.CONSUMER.MSG.NEXT.{}.{}", Recording::stream_of(name_), consumer_);
  const std::string request = fmt::format(R"({{"batch":{},"no_wait":true}})", kBatch);
  const natsStatus status = natsConnection_PublishRequestString(
      store_->session().connection.get(), subject.c_str(), inbox_.subject().c_str(), request.c_str());
  if (status != NATS_OK) return tl::unexpected{store_->failure_of(status, {}, name_)};
  coming_ = kBatch;
  return {};
}

/// Empty: it has none of that name.
Expected<std::string_view> Messages::header(natsMsg* message, const char* name) const {
  const auto value = nats::header_of(message, name);
  if (!value) return tl::unexpected{store_->failure_of(value.error(), {}, name_)};
  return *value != nullptr ? *value : "";
}

/// What has come, if it is a message of the recording that was not here before.
Expected<std::optional<Message>> Messages::taken(natsMsg* message) {
  const char* const reply = natsMsg_GetReply(message);
  const auto delivery = reply == nullptr ? std::nullopt : nats::parse_delivery(reply);
  if (!delivery) return std::nullopt;
  --coming_;
  if (delivery->sequence < next_) return std::nullopt;
  next_ = delivery->pending == 0 ? last_ + 1 : delivery->sequence + 1;
  Message taken;
  taken.bytes = std::as_bytes(std::span{nats::data_of(message)});
  taken.sequence = delivery->sequence;
  taken.at = std::chrono::nanoseconds{delivery->time_ns};
  const auto log_time = header(message, kLogTimeHeader);
  if (!log_time) return tl::unexpected{log_time.error()};
  if (const auto time = text::integer<std::int64_t>(*log_time)) taken.log_time = std::chrono::nanoseconds{*time};
  return taken;
}

/// Takes what says how the request went.
Expected<void> Messages::take_status(natsMsg* message) {
  constexpr std::string_view kNothingMore = "404";
  const auto status = header(message, "Status");
  if (!status) return tl::unexpected{status.error()};
  if (natsMsg_IsNoResponders(message)) {  // the consumer has gone
    consumer_.clear();
    return ask();
  }
  if (*status == kNothingMore) next_ = last_ + 1;
  if (status->empty() || *status == kNothingMore) return {};
  const auto why = header(message, "Description");
  return fail(Status::NoServer, fmt::format("{}: {} {}", name_, *status, why.value_or("")));
}

Expected<std::optional<Message>> Messages::next() {
  while (next_ <= last_) {
    if (coming_ == 0)
      if (auto done = ask(); !done) return tl::unexpected{done.error()};
    const auto received = inbox_.receive();
    if (!received) return tl::unexpected{received.error()};
    if (auto message = taken(*received); !message || *message) return message;
    if (auto done = take_status(*received); !done) return tl::unexpected{done.error()};
  }
  return std::nullopt;
}

}  // namespace canrec
