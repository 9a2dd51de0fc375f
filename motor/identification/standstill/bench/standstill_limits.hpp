#pragma once

#include "motor/identification/standstill/bench/standstill_data.hpp"

namespace motor {

/// The first value of @p result that no machine with the rating plate of @p machine has, by a table of shares of
/// its rated impedance; values that are still 0 are not looked at.
StandstillFault find_implausible(const MachineData& machine, const StandstillResult& result) noexcept;

}  // namespace motor
