#pragma once

#include <optional>

#include "drive/parameter/error.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace device {

/// The abort code that answers a refused access to a parameter: that with which the dictionary has refused it,
/// else that of the reason. A reason without one of its own is the state of the unit.
[[nodiscard]] canopen::AbortCode abort_code(const drive::Refusal& refusal) noexcept;

/// What the dictionary makes of a parameter that is an object, for the drive unit: nothing, or a refusal for the
/// reason that is the closest to the abort code, NotNow if none is, which abort_code() makes the same code of.
[[nodiscard]] std::optional<drive::Refusal> refusal(const canopen::Result<void>& result) noexcept;

/// What the unit has done or refused, for the dictionary.
[[nodiscard]] canopen::Result<void> result(const std::optional<drive::Refusal>& refusal) noexcept;

}  // namespace device
