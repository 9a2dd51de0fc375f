#include "tools/canrec/server/store.hpp"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "can/nats/bus.hpp"
#include "tools/canrec/server/stream_info.hpp"

namespace canrec {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr const char* kClient = "canrec";
/// Between two questions to the server.
constexpr milliseconds kPause{20};
/// A server passes over all messages that the bus has ever had before a recording begins (0.15 s a million).
constexpr std::chrono::seconds kLongestBegin{30};

std::string silence() {
  return fmt::format("no answer within {} s", Store::kPatience.count());
}

std::string stream_of_bus(const std::string& bus) {
  nats::Bus named;
  named.name = bus;
  return named.stream();
}

}  // namespace

Expected<Store> Store::open(const nats::Server& server) {
  auto session = nats::open_session(server, kClient, kPatience);
  if (session) return Store{*std::move(session), server.url};
  const bool is_silent = session.error() == natsStatus_GetText(NATS_TIMEOUT);
  return fail(Status::NoServer, fmt::format("{}: {}", server.url, is_silent ? silence() : session.error()));
}

Failure Store::failure_of(natsStatus status, jsErrCode code, std::string_view what) const {
  const auto failed = [this](std::string_view text) {
    return Failure{Status::NoServer, fmt::format("{}: {}", url_, text)};
  };
  if (status == NATS_TIMEOUT) return failed(silence());
  if (status == NATS_NO_RESPONDERS || code == JSNotEnabledErr || code == JSNotEnabledForAccountErr)
    return failed("the server has no JetStream");
  if (code == JSStorageResourcesExceededErr)
    return failed(fmt::format("the server has no room for {}: --max-bytes asks for less", what));
  const std::string text = nats::text_of(status);
  if (what.empty()) return failed(text);
  const std::string number = code == 0 ? "" : fmt::format(" (JetStream error {})", static_cast<int>(code));
  return failed(fmt::format("{}: {}{}", what, text, number));
}

Expected<nats::StreamInfo> Store::info_of(const std::string& name) {
  jsStreamInfo* info = nullptr;
  jsErrCode code{};
  const natsStatus status =
      js_GetStreamInfo(&info, session_.js.get(), Recording::stream_of(name).c_str(), nullptr, &code);
  nats::StreamInfo owned{info};
  if (status == NATS_NOT_FOUND)
    return fail(Status::NotThere, fmt::format("{}: there is no recording {}", url_, name));
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, name)};
  return owned;
}

Expected<std::uint64_t> Store::end_of_bus(const std::string& bus) {
  jsStreamInfo* info = nullptr;
  jsErrCode code{};
  const natsStatus status = js_GetStreamInfo(&info, session_.js.get(), stream_of_bus(bus).c_str(), nullptr, &code);
  const nats::StreamInfo owned{info};
  if (status == NATS_NOT_FOUND)
    return fail(Status::NotThere, fmt::format("{}: there is no bus {}, no hub has joined it", url_, bus));
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, bus)};
  return info->State.LastSeq;
}

/// Makes the stream of @p config, which is complete but for its name.
Expected<void> Store::make(jsStreamConfig& config, const std::string& name) {
  const auto there = info_of(name);
  if (there) return fail(Status::NotThere, fmt::format("{}: there is a recording {} already", url_, name));
  if (there.error().status != Status::NotThere) return tl::unexpected{there.error()};
  const std::string stream = Recording::stream_of(name);
  config.Name = stream.c_str();
  config.Storage = js_FileStorage;
  jsErrCode code{};
  const natsStatus status = js_AddStream(nullptr, session_.js.get(), &config, nullptr, &code);
  if (code == JSStreamNameExistErr)
    return fail(Status::NotThere, fmt::format("{}: there is a recording {} already", url_, name));
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, name)};
  return {};
}

/// A mirror and no source: a stream with sources gives messages time stamps of its own, which lag.
Expected<void> Store::begin(const std::string& bus, const std::string& name, const Limits& limits) {
  const auto last = end_of_bus(bus);
  if (!last) return tl::unexpected{last.error()};
  const std::string stream = stream_of_bus(bus);
  jsStreamSource mirror;
  jsStreamSource_Init(&mirror);
  mirror.Name = stream.c_str();
  mirror.OptStartSeq = *last + 1;
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  config.Mirror = &mirror;
  config.MaxAge = limits.age.count();
  if (limits.bytes > 0) config.MaxBytes = limits.bytes;
  return make(config, name);
}

Expected<bool> Store::await(const std::string& name) {
  const auto end = steady_clock::now() + kLongestBegin;
  while (steady_clock::now() < end) {
    const auto info = info_of(name);
    if (!info && info.error().status == Status::NotThere) return tl::unexpected{info.error()};
    if (info && is_following(**info)) return true;
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

Expected<void> Store::catch_up(const std::string& name, const std::string& bus) {
  const auto last = end_of_bus(bus);
  if (!last) return {};  // nothing comes of it
  const auto end = steady_clock::now() + kPatience;
  for (;;) {
    const auto info = info_of(name);
    if (!info) return tl::unexpected{info.error()};
    if ((*info)->State.LastSeq >= *last || steady_clock::now() > end) return {};
    std::this_thread::sleep_for(kPause);
  }
}

/// A mirror can be made to follow no longer in one way only: no message is small enough for it.
Expected<Recording> Store::stop(const std::string& name) {
  auto found = find(name);
  if (!found || found->state == Recording::State::Stopped) return found;
  if (auto done = catch_up(name, found->bus); !done) return tl::unexpected{done.error()};
  const auto info = info_of(name);
  if (!info) return tl::unexpected{info.error()};
  jsStreamConfig config = *(*info)->Config;
  config.MaxMsgSize = kStoppedMessageSize;
  config.MaxAge = 0;
  jsErrCode code{};
  const natsStatus status = js_UpdateStream(nullptr, session_.js.get(), &config, nullptr, &code);
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, name)};
  return find(name);
}

Expected<void> Store::remove(const std::string& name) {
  jsErrCode code{};
  const natsStatus status = js_DeleteStream(session_.js.get(), Recording::stream_of(name).c_str(), nullptr, &code);
  if (status == NATS_NOT_FOUND)
    return fail(Status::NotThere, fmt::format("{}: there is no recording {}", url_, name));
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, name)};
  return {};
}

Expected<Recording> Store::find(const std::string& name) {
  const auto info = info_of(name);
  if (!info) return tl::unexpected{info.error()};
  Recording recording = recording_of(**info);
  if (recording.is_of_log) read_log_times(session_, recording);
  return recording;
}

Expected<std::vector<Recording>> Store::all() {
  jsStreamInfoList* list = nullptr;
  jsErrCode code{};
  const natsStatus status = js_Streams(&list, session_.js.get(), nullptr, &code);
  const StreamInfoList owned{list};
  if (status == NATS_NOT_FOUND) return std::vector<Recording>{};
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, "list of streams")};
  std::vector<Recording> recordings = recordings_of(*list);
  for (Recording& recording : recordings)
    if (recording.is_of_log) read_log_times(session_, recording);
  std::ranges::sort(recordings, {}, &Recording::name);
  return recordings;
}

Expected<void> Store::begin_log(const std::string& name, const std::string& interface) {
  const std::string subject = log_subject(name);
  const char* subjects[] = {subject.c_str()};
  const std::string description = description_of_log(interface);
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  config.Subjects = subjects;
  config.SubjectsLen = 1;
  config.Description = description.c_str();
  return make(config, name);
}

Expected<void> Store::seal(const std::string& name) {
  const auto info = info_of(name);
  if (!info) return tl::unexpected{info.error()};
  jsStreamConfig config = *(*info)->Config;
  config.Sealed = true;
  jsErrCode code{};
  const natsStatus status = js_UpdateStream(nullptr, session_.js.get(), &config, nullptr, &code);
  if (status != NATS_OK) return tl::unexpected{failure_of(status, code, name)};
  return {};
}

}  // namespace canrec
