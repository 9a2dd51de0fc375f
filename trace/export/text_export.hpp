#pragma once

#include <string>

#include "trace/export/result.hpp"

namespace trace {

/// A line a sample: the time since the start of the unit, that since the trigger if there was one, and the values;
/// the first line names them with their units.
std::string export_csv(const Result& result);

/// One JSON object: `signals`, `trigger_t`, `samples`, `frames`, `events` as `trace.read` has them.
std::string export_json(const Result& result);

}  // namespace trace
