#pragma once

#include <condition_variable>
#include <span>

#include <poll.h>

#include "libcanopen/base/time.hpp"

namespace bus {

/// What a thread waits for.
struct Wanted {
  std::span<pollfd> descriptors;                       ///< one of them is ready
  canopen::TimePoint until = canopen::kNever;          ///< on the bus's clock
  canopen::TimePoint machine_until = canopen::kNever;  ///< on the machine's
};

/// A thread's part in the time of its process; made by TimeShare::add().
class Party {
 public:
  Party() = default;
  Party(const Party&) = delete;
  Party& operator=(const Party&) = delete;
  ~Party() = default;

 private:
  friend class TimeShare;

  bool takes_part_ = false;
  bool waits_ = false;
  bool coordinates_ = false;  ///< it is to find out whose turn it is
  bool is_ready_ = false;     ///< one of the descriptors is, as of the last look
  Wanted wanted_{};
  std::condition_variable woken_;
};

}  // namespace bus
