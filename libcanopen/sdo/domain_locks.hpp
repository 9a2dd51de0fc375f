#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "libcanopen/od/entry.hpp"

namespace canopen::sdo {

/// Which server streams which DOMAIN: many may read one, who writes is alone.
class DomainLocks {
 public:
  /// For servers 0 .. @p servers - 1, none of which streams.
  explicit DomainLocks(std::size_t servers) : locks_(servers) {}

  /// True if a further server may read @p entry, or write it.
  bool allow(const Entry& entry, bool writes) const noexcept {
    return std::none_of(locks_.begin(), locks_.end(),
                        [&](const Lock& lock) { return lock.entry == &entry && (writes || lock.writes); });
  }
  /// Notes that @p server streams @p entry from now on.
  void take(std::size_t server, const Entry& entry, bool writes) noexcept { locks_[server] = {&entry, writes}; }
  /// Notes that @p server streams nothing any more.
  void release(std::size_t server) noexcept { locks_[server] = {}; }

 private:
  struct Lock {
    const Entry* entry = nullptr;
    bool writes = false;
  };
  std::vector<Lock> locks_;
};

}  // namespace canopen::sdo
