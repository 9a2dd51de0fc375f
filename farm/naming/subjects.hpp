#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "farm/naming/unit_name.hpp"

/// Subjects and buckets of a farm (docs/reference/farm-protocol.md).
namespace farm {

/// What a unit is reached by, and what it tells.
[[nodiscard]] std::string rpc_subject(std::string_view farm, const UnitName& unit);
[[nodiscard]] std::string event_subject(std::string_view farm, const UnitName& unit);
[[nodiscard]] std::string status_subject(std::string_view farm, const UnitName& unit);
/// The same of all units: "axisd.FARM.*.*.event".
[[nodiscard]] std::string all_events_subject(std::string_view farm);
[[nodiscard]] std::string all_statuses_subject(std::string_view farm);

/// What the door of a host tells: who is there; and its agent.
[[nodiscard]] std::string door_subject(std::string_view farm, std::string_view host);
[[nodiscard]] std::string agent_subject(std::string_view farm, std::string_view host);
/// The same of all hosts.
[[nodiscard]] std::string all_doors_subject(std::string_view farm);
[[nodiscard]] std::string all_agents_subject(std::string_view farm);
/// Doors and agents that hear a message here tell at once who they are.
[[nodiscard]] std::string who_subject(std::string_view farm);

/// Key-value bucket of the units that are wanted, of where they are, of the buses and of the hosts; object store
/// of what the units keep.
[[nodiscard]] std::string units_bucket(std::string_view farm);
[[nodiscard]] std::string places_bucket(std::string_view farm);
[[nodiscard]] std::string buses_bucket(std::string_view farm);
[[nodiscard]] std::string hosts_bucket(std::string_view farm);
[[nodiscard]] std::string state_bucket(std::string_view farm);
/// Name of the object with the file @p file of @p unit.
[[nodiscard]] std::string state_object(const UnitName& unit, std::string_view file);

/// The unit that a subject of a unit names; nothing if it is none of @p farm.
[[nodiscard]] std::optional<UnitName> unit_of_subject(std::string_view farm, std::string_view subject);

}  // namespace farm
