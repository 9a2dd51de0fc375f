#pragma once

#include <optional>
#include <string_view>

#include "motor/data/inverter_data.hpp"
#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/data/supply_data.hpp"

namespace motor {

/// A member that no real thing has, and what could be there instead ("a number above 0").
struct Impossible {
  std::string_view
      member;  ///< its name in the struct, with a dot before that of a struct inside: "coupling.damping"
  std::string_view expected;
};

/// The first member of @p machine, in the order of the struct, that the models cannot compute with. Members of the
/// other machine type do not count.
std::optional<Impossible> find_impossible(const MachineData& machine) noexcept;
/// The same for what hangs on the shaft.
std::optional<Impossible> find_impossible(const Load& load) noexcept;
/// A coupling, an end stop or a friction that would ring or damp faster than the models can follow.
std::optional<Impossible> find_impossible(const MachineData& machine, const Load& load) noexcept;
/// The same for a power unit.
std::optional<Impossible> find_impossible(const InverterData& inverter) noexcept;
/// The same for DC link and infeed; a line voltage of 0 is possible.
std::optional<Impossible> find_impossible(const SupplyData& supply) noexcept;

}  // namespace motor
