#include "farm/storage/nats_object_store.hpp"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "can/nats/inbox.hpp"
#include "can/nats/message.hpp"
#include "farm/storage/digest.hpp"
#include "farm/storage/storage_error.hpp"

namespace farm {

namespace {

constexpr std::int64_t kChunkWait = 2000;  // ms

std::string stream_of(const std::string& bucket) {
  return "OBJ_" + bucket;
}

natsStatus make_stream(jsCtx* js, const std::string& bucket) {
  const std::string name = stream_of(bucket);
  const std::string chunks = fmt::format("$O.{}.C.>", bucket);
  const std::string metas = fmt::format("$O.{}.M.>", bucket);
  const char* subjects[] = {chunks.c_str(), metas.c_str()};
  jsStreamConfig config;
  jsStreamConfig_Init(&config);
  config.Name = name.c_str();
  config.Subjects = subjects;
  config.SubjectsLen = std::size(subjects);
  config.Storage = js_FileStorage;
  config.Discard = js_DiscardNew;
  config.AllowRollup = true;
  config.AllowDirect = true;
  jsStreamInfo* info = nullptr;
  natsStatus status = js_GetStreamInfo(&info, js, name.c_str(), nullptr, nullptr);
  if (status == NATS_NOT_FOUND) status = js_AddStream(&info, js, &config, nullptr, nullptr);
  if (status != NATS_OK)
    status = js_GetStreamInfo(&info, js, name.c_str(), nullptr, nullptr);  // another was faster
  const nats::StreamInfo made{info};
  return status;
}

bool is_whole(const ObjectMeta& meta, std::string_view content) {
  return content.size() == meta.size && digest_of(content) == meta.digest;
}

}  // namespace

tl::expected<void, std::string> NatsObjectStore::open(const std::string& bucket) {
  if (buckets_.contains(bucket)) return {};
  if (const natsStatus status = make_stream(js_, bucket); status != NATS_OK) return fail(bucket, status);
  buckets_.insert(bucket);
  return {};
}

/// A bucket that was removed by somebody is made again the next time.
tl::unexpected<std::string> NatsObjectStore::fail(const std::string& bucket, natsStatus status) {
  buckets_.erase(bucket);
  has_failed_ = true;
  return tl::unexpected{storage_error(bucket, status)};
}

tl::expected<std::optional<ObjectMeta>, std::string> NatsObjectStore::meta_of(const std::string& bucket,
                                                                              const std::string& name) {
  natsMsg* made = nullptr;
  jsErrCode code{};
  const natsStatus status =
      js_GetLastMsg(&made, js_, stream_of(bucket).c_str(), meta_subject(bucket, name).c_str(), nullptr, &code);
  const nats::Message message{made};
  if (status == NATS_NOT_FOUND) return std::nullopt;
  if (status != NATS_OK) return fail(bucket, status);
  auto meta = parse_object_meta(nats::data_of(made));
  if (!meta) return tl::unexpected{fmt::format("{}: what stands for the object {} is no object", bucket, name)};
  return meta;
}

tl::expected<void, std::string> NatsObjectStore::write_chunks(const ObjectMeta& meta, std::string_view content) {
  const std::string subject = chunk_subject(meta.bucket, meta.nuid);
  for (; !content.empty(); content.remove_prefix(std::min(kChunk, content.size()))) {
    const auto size = static_cast<int>(std::min(kChunk, content.size()));
    const natsStatus status = js_Publish(nullptr, js_, subject.c_str(), content.data(), size, nullptr, nullptr);
    if (status != NATS_OK) return fail(meta.bucket, status);
  }
  return {};
}

tl::expected<void, std::string> NatsObjectStore::write_meta(const ObjectMeta& meta) {
  const std::string text = text_of(meta);
  natsMsg* made = nullptr;
  natsStatus status = natsMsg_Create(&made, meta_subject(meta.bucket, meta.name).c_str(), nullptr, text.data(),
                                     static_cast<int>(text.size()));
  const nats::Message message{made};
  if (status == NATS_OK) status = natsMsgHeader_Set(made, "Nats-Rollup", "sub");
  if (status == NATS_OK) status = js_PublishMsg(nullptr, js_, made, nullptr, nullptr);
  if (status != NATS_OK) return fail(meta.bucket, status);
  return {};
}

/// What stays of the chunks if that fails lies there unused.
void NatsObjectStore::purge(const ObjectMeta& meta) {
  const std::string subject = chunk_subject(meta.bucket, meta.nuid);
  jsOptions options;
  jsOptions_Init(&options);
  options.Stream.Purge.Subject = subject.c_str();
  js_PurgeStream(js_, stream_of(meta.bucket).c_str(), &options, nullptr);
}

tl::expected<void, std::string> NatsObjectStore::put(const std::string& bucket, const std::string& name,
                                                     std::string_view content) {
  if (content.size() > kLongest)
    return tl::unexpected{fmt::format("{}: an object of {} bytes, at most {}", bucket, content.size(), kLongest)};
  if (auto done = open(bucket); !done) return done;
  const auto former = meta_of(bucket, name);
  if (!former) return tl::unexpected{former.error()};
  const ObjectMeta meta{
      bucket, name, nats::new_nuid(), content.size(), (content.size() + kChunk - 1) / kChunk, digest_of(content)};
  auto done = write_chunks(meta, content);
  if (done) done = write_meta(meta);
  if (done && *former && !(*former)->is_deleted) purge(**former);
  return done;
}

/// The chunks are told in their order; one that is missing is waited for in vain.
tl::expected<std::string, std::string> NatsObjectStore::read_chunks(const ObjectMeta& meta) {
  std::string content;
  if (meta.chunks == 0) return content;
  jsSubOptions options;
  jsSubOptions_Init(&options);
  options.Ordered = true;
  natsSubscription* made = nullptr;
  natsStatus status =
      js_SubscribeSync(&made, js_, chunk_subject(meta.bucket, meta.nuid).c_str(), nullptr, &options, nullptr);
  const nats::Subscription subscription{made};
  for (std::size_t chunk = 0; status == NATS_OK && chunk < meta.chunks && content.size() <= kLongest; ++chunk) {
    natsMsg* next = nullptr;
    status = natsSubscription_NextMsg(&next, made, kChunkWait);
    const nats::Message message{next};
    if (status == NATS_OK) content += nats::data_of(next);
  }
  if (status != NATS_OK && status != NATS_TIMEOUT) return fail(meta.bucket, status);
  return content;
}

/// While it is read, an object may be replaced, which takes its chunks away.
tl::expected<std::optional<std::string>, std::string> NatsObjectStore::get(const std::string& bucket,
                                                                           const std::string& name) {
  if (auto done = open(bucket); !done) return tl::unexpected{done.error()};
  std::string former;
  for (;;) {
    const auto meta = meta_of(bucket, name);
    if (!meta) return tl::unexpected{meta.error()};
    if (!*meta || (*meta)->is_deleted) return std::nullopt;
    auto content = read_chunks(**meta);
    if (content && is_whole(**meta, *content)) return *std::move(content);
    if (std::exchange(former, (*meta)->nuid) != (*meta)->nuid) continue;
    if (!content) return tl::unexpected{content.error()};
    return tl::unexpected{fmt::format("{}: the object {} is damaged", bucket, name)};
  }
}

tl::expected<void, std::string> NatsObjectStore::remove(const std::string& bucket, const std::string& name) {
  if (auto done = open(bucket); !done) return done;
  const auto former = meta_of(bucket, name);
  if (!former) return tl::unexpected{former.error()};
  if (!*former || (*former)->is_deleted) return {};
  ObjectMeta mark = **former;
  mark.size = 0;
  mark.chunks = 0;
  mark.digest.clear();
  mark.is_deleted = true;
  auto done = write_meta(mark);
  if (done) purge(**former);
  return done;
}

}  // namespace farm
