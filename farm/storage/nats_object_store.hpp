#pragma once

#include <optional>
#include <set>
#include <string>

#include "can/nats/nats_handles.hpp"
#include "farm/storage/object_meta.hpp"
#include "farm/storage/object_store.hpp"

namespace farm {

/// Object stores over JetStream, which are made when they are needed.
class NatsObjectStore final : public ObjectStore {
 public:
  /// @p js outlives it.
  explicit NatsObjectStore(jsCtx* js) noexcept : js_{js} {}

  [[nodiscard]] tl::expected<void, std::string> put(const std::string& bucket, const std::string& name,
                                                    std::string_view content) override;
  [[nodiscard]] tl::expected<std::optional<std::string>, std::string> get(const std::string& bucket,
                                                                          const std::string& name) override;
  [[nodiscard]] tl::expected<void, std::string> remove(const std::string& bucket,
                                                       const std::string& name) override;

  /// Whether something has failed: answers may not come over this connection any more.
  [[nodiscard]] bool has_failed() const noexcept { return has_failed_; }

 private:
  using Done = tl::expected<void, std::string>;

  [[nodiscard]] Done open(const std::string& bucket);
  [[nodiscard]] tl::expected<std::optional<ObjectMeta>, std::string> meta_of(const std::string& bucket,
                                                                             const std::string& name);
  [[nodiscard]] Done write_chunks(const ObjectMeta& meta, std::string_view content);
  [[nodiscard]] Done write_meta(const ObjectMeta& meta);
  [[nodiscard]] tl::expected<std::string, std::string> read_chunks(const ObjectMeta& meta);
  void purge(const ObjectMeta& meta);
  tl::unexpected<std::string> fail(const std::string& bucket, natsStatus status);

  jsCtx* js_;
  bool has_failed_ = false;
  std::set<std::string> buckets_;  ///< that are there
};

}  // namespace farm
