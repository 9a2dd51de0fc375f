#pragma once

#include <cstddef>
#include <string>

#include "gateway/server/counters.hpp"

namespace gateway {

/// What the gateway tells of itself, as Prometheus reads it: requests, viewers, @p daemons and @p units that it
/// reaches, processor time and memory of its process.
[[nodiscard]] std::string own_metrics(const Counters& counters, std::size_t daemons, std::size_t units);

}  // namespace gateway
