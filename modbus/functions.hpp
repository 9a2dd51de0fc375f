#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "modbus/frame.hpp"
#include "modbus/register_bank.hpp"

namespace modbus {

/// What an answer with bit 7 of the function says.
enum class Exception : std::uint8_t {
  UnknownFunction = 1,
  BadAddress = 2,     ///< a register outside the bank
  BadValue = 3,       ///< a count, a byte count or a length
  ServerFailure = 4,  ///< a write was refused
};

/// Set in the function of an answer that is an exception.
inline constexpr std::uint8_t kExceptionBit = 0x80;

/// Carries function and data of @p request (at least the function) out on @p bank and writes those of the answer;
/// the number of their bytes. Functions are 03, 06 and 16; checked are function, count and address, in this order.
std::size_t answer(std::span<const std::uint8_t> request, std::span<std::uint8_t, kMostPduBytes> response,
                   RegisterBank& bank) noexcept;

}  // namespace modbus
