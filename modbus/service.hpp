#pragma once

#include "modbus/register_bank.hpp"

namespace modbus {

/// The registers as a server sees them.
class Service : public RegisterBank {
 public:
  /// Whether there is something behind the registers now; nobody is served while there is not.
  virtual bool is_available() const noexcept = 0;
  /// True if process data was written since the last call.
  virtual bool take_command() noexcept = 0;
  /// A client that had written process data is gone.
  virtual void on_command_lost() noexcept = 0;
};

}  // namespace modbus
