#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "daemon/configuration/configuration.hpp"
#include "daemon/watch/unit_event.hpp"
#include "os/descriptor.hpp"

namespace axisd {

/// Events of units on their way to the thread of the control socket. Whoever adds one never waits for whoever
/// takes them: what does not fit is counted and lost.
class EventQueue {
 public:
  /// An event, and whose it is.
  struct Entry {
    const Configuration* unit = nullptr;  ///< of the unit
    canopen::TimePoint started{};         ///< zero of its times
    UnitEvent event{};
  };
  static constexpr std::size_t kMost = 4096;

  /// Throws std::system_error if the kernel gives no descriptor.
  EventQueue();

  /// Any thread; nothing is allocated.
  void add(const Entry& entry) noexcept;
  /// Readable while there is something to take.
  int descriptor() const noexcept { return waiting_.get(); }
  /// Exchanges what has come with @p taken, which is emptied, and returns how many were lost since the last call.
  std::uint64_t take(std::vector<Entry>& taken);

 private:
  std::mutex mutex_;
  std::vector<Entry> entries_;
  std::uint64_t lost_ = 0;
  os::Descriptor waiting_;  ///< eventfd
};

}  // namespace axisd
