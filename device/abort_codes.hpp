#pragma once

#include "drive/parameter/error.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace device {

/// The abort code that answers a refused access to a parameter; a reason without one of its own is the state of
/// the unit.
[[nodiscard]] canopen::AbortCode abort_code(drive::Refusal reason) noexcept;

/// The reason that stands for @p code where a parameter has to say why an object was refused; NotNow if none is
/// closer.
[[nodiscard]] drive::Refusal refusal(canopen::AbortCode code) noexcept;

}  // namespace device
