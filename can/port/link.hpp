#pragma once

#include <optional>

#include "can/port/interface.hpp"

namespace bus {

/// Tells when the way to a bus can be used and when not.
class Link {
 public:
  Link() = default;
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  virtual ~Link() = default;

  /// File descriptor that polls readable when read() has something to do or to say; it stays the same.
  [[nodiscard]] virtual int descriptor() const noexcept = 0;
  /// Reads all that waits: the state it ends in, if it was changed on the way. The end may equal the start (gone
  /// and back again), in which case Port::reopen() is needed all the same.
  [[nodiscard]] virtual std::optional<LinkState> read() noexcept = 0;
  /// State as last told by read(), at first that of the construction.
  [[nodiscard]] virtual LinkState state() const noexcept = 0;
};

}  // namespace bus
