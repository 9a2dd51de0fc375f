#pragma once

#include "libcanopen/base/time.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace canopen {

/// The objects that choose between the two ways of error control (CiA 301, 7.2.8.3.2).
namespace error_control {
inline constexpr std::uint16_t kGuardTime = 0x100C;              ///< ms
inline constexpr std::uint16_t kLifeTimeFactor = 0x100D;         ///< guard times without a request
inline constexpr std::uint16_t kProducerHeartbeatTime = 0x1017;  ///< ms

/// The stored number @p index, sub-index 0; 0 if there is no such object.
inline std::int64_t stored(const Dictionary& dictionary, std::uint16_t index) noexcept {
  const Entry* const entry = dictionary.lookup(index, 0);
  return entry != nullptr ? dictionary.stored(*entry) : 0;
}

/// Silence of the master after which life guarding reports an error; 0 if it is off.
constexpr Duration life_time(std::int64_t guard_time, std::int64_t factor) noexcept {
  return std::chrono::milliseconds{guard_time * factor};
}
}  // namespace error_control

}  // namespace canopen
