#include <array>

#include "tools/axisctl/commands/command.hpp"

namespace axisctl {

std::span<const AddCommand> commands() noexcept {
  static constexpr std::array<AddCommand, 13> kCommands{
      &add_units, &add_wait,    &add_watch,  &add_monitor, &add_trace, &add_record, &add_page,
      &add_run,   &add_compare, &add_replay, &add_twin,    &add_fleet, &add_step};
  return kCommands;
}

}  // namespace axisctl
