#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace farm {

/// What a key of a bucket holds, or that it was deleted.
struct Entry {
  std::string key;
  std::string value;
  std::uint64_t revision = 0;  ///< of the bucket when it was written
  bool is_deleted = false;
};

/// Key-value buckets of a server. Every call waits for the server, 2 s at most; errors are one line.
class KeyValue {
 public:
  KeyValue() = default;
  KeyValue(const KeyValue&) = delete;
  KeyValue& operator=(const KeyValue&) = delete;
  virtual ~KeyValue() = default;

  /// Makes the bucket if there is none. The other calls do so, too.
  [[nodiscard]] virtual tl::expected<void, std::string> make(const std::string& bucket) = 0;
  /// Nothing in it: there is no such key.
  [[nodiscard]] virtual tl::expected<std::optional<Entry>, std::string> get(const std::string& bucket,
                                                                            const std::string& key) = 0;
  /// All keys with their values.
  [[nodiscard]] virtual tl::expected<std::vector<Entry>, std::string> all(const std::string& bucket) = 0;
  /// Writes whatever was there; the new revision.
  [[nodiscard]] virtual tl::expected<std::uint64_t, std::string> put(const std::string& bucket,
                                                                     const std::string& key,
                                                                     std::string_view value) = 0;
  /// Writes if the key has @p revision, 0: if there is none; the new revision, or nothing if somebody was faster.
  [[nodiscard]] virtual tl::expected<std::optional<std::uint64_t>, std::string> update(const std::string& bucket,
                                                                                       const std::string& key,
                                                                                       std::string_view value,
                                                                                       std::uint64_t revision) = 0;
  [[nodiscard]] virtual tl::expected<void, std::string> remove(const std::string& bucket,
                                                               const std::string& key) = 0;
};

}  // namespace farm
