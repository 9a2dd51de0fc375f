#pragma once

#include "can/userbus/processor.hpp"
#include "libcanopen/base/time.hpp"

namespace hub {

/// The processor on which the hub runs, and those whom it gives turns are woken. It stays there for a while, then
/// the kernel may choose another one.
class Processor {
 public:
  Processor() = default;
  Processor(const Processor&) = delete;
  Processor& operator=(const Processor&) = delete;
  ~Processor() { userbus::end_stay(stay_); }

  /// Before a turn is given at @p now of the machine. What goes into userbus::TimeTurn::processor.
  unsigned choose(canopen::TimePoint now) noexcept;

 private:
  userbus::Stay stay_;
  canopen::TimePoint until_{};
};

}  // namespace hub
