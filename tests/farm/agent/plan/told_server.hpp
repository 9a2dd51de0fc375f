#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "farm/agent/plan/orders.hpp"
#include "farm/storage/key_value.hpp"

namespace told {

using farm::UnitName;
using farm::agent::Bucket;
using farm::agent::kBuckets;

/// A server with buckets, at times that a test tells.
class Server {
 public:
  using Keys = std::map<std::string, farm::Entry>;

  [[nodiscard]] const Keys& keys(Bucket bucket) const {
    return buckets_.at(static_cast<std::size_t>(bucket)).keys;
  }

  /// Writes if the key has @p revision, or whatever it has without one; what was written.
  std::optional<farm::Entry> write(Bucket bucket, const std::string& key, const std::string& value,
                                   std::optional<std::uint64_t> revision, bool is_deleted = false) {
    Content& content = buckets_.at(static_cast<std::size_t>(bucket));
    const auto known = content.keys.find(key);
    const std::uint64_t present = known == content.keys.end() ? 0 : known->second.revision;
    const bool is_free = known == content.keys.end() || known->second.is_deleted;
    if (revision && *revision != present && !(*revision == 0 && is_free)) return std::nullopt;
    ++writes;
    return content.keys[key] = farm::Entry{key, value, ++content.revision, is_deleted};
  }
  /// It is killed, and another one begins with nothing.
  void lose() {
    buckets_ = {};
    saved.clear();
  }

  std::map<UnitName, int> saved;  ///< the object store: what each unit has saved
  std::uint64_t writes = 0;

 private:
  struct Content {
    Keys keys;
    std::uint64_t revision = 0;
  };
  std::array<Content, kBuckets> buckets_;
};

}  // namespace told
