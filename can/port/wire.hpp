#pragma once

#include <linux/can.h>
#include <linux/can/error.h>

#include "can/port/port.hpp"
#include "libcanopen/base/frame.hpp"

namespace bus {

/// Which error frames tell the controller's error state: the mask a socket asks for.
inline constexpr can_err_mask_t kErrorMask = CAN_ERR_CRTL | CAN_ERR_BUSOFF | CAN_ERR_RESTARTED | CAN_ERR_CNT;

/// @p frame in the form of Linux' SocketCAN.
[[nodiscard]] can_frame to_wire(const canopen::Frame& frame) noexcept;
/// The frame that @p wire holds; data beyond its length are zero, as are those of a remote frame.
[[nodiscard]] canopen::Frame from_wire(const can_frame& wire) noexcept;
/// Kernel filter that lets pass exactly what @p filter asks for: identifier, frame format and remote bit.
[[nodiscard]] can_filter to_wire(const Filter& filter) noexcept;
/// Error state after error frame @p wire when it was @p before (linux/can/error.h).
[[nodiscard]] ErrorState decode_error_state(const can_frame& wire, ErrorState before) noexcept;
/// What a failed send with error number @p error means.
[[nodiscard]] SendStatus to_send_status(int error) noexcept;

}  // namespace bus
