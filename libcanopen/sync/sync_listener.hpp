#pragma once

#include <cstdint>

#include "libcanopen/base/time.hpp"

namespace canopen {

/// A service that works with SYNC.
class SyncListener {
 public:
  virtual ~SyncListener() = default;
  /// A SYNC with @p counter, 0 if it carries none, and with the synchronous window @p window (1007h), 0 for none.
  /// The NMT state may be one in which the listener does not live.
  virtual void on_sync(std::uint8_t counter, Duration window) noexcept = 0;
};

}  // namespace canopen
