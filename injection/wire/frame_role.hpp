#pragma once

#include <cstdint>

#include "device/device.hpp"
#include "injection/language/event.hpp"
#include "libcanopen/base/frame.hpp"

namespace injection {

/// What a frame is to the unit whose it is.
struct Role {
  EventKind kind = EventKind::Frame;
  std::uint16_t number = 0;  ///< of the SDO server or the PDO, from 1
};

/// What @p frame is to @p device, which has sent it or is about to take it. The answer to node guarding and a
/// heartbeat look alike: it is told as the latter.
Role role_of(const device::Device& device, const canopen::Frame& frame, bool is_sent) noexcept;

}  // namespace injection
