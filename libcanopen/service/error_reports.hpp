#pragma once

#include "libcanopen/application/communication_error.hpp"

namespace canopen {

/// Where the services of a node report what they detect. The node implements it.
class ErrorReports {
 public:
  virtual ~ErrorReports() = default;
  /// @p error has begun, or happened once more.
  virtual void on_error(CommunicationError error, std::uint16_t detail) noexcept = 0;
  /// @p error is over; nothing happens if it was not reported before.
  virtual void on_recovery(CommunicationError error, std::uint16_t detail) noexcept = 0;
};

}  // namespace canopen
