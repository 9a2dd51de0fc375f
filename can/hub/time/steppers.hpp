#pragma once

#include <memory>
#include <vector>

#include "can/hub/loop/poll.hpp"
#include "libcanopen/base/time.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// Who has stepped time go on, and is answered when it has.
class Steppers {
 public:
  /// @p poll outlives this.
  explicit Steppers(Poll& poll) noexcept;
  ~Steppers();

  Steppers(const Steppers&) = delete;
  Steppers& operator=(const Steppers&) = delete;

  /// Somebody who waits at @p reply for @p goal; false if there is no memory, then @p reply is left.
  [[nodiscard]] bool add(canopen::TimePoint goal, os::Descriptor& reply) noexcept;
  /// The nearest goal; kNever if nobody waits. Whoever has closed the socket does not wait any more.
  [[nodiscard]] canopen::TimePoint next_goal() const noexcept;
  /// Everything that belongs to @p now has happened: answers those whose goal that is. False if there is none.
  bool answer(canopen::TimePoint now) noexcept;

 private:
  class Stepper;

  Poll& poll_;
  std::vector<std::unique_ptr<Stepper>> waiting_;
};

}  // namespace hub
