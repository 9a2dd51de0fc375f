#include "can/nats/join.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace nats {

namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr const char* kClient = "canhub";
/// Messages older than this are forgotten: nobody asks for them, recordings have streams of their own.
constexpr nanoseconds kAge = std::chrono::seconds{30};
/// Messages that are looked through for one that comes twice: none does, and less is not allowed.
constexpr nanoseconds kDuplicates = milliseconds{100};
/// A consumer that nobody listens to is removed by the server.
constexpr nanoseconds kInactive = std::chrono::seconds{5};

std::string with_code(natsStatus status, jsErrCode code) {
  return code == 0 ? text_of(status)
                   : fmt::format("{} (JetStream error {})", text_of(status), static_cast<int>(code));
}

/// A stream of that name that was there already may be another one.
tl::expected<void, std::string> check_stream(const jsStreamInfo& stream, const std::string& subject) {
  const jsStreamConfig& config = *stream.Config;
  const std::span subjects{config.Subjects, static_cast<std::size_t>(config.SubjectsLen)};
  if (std::ranges::find(subjects, subject, [](const char* each) { return std::string_view{each}; }) !=
      subjects.end())
    return {};
  return tl::unexpected{fmt::format("stream {} is there and is no bus: expected the subject {}, found {}",
                                    config.Name, subject, fmt::join(subjects, ", "))};
}

/// Two hubs that make the stream at the same moment collide in the server: the second attempt finds it.
tl::expected<void, std::string> make_stream(jsCtx* js, const Bus& bus) {
  const std::string name = bus.stream();
  const std::string subject = bus.subject();
  const char* subjects[] = {subject.c_str()};
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  config.Name = name.c_str();
  config.Subjects = subjects;
  config.SubjectsLen = 1;
  config.Storage = js_FileStorage;
  config.MaxAge = kAge.count();
  config.Duplicates = kDuplicates.count();
  config.NoAck = true;
  natsStatus status = NATS_OK;
  jsErrCode code{};
  for (int attempt = 0; attempt < 2; ++attempt) {
    jsStreamInfo* info = nullptr;
    status = js_GetStreamInfo(&info, js, name.c_str(), nullptr, &code);
    if (status == NATS_NOT_FOUND) status = js_AddStream(&info, js, &config, nullptr, &code);
    const StreamInfo made{info};
    if (status == NATS_OK) return check_stream(*info, subject);
  }
  return tl::unexpected{fmt::format("stream {}: {}", name, with_code(status, code))};
}

tl::expected<void, std::string> make_consumer(jsCtx* js, const Bus& bus, const std::string& inbox) {
  jsConsumerConfig config;
  jsConsumerConfig_Init(&config);
  config.DeliverSubject = inbox.c_str();
  config.DeliverPolicy = js_DeliverNew;
  config.AckPolicy = js_AckNone;
  config.MemoryStorage = true;
  config.Replicas = 1;
  config.InactiveThreshold = kInactive.count();
  jsConsumerInfo* info = nullptr;
  jsErrCode code{};
  const natsStatus status = js_AddConsumer(&info, js, bus.stream().c_str(), &config, nullptr, &code);
  const ConsumerInfo made{info};
  if (status != NATS_OK)
    return tl::unexpected{fmt::format("consumer of stream {}: {}", bus.stream(), with_code(status, code))};
  return {};
}

/// Stream and consumer are made over a connection of the library's own threads, which ends with it.
tl::expected<void, std::string> set_up(const Bus& bus, const std::string& inbox, milliseconds patience) {
  auto options = options_for(bus.server, kClient, patience);
  if (!options) return tl::unexpected{options.error()};
  const auto connection = connect(*options);
  if (!connection) return tl::unexpected{connection.error()};
  jsOptions js_options;
  jsOptions_Init(&js_options);
  js_options.Wait = patience.count();
  jsCtx* made = nullptr;
  if (const natsStatus status = natsConnection_JetStream(&made, connection->get(), &js_options); status != NATS_OK)
    return tl::unexpected{text_of(status)};
  const JetStream js{made};
  return make_stream(made, bus).and_then([&] { return make_consumer(made, bus, inbox); });
}

}  // namespace

tl::expected<std::unique_ptr<Membership>, std::string> join(const Bus& bus, milliseconds patience) {
  auto member = std::make_unique<Membership>();
  auto polled = connect_polled(bus.server, kClient, patience);
  if (!polled) return tl::unexpected{polled.error()};
  member->polled = *std::move(polled);
  natsConnection* const connection = member->polled->connection.get();
  natsInbox* inbox = nullptr;
  natsSubscription* subscription = nullptr;
  natsStatus status = natsInbox_Create(&inbox);
  const std::unique_ptr<natsInbox, Destroyer<natsInbox_Destroy>> subject{inbox};
  if (status == NATS_OK) status = natsConnection_SubscribeSync(&subscription, connection, inbox);
  member->subscription.reset(subscription);
  if (status == NATS_OK) status = natsSubscription_SetPendingLimits(subscription, kNoLimit, kNoLimit);
  if (status != NATS_OK) return tl::unexpected{text_of(status)};
  natsConnection_ProcessWriteEvent(connection);
  if (auto done = set_up(bus, inbox, patience); !done) return tl::unexpected{done.error()};
  return member;
}

}  // namespace nats
