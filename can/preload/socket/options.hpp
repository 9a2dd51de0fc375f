#pragma once

#include "can/preload/socket/state.hpp"
#include "can/userbus/protocol.hpp"

namespace preload {

/// An option of level SOL_CAN_RAW that is one number of four bytes.
struct RawOption {
  int number;  ///< for setsockopt(2)
  userbus::OptionName name;
  uint32_t bits;  ///< of a value that count; 0: a value is true or false
};

/// nullptr if @p number is none of them.
const RawOption* raw_option(int number) noexcept;

/// What an option of level SOL_SOCKET that a CAN socket answers itself is about.
enum class SocketOption : uint8_t { Domain, Type, Error, SingleStamp, Stamping, CountDropped, Other };

/// Which of them @p number is; Other is the kernel's.
SocketOption socket_option(int number) noexcept;

}  // namespace preload
