#pragma once

#include <cstdint>

#include <sys/types.h>

#include "can/userbus/time.hpp"
#include "libcanopen/base/time.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// The time of a bus that has one of its own, as members see it.
class Turns {
 public:
  Turns() = default;
  Turns(const Turns&) = delete;
  Turns& operator=(const Turns&) = delete;
  virtual ~Turns() = default;

  /// Something has been put into a socket of @p process, or its socket has room again; 0 = some process.
  virtual void on_given(pid_t process) noexcept = 0;
  /// Whether @p process acts, with something said by one of its sockets: what they have sent is read when its turn
  /// ends, or when it asks for something.
  virtual bool defers(pid_t process) noexcept = 0;
  /// A socket of the process that acts is full, or nearly.
  virtual void on_full() noexcept = 0;
  /// The time of a frame that @p process has sent and that says @p time_ns (userbus::Trailer::time_ns).
  virtual canopen::TimePoint time_of_sending(pid_t process, std::int64_t time_ns) noexcept = 0;
  /// Stepped time may go on by @p step, not negative; a userbus::Reply goes to @p reply when it has. errno, 0 =
  /// done.
  virtual int step(canopen::Duration step, os::Descriptor reply) noexcept = 0;
  /// Who is waited for.
  [[nodiscard]] virtual userbus::TimeState state() const noexcept = 0;
  /// What Operation::Time passes; the hub's own.
  [[nodiscard]] virtual int page() const noexcept = 0;
};

}  // namespace hub
