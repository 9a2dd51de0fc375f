#include "farm/storage/nats_key_value.hpp"

#include <utility>

#include <fmt/format.h>

#include "can/nats/message.hpp"
#include "can/nats/server.hpp"
#include "farm/storage/storage_error.hpp"

namespace farm {

namespace {

using Value = std::unique_ptr<kvEntry, nats::Destroyer<kvEntry_Destroy>>;
using Watcher = std::unique_ptr<kvWatcher, nats::Destroyer<kvWatcher_Destroy>>;
using Placed = std::unique_ptr<jsPubAck, nats::Destroyer<jsPubAck_Destroy>>;

constexpr std::int64_t kWait = 2000;  // ms

std::string subject_of(const std::string& bucket, const std::string& key) {
  return fmt::format("$KV.{}.{}", bucket, key);
}

Entry entry_of(const Value& value) {
  kvEntry* const entry = value.get();
  return {kvEntry_Key(entry),
          {static_cast<const char*>(kvEntry_Value(entry)), static_cast<std::size_t>(kvEntry_ValueLen(entry))},
          kvEntry_Revision(entry),
          kvEntry_Operation(entry) != kvOp_Put};
}

}  // namespace

tl::expected<kvStore*, std::string> NatsKeyValue::open(const std::string& bucket) {
  if (const auto known = buckets_.find(bucket); known != buckets_.end()) return known->second.get();
  kvStore* made = nullptr;
  natsStatus status = js_KeyValue(&made, js_, bucket.c_str());
  if (status == NATS_NOT_FOUND) {
    kvConfig config;
    kvConfig_Init(&config);
    config.Bucket = bucket.c_str();
    config.History = 1;
    status = js_CreateKeyValue(&made, js_, &config);
    if (status != NATS_OK) status = js_KeyValue(&made, js_, bucket.c_str());  // another was faster
  }
  if (status != NATS_OK) return fail(bucket, status);
  buckets_[bucket].reset(made);
  return made;
}

/// A bucket that was removed by somebody is made again the next time.
tl::unexpected<std::string> NatsKeyValue::fail(const std::string& bucket, natsStatus status) {
  buckets_.erase(bucket);
  has_failed_ = true;
  return tl::unexpected{storage_error(bucket, status)};
}

tl::expected<void, std::string> NatsKeyValue::make(const std::string& bucket) {
  buckets_.erase(bucket);
  return open(bucket).map([](kvStore*) {});
}

tl::expected<std::optional<Entry>, std::string> NatsKeyValue::get(const std::string& bucket,
                                                                  const std::string& key) {
  const auto store = open(bucket);
  if (!store) return tl::unexpected{store.error()};
  kvEntry* entry = nullptr;
  const natsStatus status = kvStore_Get(&entry, *store, key.c_str());
  const Value value{entry};
  if (status == NATS_NOT_FOUND) return std::nullopt;
  if (status != NATS_OK) return fail(bucket, status);
  return entry_of(value);
}

tl::expected<std::vector<Entry>, std::string> NatsKeyValue::all(const std::string& bucket) {
  const auto store = open(bucket);
  if (!store) return tl::unexpected{store.error()};
  kvWatchOptions options;
  kvWatchOptions_Init(&options);
  options.IgnoreDeletes = true;
  options.Timeout = kWait;
  kvWatcher* made = nullptr;
  natsStatus status = kvStore_WatchAll(&made, *store, &options);
  const Watcher watcher{made};
  std::vector<Entry> entries;
  while (status == NATS_OK) {
    kvEntry* entry = nullptr;
    status = kvWatcher_Next(&entry, made, kWait);
    const Value value{entry};
    if (status == NATS_OK && entry == nullptr) return entries;  // that was all that is there
    if (status == NATS_OK) entries.push_back(entry_of(value));
  }
  return fail(bucket, status);
}

tl::expected<std::uint64_t, std::string> NatsKeyValue::put(const std::string& bucket, const std::string& key,
                                                           std::string_view value) {
  const auto store = open(bucket);
  if (!store) return tl::unexpected{store.error()};
  std::uint64_t revision = 0;
  const natsStatus status =
      kvStore_Put(&revision, *store, key.c_str(), value.data(), static_cast<int>(value.size()));
  if (status != NATS_OK) return fail(bucket, status);
  return revision;
}

/// By the publishing that the library's kvStore_Update() does, too: that one does not say why it fails.
NatsKeyValue::Revision NatsKeyValue::write(const std::string& bucket, const std::string& key,
                                           std::string_view value, std::uint64_t revision) {
  jsPubOptions options;
  jsPubOptions_Init(&options);
  options.ExpectLastSubjectSeq = revision;
  options.ExpectNoMessage = revision == 0;
  jsPubAck* made = nullptr;
  jsErrCode code{};
  const natsStatus status = js_Publish(&made, js_, subject_of(bucket, key).c_str(), value.data(),
                                       static_cast<int>(value.size()), &options, &code);
  const Placed placed{made};
  if (code == JSStreamWrongLastSequenceErr) return std::nullopt;
  if (status != NATS_OK) return fail(bucket, status);
  return placed->Sequence;
}

/// Unlike kvStore_Get() it shows what was removed, too.
tl::expected<std::uint64_t, std::string> NatsKeyValue::mark_of_removal(const std::string& bucket,
                                                                       const std::string& key) {
  natsMsg* made = nullptr;
  jsErrCode code{};
  const natsStatus status =
      js_GetLastMsg(&made, js_, ("KV_" + bucket).c_str(), subject_of(bucket, key).c_str(), nullptr, &code);
  const nats::Message message{made};
  if (status == NATS_NOT_FOUND) return 0;
  if (status != NATS_OK) return fail(bucket, status);
  const auto operation = nats::header_of(made, "KV-Operation");
  if (!operation) return fail(bucket, operation.error());
  return *operation != nullptr ? natsMsg_GetSequence(made) : 0;
}

/// A key that was removed has a mark in its place, and the revision of that.
NatsKeyValue::Revision NatsKeyValue::update(const std::string& bucket, const std::string& key,
                                            std::string_view value, std::uint64_t revision) {
  const auto store = open(bucket);
  if (!store) return tl::unexpected{store.error()};
  auto written = write(bucket, key, value, revision);
  if (revision != 0 || !written || *written) return written;
  const auto mark = mark_of_removal(bucket, key);
  if (!mark) return tl::unexpected{mark.error()};
  if (*mark == 0) return std::nullopt;
  return write(bucket, key, value, *mark);
}

tl::expected<void, std::string> NatsKeyValue::remove(const std::string& bucket, const std::string& key) {
  const auto store = open(bucket);
  if (!store) return tl::unexpected{store.error()};
  const natsStatus status = kvStore_Delete(*store, key.c_str());
  if (status != NATS_OK && status != NATS_NOT_FOUND) return fail(bucket, status);
  return {};
}

}  // namespace farm
