#include "tools/axisctl/scenario/language/fault_kinds.hpp"

#include <algorithm>
#include <vector>

#include "injection/kinds/bus_kinds.hpp"
#include "injection/kinds/unit_kinds.hpp"

namespace scenario {

std::span<const injection::Kind> fault_kinds() {
  static const std::vector<injection::Kind> kAll = [] {
    const auto of_units = injection::unit_kinds();
    const auto of_buses = injection::bus_kinds();
    std::vector<injection::Kind> all{of_units.begin(), of_units.end()};
    all.insert(all.end(), of_buses.begin(), of_buses.end());
    return all;
  }();
  return kAll;
}

bool is_bus_kind(std::string_view kind) noexcept {
  return std::ranges::count(injection::bus_kinds(), kind, &injection::Kind::name) != 0;
}

}  // namespace scenario
