#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "can/nats/nats_handles.hpp"
#include "os/descriptor.hpp"

namespace farm {

/// Messages of a connection on their way from the thread of libnats that has read them off to the loop.
class Arrivals {
 public:
  struct Arrival {
    std::uint64_t subscription;
    nats::Message message;  ///< null: the last one has come
  };

  /// Throws std::system_error if the kernel gives no descriptor.
  Arrivals();

  /// Any thread: @p message has come for @p subscription, or none comes any more.
  void put(std::uint64_t subscription, nats::Message message);
  /// Readable while there are some.
  [[nodiscard]] int descriptor() const noexcept { return waiting_.get(); }
  /// All of them, in the order in which they came.
  [[nodiscard]] std::vector<Arrival> take();

 private:
  os::Descriptor waiting_;  ///< eventfd
  std::mutex mutex_;
  std::vector<Arrival> arrivals_;
};

}  // namespace farm
