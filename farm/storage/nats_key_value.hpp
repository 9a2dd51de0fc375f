#pragma once

#include <map>
#include <memory>
#include <string>

#include "can/nats/nats_handles.hpp"
#include "farm/storage/key_value.hpp"

namespace farm {

/// Buckets over JetStream, which are made when they are needed.
class NatsKeyValue final : public KeyValue {
 public:
  /// @p js outlives it.
  explicit NatsKeyValue(jsCtx* js) noexcept : js_{js} {}

  [[nodiscard]] tl::expected<std::optional<Entry>, std::string> get(const std::string& bucket,
                                                                    const std::string& key) override;
  [[nodiscard]] tl::expected<std::vector<Entry>, std::string> all(const std::string& bucket) override;
  [[nodiscard]] tl::expected<std::uint64_t, std::string> put(const std::string& bucket, const std::string& key,
                                                             std::string_view value) override;
  [[nodiscard]] tl::expected<std::optional<std::uint64_t>, std::string> update(const std::string& bucket,
                                                                               const std::string& key,
                                                                               std::string_view value,
                                                                               std::uint64_t revision) override;
  [[nodiscard]] tl::expected<void, std::string> remove(const std::string& bucket, const std::string& key) override;
  [[nodiscard]] tl::expected<void, std::string> make(const std::string& bucket) override;

  /// Whether something has failed: answers may not come over this connection any more.
  [[nodiscard]] bool has_failed() const noexcept { return has_failed_; }

 private:
  using Bucket = std::unique_ptr<kvStore, nats::Destroyer<kvStore_Destroy>>;
  using Revision = tl::expected<std::optional<std::uint64_t>, std::string>;

  [[nodiscard]] tl::expected<kvStore*, std::string> open(const std::string& bucket);
  [[nodiscard]] Revision write(const std::string& bucket, const std::string& key, std::string_view value,
                               std::uint64_t revision);
  /// Revision of the mark that stands for @p key since it was removed; 0 if it was not.
  [[nodiscard]] tl::expected<std::uint64_t, std::string> mark_of_removal(const std::string& bucket,
                                                                         const std::string& key);
  tl::unexpected<std::string> fail(const std::string& bucket, natsStatus status);

  jsCtx* js_;
  bool has_failed_ = false;
  std::map<std::string, Bucket> buckets_;
};

}  // namespace farm
