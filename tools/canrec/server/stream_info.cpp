#include "tools/canrec/server/stream_info.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

#include "can/nats/message.hpp"
#include "text/number.hpp"

namespace canrec {

namespace {

constexpr std::string_view kBusPrefix = "CAN_";
constexpr std::string_view kLogDescription = "log of ";

std::string without(std::string_view prefix, const char* text) {
  std::string_view whole = text == nullptr ? "" : text;
  if (whole.starts_with(prefix)) whole.remove_prefix(prefix.size());
  return std::string{whole};
}

std::string_view name_of(const jsStreamInfo& info) noexcept {
  return info.Config->Name;
}

/// Of the message @p sequence of @p recording.
std::chrono::nanoseconds log_time(const nats::Session& session, const Recording& recording, std::uint64_t sequence,
                                  std::chrono::nanoseconds otherwise) {
  natsMsg* message = nullptr;
  jsErrCode code{};
  const natsStatus status = js_GetMsg(&message, session.js.get(), Recording::stream_of(recording.name).c_str(),
                                      sequence, nullptr, &code);
  const nats::Message owned{message};
  const char* const value =
      status == NATS_OK ? nats::header_of(message, kLogTimeHeader).value_or(nullptr) : nullptr;
  if (value == nullptr) return otherwise;
  const auto time = text::integer<std::int64_t>(value);
  return time ? std::chrono::nanoseconds{*time} : otherwise;
}

}  // namespace

Recording recording_of(const jsStreamInfo& info) {
  const jsStreamConfig& config = *info.Config;
  Recording recording;
  recording.name = without(kStreamPrefix, config.Name);
  recording.is_of_log = config.Mirror == nullptr;
  recording.bus = recording.is_of_log ? without(kLogDescription, config.Description)
                                      : without(kBusPrefix, config.Mirror->Name);
  if (recording.is_of_log || config.MaxMsgSize == kStoppedMessageSize) recording.state = Recording::State::Stopped;
  recording.messages = info.State.Msgs;
  recording.bytes = info.State.Bytes;
  recording.first = info.State.FirstSeq;
  recording.last = info.State.LastSeq;
  recording.from = std::chrono::nanoseconds{info.State.FirstTime};
  recording.to = std::chrono::nanoseconds{info.State.LastTime};
  return recording;
}

std::vector<Recording> recordings_of(const jsStreamInfoList& list) {
  const std::span all{list.List, static_cast<std::size_t>(list.Count)};
  std::vector<Recording> recordings;
  for (const jsStreamInfo* const info : all) {
    if (!name_of(*info).starts_with(kStreamPrefix)) continue;
    Recording recording = recording_of(*info);
    const std::string bus = std::string{kBusPrefix} + recording.bus;
    const auto followed = std::ranges::find(all, bus, [](const jsStreamInfo* each) { return name_of(*each); });
    const bool is_gone = followed == all.end() || (*followed)->State.LastSeq < recording.last;
    if (recording.state == Recording::State::Running && is_gone) recording.state = Recording::State::Stuck;
    recordings.push_back(std::move(recording));
  }
  return recordings;
}

bool is_following(const jsStreamInfo& info) noexcept {
  return info.Mirror != nullptr && info.Mirror->Active >= 0;
}

std::string description_of_log(const std::string& interface) {
  return std::string{kLogDescription} + interface;
}

void read_log_times(const nats::Session& session, Recording& recording) {
  if (recording.messages == 0) return;
  recording.from = log_time(session, recording, recording.first, recording.from);
  recording.to = log_time(session, recording, recording.last, recording.to);
}

}  // namespace canrec
