#include "tools/canrec/server/log_upload.hpp"

#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "can/nats/message.hpp"
#include "can/port/port.hpp"
#include "tools/canrec/server/stream_info.hpp"

namespace canrec {

namespace {

/// Number of the hub that has sent the frames.
constexpr std::uint32_t kHub = 1;
/// Messages that the server need not have confirmed.
constexpr int kMostPending = 4096;

/// Why the server has not taken a message, by its answer; empty if it has.
std::string refusal_in(std::string_view answer) {
  if (answer.find("\"error\"") == std::string_view::npos) return {};
  const nlohmann::json whole = nlohmann::json::parse(answer, nullptr, false);
  const nlohmann::json::json_pointer place{"/error/description"};
  if (!whole.is_object() || !whole.contains(place) || !whole.at(place).is_string()) return std::string{answer};
  return whole.at(place).get<std::string>();
}

}  // namespace

Expected<LogUpload> LogUpload::open(Store& store, const std::string& name) {
  auto inbox = Inbox::open(store);
  if (!inbox) return tl::unexpected{inbox.error()};
  return LogUpload{store, name, *std::move(inbox)};
}

Expected<void> LogUpload::add(const TimedFrame& frame) {
  const bool fits = writer_.frames() > 0 && writer_.frames() < hub::trunk::kMostFrames && at_ == frame.at;
  if (!fits) {
    if (auto done = send(); !done) return done;
    at_ = frame.at;
    writer_.begin(
        {.kind = hub::trunk::Kind::Frames, .hub = kHub, .epoch = 1, .origin = kHub, .counter = counter_});
  }
  writer_.add({frame.frame, static_cast<std::uint32_t>(counter_ & bus::Mark::kLargestNumber)});
  ++counter_;
  return {};
}

Expected<void> LogUpload::send() {
  if (writer_.frames() == 0) return {};
  const auto bytes = writer_.finish();
  natsMsg* message = nullptr;
  natsStatus status = natsMsg_Create(&message, Store::log_subject(name_).c_str(), inbox_.subject().c_str(),
                                     reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size()));
  const nats::Message owned{message};
  if (status == NATS_OK)
    status = natsMsgHeader_Set(message, kLogTimeHeader, fmt::format("{}", at_.count()).c_str());
  if (status == NATS_OK) status = natsConnection_PublishMsg(store_->session().connection.get(), message);
  if (status != NATS_OK) return tl::unexpected{store_->failure_of(status, {}, name_)};
  for (++pending_; pending_ > kMostPending;)
    if (auto done = confirm(); !done) return done;
  return {};
}

/// Waits for an answer of the server.
Expected<void> LogUpload::confirm() {
  const auto answer = inbox_.receive();
  if (!answer) return tl::unexpected{answer.error()};
  --pending_;
  const std::string refusal = refusal_in(nats::data_of(*answer));
  if (refusal.empty()) return {};
  return fail(Status::NoServer, fmt::format("{}: the server takes no more: {}", name_, refusal));
}

Expected<void> LogUpload::finish() {
  if (auto done = send(); !done) return done;
  writer_.begin({});
  while (pending_ > 0)
    if (auto done = confirm(); !done) return done;
  return {};
}

}  // namespace canrec
