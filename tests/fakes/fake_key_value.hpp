#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "farm/storage/key_value.hpp"

namespace fakes {

/// Buckets in memory. Once `error` is there, every call fails with it.
class FakeKeyValue final : public farm::KeyValue {
 public:
  tl::expected<void, std::string> make(const std::string& bucket) override {
    if (!error.empty()) return tl::unexpected{error};
    buckets[bucket];
    return {};
  }
  tl::expected<std::optional<farm::Entry>, std::string> get(const std::string& bucket,
                                                            const std::string& key) override {
    if (!error.empty()) return tl::unexpected{error};
    const auto found = buckets[bucket].find(key);
    if (found == buckets[bucket].end()) return std::nullopt;
    return found->second;
  }
  tl::expected<std::vector<farm::Entry>, std::string> all(const std::string& bucket) override {
    if (!error.empty()) return tl::unexpected{error};
    std::vector<farm::Entry> entries;
    for (const auto& [key, entry] : buckets[bucket]) entries.push_back(entry);
    return entries;
  }
  tl::expected<std::uint64_t, std::string> put(const std::string& bucket, const std::string& key,
                                               std::string_view value) override {
    if (!error.empty()) return tl::unexpected{error};
    ++writes;
    buckets[bucket][key] = {key, std::string{value}, ++revision};
    return revision;
  }
  tl::expected<std::optional<std::uint64_t>, std::string> update(const std::string& bucket, const std::string& key,
                                                                 std::string_view value,
                                                                 std::uint64_t expected) override {
    if (!error.empty()) return tl::unexpected{error};
    const auto present = buckets[bucket].find(key);
    const std::uint64_t now = present == buckets[bucket].end() ? 0 : present->second.revision;
    if (now != expected) return std::nullopt;
    return *put(bucket, key, value);
  }
  tl::expected<void, std::string> remove(const std::string& bucket, const std::string& key) override {
    if (!error.empty()) return tl::unexpected{error};
    buckets[bucket].erase(key);
    return {};
  }

  std::map<std::string, std::map<std::string, farm::Entry>> buckets;
  std::string error;
  unsigned writes = 0;
  std::uint64_t revision = 0;
};

}  // namespace fakes
