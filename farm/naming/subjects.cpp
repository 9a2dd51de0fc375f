#include "farm/naming/subjects.hpp"

#include <fmt/format.h>

namespace farm {
namespace {

std::string subject_of_unit(std::string_view farm, const UnitName& unit, std::string_view what) {
  return fmt::format("axisd.{}.{}.{}", farm, unit.key(), what);
}

std::string bucket(std::string_view farm, std::string_view what) {
  return fmt::format("axisd_{}_{}", farm, what);
}

}  // namespace

std::string rpc_subject(std::string_view farm, const UnitName& unit) {
  return subject_of_unit(farm, unit, "rpc");
}

std::string event_subject(std::string_view farm, const UnitName& unit) {
  return subject_of_unit(farm, unit, "event");
}

std::string status_subject(std::string_view farm, const UnitName& unit) {
  return subject_of_unit(farm, unit, "status");
}

std::string all_events_subject(std::string_view farm) {
  return fmt::format("axisd.{}.*.*.event", farm);
}

std::string all_statuses_subject(std::string_view farm) {
  return fmt::format("axisd.{}.*.*.status", farm);
}

std::string door_subject(std::string_view farm, std::string_view host) {
  return fmt::format("axisd_host.{}.{}.door", farm, host);
}

std::string agent_subject(std::string_view farm, std::string_view host) {
  return fmt::format("axisd_host.{}.{}.agent", farm, host);
}

std::string all_doors_subject(std::string_view farm) {
  return fmt::format("axisd_host.{}.*.door", farm);
}

std::string all_agents_subject(std::string_view farm) {
  return fmt::format("axisd_host.{}.*.agent", farm);
}

std::string who_subject(std::string_view farm) {
  return fmt::format("axisd_host.{}.who", farm);
}

std::string units_bucket(std::string_view farm) {
  return bucket(farm, "units");
}

std::string places_bucket(std::string_view farm) {
  return bucket(farm, "places");
}

std::string buses_bucket(std::string_view farm) {
  return bucket(farm, "buses");
}

std::string hosts_bucket(std::string_view farm) {
  return bucket(farm, "hosts");
}

std::string state_bucket(std::string_view farm) {
  return bucket(farm, "state");
}

std::string state_object(const UnitName& unit, std::string_view file) {
  return fmt::format("{}/{}", unit.key(), file);
}

std::optional<UnitName> unit_of_subject(std::string_view farm, std::string_view subject) {
  const std::string front = fmt::format("axisd.{}.", farm);
  const std::size_t what = subject.rfind('.');
  if (!subject.starts_with(front) || what == std::string_view::npos || what < front.size()) return std::nullopt;
  return parse_unit_key(subject.substr(front.size(), what - front.size()));
}

}  // namespace farm
