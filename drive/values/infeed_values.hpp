#pragma once

#include <cstddef>

namespace drive {
class Infeed;
}

/// What parameters show of the infeed.
namespace drive::infeed_value {

/// r0002.
double operating_display(const Infeed& infeed, std::size_t index) noexcept;
/// r0026 and r0070 (V).
double dc_voltage(const Infeed& infeed, std::size_t index) noexcept;
/// r0863: bit 0 it operates, bit 1 the line contactor is closed.
double coupling(const Infeed& infeed, std::size_t index) noexcept;
/// r0898 and r0899.
double sequence_control(const Infeed& infeed, std::size_t index) noexcept;
double sequence_status(const Infeed& infeed, std::size_t index) noexcept;

}  // namespace drive::infeed_value
