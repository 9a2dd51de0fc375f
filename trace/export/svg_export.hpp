#pragma once

#include <string>

#include "trace/export/result.hpp"

namespace trace {

/// The result as an SVG picture: a lane for each unit with a colour and a name a signal, lanes for events and
/// frames below them, one time axis with its zero at the trigger.
std::string export_svg(const Result& result);

}  // namespace trace
