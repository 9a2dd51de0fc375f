#include "daemon/control/handlers.hpp"

#include <algorithm>
#include <array>

namespace axisd {
namespace {

using Group = std::span<const Handler> (*)() noexcept;
constexpr auto kGroups = std::to_array<Group>({
    &unit_handlers,
    &fault_handlers,
    &inject_handlers,
    &message_handlers,
    &plant_handlers,
    &record_handlers,
    &terminal_handlers,
    &parameter_handlers,
    &parameter_list_handlers,
    &object_handlers,
    &terminal_list_handlers,
    &plant_state_handlers,
    &pdo_handlers,
    &nmt_handlers,
    &storage_handlers,
    &audit_handlers,
    &signal_handlers,
    &trace_handlers,
    &if1_handlers,
    &acyclic_handlers,
    &state_machine_handlers,
    &panel_handlers,
    &identification_handlers,
});

}  // namespace

const Handler* find_handler(std::string_view method) noexcept {
  for (const Group group : kGroups) {
    const std::span<const Handler> handlers = group();
    const auto row = std::ranges::find(handlers, method, &Handler::method);
    if (row != handlers.end()) return &*row;
  }
  return nullptr;
}

}  // namespace axisd
