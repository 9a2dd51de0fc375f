#pragma once

#include <memory>
#include <span>

#include "can/clock/time_share.hpp"
#include "daemon/configuration/configuration.hpp"

namespace axisd {

/// Lets the process live by the time of the first bus in user space that one of @p units is on, if that has its
/// own; nullptr: it has the machine's. Before there are threads. Throws bus::OpenError.
std::unique_ptr<bus::TimeShare> join_bus_time(std::span<const Configuration> units);

}  // namespace axisd
