#pragma once

namespace motor {

/// Sampling time of the control loops (s), p0115[0] of a servo; a plant advances by it.
inline constexpr double kControlPeriod = 125e-6;

}  // namespace motor
