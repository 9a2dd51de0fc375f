#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <nlohmann/json.hpp>

#include "control/error.hpp"
#include "device/bus/unit_time.hpp"
#include "trace/recording.hpp"
#include "trace/signal/problem.hpp"
#include "unit/time.hpp"

namespace axisd {

class Instance;

/// @p problem as an error of the control socket.
control::Error error_of(const trace::Problem& problem);

/// @p time in seconds since the start of @p instance.
double seconds_since_start(const Instance& instance, unit::TimePoint time) noexcept;

/// The parts of a result that are read by themselves.
inline constexpr std::array<std::string_view, 3> kTraceParts{"samples", "frames", "events"};

/// How many items part @p part (0 = samples, ...) of @p result has, and item @p position as JSON.
std::size_t part_size(const trace::Recording& result, std::size_t part) noexcept;
nlohmann::json part_item(const Instance& instance, const trace::Recording& result, std::size_t part,
                         std::size_t position);

/// The signals that are traced, and what the trace of @p instance does.
nlohmann::json traced_signals(const Instance& instance);
nlohmann::json trace_status(const Instance& instance);

}  // namespace axisd
