#pragma once

#include <span>

#include "daemon/control/handler.hpp"

namespace axisd {

// A function a group of methods, each in a file of its own.

std::span<const Handler> unit_handlers() noexcept;
std::span<const Handler> fault_handlers() noexcept;
std::span<const Handler> inject_handlers() noexcept;
std::span<const Handler> plant_handlers() noexcept;
std::span<const Handler> record_handlers() noexcept;
std::span<const Handler> terminal_handlers() noexcept;
std::span<const Handler> parameter_handlers() noexcept;
std::span<const Handler> parameter_list_handlers() noexcept;
std::span<const Handler> object_handlers() noexcept;
std::span<const Handler> terminal_list_handlers() noexcept;
std::span<const Handler> plant_state_handlers() noexcept;
std::span<const Handler> pdo_handlers() noexcept;
std::span<const Handler> nmt_handlers() noexcept;
std::span<const Handler> storage_handlers() noexcept;
std::span<const Handler> message_handlers() noexcept;
std::span<const Handler> audit_handlers() noexcept;
std::span<const Handler> signal_handlers() noexcept;
std::span<const Handler> trace_handlers() noexcept;
std::span<const Handler> if1_handlers() noexcept;
std::span<const Handler> acyclic_handlers() noexcept;
std::span<const Handler> state_machine_handlers() noexcept;
std::span<const Handler> panel_handlers() noexcept;
std::span<const Handler> identification_handlers() noexcept;

/// The handler of @p method among those of all groups; nullptr if it has none.
const Handler* find_handler(std::string_view method) noexcept;

}  // namespace axisd
