#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "farm/door/service/roster.hpp"
#include "farm/door/service/rpc.hpp"

namespace farm {

/// The door as a micro service of NATS: `nats micro ls` lists it, with the units as its endpoints.
struct ServiceInfo {
  std::string farm;
  std::string host;
  std::string id;       ///< letters and digits that no other service has
  std::string version;  ///< of the program, "0.2.0"
  std::string started;  ///< ISO 8601
};

/// What can be asked of a service.
enum class ServiceQuestion : std::uint8_t { Ping, Info, Stats };
inline constexpr std::array kServiceQuestions{ServiceQuestion::Ping, ServiceQuestion::Info,
                                              ServiceQuestion::Stats};

/// Subjects at which @p question is asked: of all services, of those of this name, of this one.
[[nodiscard]] std::array<std::string, 3> service_subjects(ServiceQuestion question, std::string_view id);
/// The answer to @p question, JSON.
[[nodiscard]] std::string service_answer(ServiceQuestion question, const ServiceInfo& info, const Roster& roster,
                                         const std::map<UnitName, Rpc::Count>& counts);

}  // namespace farm
